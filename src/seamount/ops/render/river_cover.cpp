#include "seamount/ops/render/river_cover.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/error.h"
#include "seamount/geom/scalar/segment.h"

namespace seamount::render {
namespace {

double number(const Attributes& attributes, std::string_view name, double otherwise) {
  for (const Attribute& one : attributes)
    if (one.name == name) return one.value;
  return otherwise;
}

double width_of(const ValuedLine& line) {
  const double order = std::clamp(number(line.attributes, "order", line.value), 1.0, 12.0);
  return std::clamp(number(line.attributes, "width_m", 3.0 * std::pow(1.7, order - 1.0)), 0.0, 1e5);
}

/// Covers the cells near a segment, by how far their middles are from it.
void cover_segment(ScalarField& cover, Vec2 a, Vec2 b, double width) {
  const GridFrame& frame = cover.frame();
  const double reach = 0.5 * (width + frame.cell_m);
  const auto low = [](double place) { return static_cast<int>(std::clamp(std::ceil(place), 0.0, 1e9)); };
  const auto high = [](double place, int count) {
    return static_cast<int>(std::clamp(std::floor(place), -1.0, count - 1.0));
  };
  const int x0 = low(frame.column(std::min(a.x, b.x) - reach)), y0 = low(frame.row(std::max(a.y, b.y) + reach));
  const int x1 = high(frame.column(std::max(a.x, b.x) + reach), frame.width),
            y1 = high(frame.row(std::min(a.y, b.y) - reach), frame.height);
  // A line narrower than a cell covers no more of it than its width over the cell's.
  const double most = std::min(1.0, width / frame.cell_m);
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      const double away = std::sqrt(geom::squared_distance_to_segment({frame.x(x), frame.y(y)}, a, b));
      const double share = std::clamp((reach - away) / std::min(width, frame.cell_m), 0.0, 1.0) * most;
      cover(x, y) = std::max(cover(x, y), static_cast<float>(share));
    }
  }
}

}  // namespace

ScalarField river_cover(const Drawing& rivers, const GridFrame& frame, const RunContext& run) {
  if (!rivers.crs.empty() && !frame.crs.empty() && rivers.crs != frame.crs)
    throw IncompatibleInputs("the terrain and the rivers over it are in different coordinate systems");
  ScalarField cover(frame, 0.0F);
  for (const ValuedLine& line : rivers.lines) {
    run.check_cancelled();
    const double width = width_of(line);
    if (!(width > 0.0)) continue;
    for (size_t i = 1; i < line.points.size(); ++i) cover_segment(cover, line.points[i - 1], line.points[i], width);
  }
  return cover;
}

}  // namespace seamount::render
