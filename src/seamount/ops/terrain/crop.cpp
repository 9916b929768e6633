#include "seamount/ops/terrain/crop.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/model/drawn.h"
#include "seamount/model/extent.h"

namespace seamount::terrain {
namespace {

/// The middle of the highest cell, or of the lowest where `sign` is -1.
Vec2 extreme_place(const HeightField& terrain, float sign) {
  float best = -std::numeric_limits<float>::infinity();
  Vec2 place{terrain.frame().x(0), terrain.frame().y(0)};
  for (int y = 0; y < terrain.height(); ++y) {
    for (int x = 0; x < terrain.width(); ++x) {
      if (!(sign * terrain(x, y) > best)) continue;  // unknown cells never are
      best = sign * terrain(x, y);
      place = {terrain.frame().x(x), terrain.frame().y(y)};
    }
  }
  return place;
}

Vec2 middle_of(const GridFrame& frame, const CropParams& params, Vec2 extreme) {
  if (params.x_m) return {*params.x_m, *params.y_m};
  if (params.around == Around::middle)
    return {frame.west_m + 0.5 * frame.width_m(), frame.north_m - 0.5 * frame.height_m()};
  return extreme;
}

/// Cells from first to last, both included, of `count` whose middles lie within `half` of a fractional cell.
struct Span {
  int64_t first, last;
};

Span span_around(double cell, double half) {
  constexpr double kRounding = 1e-9;
  auto first = static_cast<int64_t>(std::ceil(cell - half - kRounding)),
       last = static_cast<int64_t>(std::floor(cell + half - kRounding));
  if (last < first) first = last = std::llround(cell);
  return {first, last};
}

}  // namespace

CropCells crop_cells(const GridFrame& frame, const CropParams& params, Vec2 extreme, const RunContext& run) {
  check_params(params);
  if (params.x_m.has_value() != params.y_m.has_value())
    throw InvalidArgument(params.x_m ? "y_m" : "x_m", "is missing: a place has both");
  const Vec2 middle = middle_of(frame, params, extreme);
  const double height_m = params.height_m.value_or(params.width_m);
  const Span columns = span_around(frame.column(middle.x), 0.5 * params.width_m / frame.cell_m),
             rows = span_around(frame.row(middle.y), 0.5 * height_m / frame.cell_m);
  const auto x0 = static_cast<int>(std::max<int64_t>(0, columns.first)),
             x1 = static_cast<int>(std::min<int64_t>(frame.width - 1, columns.last)),
             y0 = static_cast<int>(std::max<int64_t>(0, rows.first)),
             y1 = static_cast<int>(std::min<int64_t>(frame.height - 1, rows.last));
  if (x1 < x0 || y1 < y0)
    throw InvalidArgument("x_m", "the rectangle around " + metres_text(middle) +
                                     " lies beside the terrain, which covers " + extent_text(Extent::of(frame)));
  GridFrame part = frame;
  part.width = x1 - x0 + 1;
  part.height = y1 - y0 + 1;
  part.west_m = frame.west_m + x0 * frame.cell_m;
  part.north_m = frame.north_m - y0 * frame.cell_m;
  if (part.width < columns.last - columns.first + 1 || part.height < rows.last - rows.first + 1)
    run.say("the rectangle reaches beyond the terrain: " + format_number(part.width_m()) + " x " +
            format_number(part.height_m()) + " m of " + format_number(params.width_m) + " x " +
            format_number(height_m) + " m are there");
  return {x0, y0, part};
}

HeightField crop(const HeightField& terrain, const CropParams& params, const RunContext& run) {
  if (terrain.empty()) throw InvalidArgument("terrain", "has no cells");
  const Vec2 extreme =
      around_extreme(params) ? extreme_place(terrain, params.around == Around::highest ? 1.0F : -1.0F) : Vec2{};
  const CropCells cells = crop_cells(terrain.frame(), params, extreme, run);
  const GridFrame& part = cells.frame;
  HeightField out(part);
  for (int y = 0; y < part.height; ++y) {
    if (y % 256 == 0) run.check_cancelled();
    for (int x = 0; x < part.width; ++x) out(x, y) = terrain(cells.column + x, cells.row + y);
  }
  return out;
}

}  // namespace seamount::terrain
