#include "seamount/ops/render/contact_sheet.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/error.h"
#include "seamount/ops/render/text.h"

namespace seamount::render {
namespace {

constexpr int kGap = 12, kLine = 26;  // between cells; for a caption
constexpr int kWidest = 2400, kNarrowestCell = 160;
constexpr double kTextPx = 16, kSmallestTextPx = 9;
constexpr Colour kInk{40, 40, 40};

void add_share(const uint8_t* pixel, double share, double (&sum)[3]) {
  for (int c = 0; c < 3; ++c) sum[c] += share * pixel[c];
}

/// Each pixel is the mean of those that it covers, the fractions of them at its edges by their share.
Image smaller(const Image& from, int width, int height) {
  Image to(width, height);
  const double sx = static_cast<double>(from.width) / width, sy = static_cast<double>(from.height) / height;
  const auto share = [](int i, double low, double high) { return std::min(high, i + 1.0) - std::max(low, double(i)); };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double x0 = x * sx, x1 = std::min((x + 1) * sx, double(from.width));
      const double y0 = y * sy, y1 = std::min((y + 1) * sy, double(from.height));
      double sum[3] = {};
      for (int j = static_cast<int>(y0); j < y1 && j < from.height; ++j)
        for (int i = static_cast<int>(x0); i < x1 && i < from.width; ++i)
          add_share(from.pixel(i, j), share(i, x0, x1) * share(j, y0, y1), sum);
      for (int c = 0; c < 3; ++c)
        to.pixel(x, y)[c] = static_cast<uint8_t>(std::lround(sum[c] / ((x1 - x0) * (y1 - y0))));
    }
  }
  return to;
}

void lay(Image& sheet, const Image& picture, int x, int y) {
  for (int j = 0; j < picture.height; ++j) std::copy_n(picture.pixel(0, j), 3 * picture.width, sheet.pixel(x, y + j));
}

void write_caption(Image& sheet, const Font& font, std::string text, int x, int y, int width) {
  double size = kTextPx;
  const double wide = font.width(text, size);
  if (wide > width) size = std::max(kSmallestTextPx, size * width / wide);
  while (!text.empty() && font.width(text, size) > width) text.pop_back();
  font.draw(sheet, x + 0.5 * width, y + 0.7 * kLine, size, text, kInk, Anchor::middle);
}

}  // namespace

Image contact_sheet(const std::vector<SheetCell>& cells, int columns) {
  if (columns < 1) throw InvalidArgument("columns", "is below 1");
  int width = 0;
  for (const SheetCell& cell : cells) width = std::max(width, cell.picture.width);
  if (width == 0) throw IncompatibleInputs("there are no pictures for a sheet");
  columns = std::min(columns, static_cast<int>(cells.size()));
  width = std::min(width, std::max(kNarrowestCell, (kWidest - kGap) / columns - kGap));
  const auto height_of = [&](const Image& picture) {
    const int shown = std::min(picture.width, width);
    return std::max(1, static_cast<int>(std::lround(static_cast<double>(picture.height) * shown / picture.width)));
  };
  int height = 1;
  for (const SheetCell& cell : cells) height = std::max(height, height_of(cell.picture));
  const int rows = (static_cast<int>(cells.size()) + columns - 1) / columns;
  Image sheet(kGap + columns * (width + kGap), kGap + rows * (height + kLine + kGap), Colour{255, 255, 255});
  const Font font;
  for (size_t i = 0; i < cells.size(); ++i) {
    const Image& picture = cells[i].picture;
    const int at = static_cast<int>(i), shown = std::min(picture.width, width), tall = height_of(picture);
    const int x = kGap + at % columns * (width + kGap), y = kGap + at / columns * (height + kLine + kGap);
    lay(sheet, shown == picture.width ? picture : smaller(picture, shown, tall), x + (width - shown) / 2,
        y + height - tall);
    write_caption(sheet, font, cells[i].caption, x, y + height, width);
  }
  return sheet;
}

}  // namespace seamount::render
