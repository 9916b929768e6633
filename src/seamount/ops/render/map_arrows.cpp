#include "seamount/ops/render/map_arrows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "seamount/base/text.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/ops/render/canvas.h"

namespace seamount::render {
namespace {

constexpr Colour kArrow{252, 253, 255}, kHalo{14, 42, 78};  // seen on deep and on shallow water

/// A shaft and the two strokes of its head, in pixels.
struct Arrow {
  Vec2 tail, tip, left, right;
};

Arrow make_arrow(Vec2 middle, Vec2 direction, double length) {
  const Vec2 side{-direction.y, direction.x};
  const double head = 0.34 * length;
  Arrow arrow;
  arrow.tail = middle - (0.5 * length) * direction;
  arrow.tip = middle + (0.5 * length) * direction;
  arrow.left = arrow.tip - head * direction + (0.55 * head) * side;
  arrow.right = arrow.tip - head * direction - (0.55 * head) * side;
  return arrow;
}

void add_arrow(LineLayer& layer, const Arrow& arrow, double width) {
  layer.add({arrow.tail, arrow.tip}, width);
  layer.add({arrow.left, arrow.tip, arrow.right}, width);
}

/// Mean over a square of `half` metres on each side.
Vec2 mean_around(const VectorField& current, Vec2 place, double half) {
  constexpr std::array<double, 3> kOffsets = {-0.6, 0.0, 0.6};
  const GridFrame& frame = current.frame();
  Vec2 sum;
  for (const double dy : kOffsets) {
    for (const double dx : kOffsets) {
      const double column = frame.column(place.x + dx * half), row = frame.row(place.y + dy * half);
      sum = sum + Vec2{geom::sample_bilinear(current.x, column, row), geom::sample_bilinear(current.y, column, row)};
    }
  }
  return (1.0 / 9.0) * sum;
}

double round_up_nice(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 1.5, 2.0, 3.0, 5.0, 8.0})
    if (step * power >= value * (1.0 - 1e-9)) return step * power;
  return 10.0 * power;
}

}  // namespace

ArrowScale arrow_scale(const VectorField& current, double spacing_px) {
  std::vector<float> speeds(current.x.size());
  for (size_t i = 0; i < speeds.size(); ++i) speeds[i] = std::hypot(current.x.cells()[i], current.y.cells()[i]);
  const auto place = speeds.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(speeds.size() - 1));
  std::nth_element(speeds.begin(), place, speeds.end());
  double usual = static_cast<double>(*place);
  if (!(usual > 0.0)) usual = static_cast<double>(*std::max_element(speeds.begin(), speeds.end()));
  return {spacing_px, usual > 0.0 ? round_up_nice(usual) : 1.0};
}

void draw_arrows(Image& image, const Box& box, const VectorField& current, const ArrowScale& scale, double unit,
                 const RunContext& run) {
  const GridFrame& frame = current.frame();
  const double pixel_m = frame.width_m() / box.width, spacing = scale.spacing_px;
  const double width = std::max(0.9, 0.085 * unit);
  LineLayer arrows(box.width, box.height), halo(arrows);
  int number = 0;
  for (double y = 0.5 * spacing; y < box.height; y += 0.87 * spacing, ++number) {
    run.check_cancelled();
    for (double x = (number % 2 == 0 ? 0.5 : 1.0) * spacing; x < box.width; x += spacing) {
      const Vec2 flow =
          mean_around(current, {frame.west_m + x * pixel_m, frame.north_m - y * pixel_m}, 0.5 * spacing * pixel_m);
      const double speed = std::sqrt(dot(flow, flow));
      if (speed < 0.05 * scale.full_m_s) continue;
      const double length = spacing * std::clamp(speed / scale.full_m_s, 0.12, 1.0);
      const Arrow arrow = make_arrow({x, y}, (1.0 / speed) * Vec2{flow.x, -flow.y}, 0.92 * length);
      add_arrow(arrows, arrow, width);
      add_arrow(halo, arrow, width + std::max(1.2, 0.11 * unit));
    }
  }
  halo.draw(image, box.x, box.y, kHalo, 0.5F);
  arrows.draw(image, box.x, box.y, kArrow, 0.95F);
}

void draw_arrow_key(Image& image, const Font& font, double right, double y, const ArrowScale& scale, double unit) {
  const std::string text = format_number(scale.full_m_s) + " m/s";
  const double length = 0.92 * scale.spacing_px, gap = 0.5 * unit,
               start = right - font.width(text, unit) - gap - length;
  if (start < 0.0) return;
  LineLayer layer(image.width, image.height);
  add_arrow(layer, make_arrow({start + 0.5 * length, y}, {1.0, 0.0}, length), std::max(0.9, 0.085 * unit));
  layer.draw(image, 0, 0, kHalo, 0.95F);
  font.draw(image, right - font.width(text, unit), y + 0.36 * unit, unit, text, kInk);
}

}  // namespace seamount::render
