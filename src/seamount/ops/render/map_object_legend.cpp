#include "seamount/ops/render/map_object_legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "seamount/ops/render/canvas.h"

namespace seamount::render {
namespace {

constexpr int kMostRows = 24;
// In units: the size of text, height of a row, around the rows, room for a sign, between name and number, after that.
constexpr double kText = 0.92, kRow = 1.5, kPadding = 0.7, kSign = 2.3, kGap = 0.9, kColumnGap = 1.8, kLongest = 16.0;
constexpr Colour kNumber{104, 106, 110};

std::string shown_name(const ObjectClass& of_class) {
  std::string name = of_class.name;
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::string number_text(const ShownClass& shown) { return fmt::format("{}", shown.objects.size()); }

/// The text, or as much of its beginning as fits, with an ellipsis.
std::string cut_short(const Font& font, std::string text, double size, double width) {
  if (font.width(text, size) <= width) return text;
  text.resize(std::min(text.size(), size_t{256}));
  const auto continues = [&] { return !text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U; };
  while (!text.empty() && font.width(text + "…", size) > width) {
    while (continues()) text.pop_back();
    if (!text.empty()) text.pop_back();
  }
  return text + "…";
}

}  // namespace

ObjectLegend lay_out_object_legend(const Font& font, std::span<const ShownClass> shown, double width, double unit) {
  ObjectLegend legend;
  double number = 0.0;
  for (const ShownClass& one : shown) {
    legend.name = std::max(legend.name, font.width(shown_name(*one.of_class), kText * unit));
    number = std::max(number, font.width(number_text(one), kText * unit));
  }
  const double inner = width - 2.0 * kPadding * unit, beside = (kSign + kGap) * unit + number;
  legend.name = std::clamp(legend.name, 0.0, std::max(0.0, std::min(kLongest * unit, inner - beside)));
  legend.column = legend.name + beside;
  const double step = legend.column + kColumnGap * unit;
  const int most = std::max(1, static_cast<int>((inner + kColumnGap * unit) / step));
  const auto count = static_cast<int>(std::min(shown.size(), static_cast<size_t>(most) * kMostRows));
  legend.rows = (count + most - 1) / most;
  legend.columns = (count + legend.rows - 1) / legend.rows;
  legend.entries = static_cast<size_t>(count) < shown.size() ? static_cast<size_t>(count) - 1 : shown.size();
  legend.width = std::min(width, legend.columns * step + (2.0 * kPadding - kColumnGap) * unit);
  legend.height = (legend.rows * kRow + 2.0 * kPadding) * unit;
  return legend;
}

void draw_object_legend(Image& image, const Font& font, const Box& box, std::span<const ShownClass> shown,
                        const ObjectLegend& legend, double unit) {
  const double size = kText * unit;
  frame_box(image, box.x, box.y, box.x + box.width, box.y + box.height, std::max(1.0, 0.06 * unit), kInk);
  const auto place = [&](size_t entry) {
    const auto rows = static_cast<size_t>(legend.rows), column = entry / rows, row = entry % rows;
    return Vec2{box.x + kPadding * unit + static_cast<double>(column) * (legend.column + kColumnGap * unit),
                box.y + (kPadding + kRow * (static_cast<double>(row) + 0.5)) * unit};
  };
  for (size_t i = 0; i < legend.entries; ++i) {
    const Vec2 at = place(i);
    const double baseline = at.y + 0.34 * unit;
    draw_class_sign(image, at + Vec2{0.9 * unit, 0.0}, shown[i], unit);
    font.draw(image, at.x + kSign * unit, baseline, size,
              cut_short(font, shown_name(*shown[i].of_class), size, legend.name), kInk);
    font.draw(image, at.x + legend.column, baseline, size, number_text(shown[i]), kNumber, Anchor::right);
  }
  if (legend.entries == shown.size()) return;
  const Vec2 at = place(legend.entries);
  font.draw(
      image, at.x + kSign * unit, at.y + 0.34 * unit, size,
      cut_short(font, fmt::format("and {} more", shown.size() - legend.entries), size, legend.column - kSign * unit),
      kInk);
}

}  // namespace seamount::render
