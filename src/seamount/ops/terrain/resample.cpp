#include "seamount/ops/terrain/resample.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/model/extent.h"

namespace seamount::terrain {
namespace {

constexpr double kMostCellsASide = 65536;
constexpr double kMostCells = 1 << 30;

/// A frame's own extent in cells of another size, with the same middle.
GridFrame recelled(const GridFrame& frame, double cell_m) {
  const double width = std::max(1.0, std::round(frame.width_m() / cell_m));
  const double height = std::max(1.0, std::round(frame.height_m() / cell_m));
  if (width > kMostCellsASide || height > kMostCellsASide || width * height > kMostCells) {
    throw InvalidArgument("cell_m", format_number(cell_m) + " m makes " + format_number(width) + " x " +
                                        format_number(height) + " cells; at most 65536 a side and 2^30 in all");
  }
  GridFrame out = frame;
  out.width = static_cast<int>(width);
  out.height = static_cast<int>(height);
  out.cell_m = cell_m;
  out.west_m = frame.west_m + 0.5 * (frame.width_m() - out.width_m());
  out.north_m = frame.north_m - 0.5 * (frame.height_m() - out.height_m());
  return out;
}

}  // namespace

int64_t forget_beyond(HeightField& out, const GridFrame& source) {
  const GridFrame& frame = out.frame();
  constexpr double kRounding = 1e-6;  // of a cell
  const double x0 = source.west_m - kRounding * source.cell_m, x1 = source.east_m() + kRounding * source.cell_m;
  const double y0 = source.south_m() - kRounding * source.cell_m, y1 = source.north_m + kRounding * source.cell_m;
  int64_t beyond = 0;
  for (int y = 0; y < frame.height; ++y) {
    const bool row_inside = frame.y(y) >= y0 && frame.y(y) <= y1;
    for (int x = 0; x < frame.width; ++x) {
      if (row_inside && frame.x(x) >= x0 && frame.x(x) <= x1) continue;
      out(x, y) = std::numeric_limits<float>::quiet_NaN();
      ++beyond;
    }
  }
  return beyond;
}

void judge_beyond(int64_t beyond, const GridFrame& frame, const GridFrame& source, const RunContext& run) {
  if (beyond == frame.cells())
    throw IncompatibleInputs("terrain: none of the domain lies on it: it covers " + extent_text(Extent::of(source)) +
                             ", the domain " + extent_text(Extent::of(frame)));
  if (beyond > 0)
    run.say(std::to_string(beyond) + " of " + std::to_string(frame.cells()) +
            " cells lie beyond the terrain and have no height (\"beyond\": \"edge\" lets it go on)");
}

ResampleFrames resample_frames(const GridFrame& terrain, const ResampleParams& params, const GridFrame& domain) {
  GridFrame source = terrain, target = domain;
  const double middle_x = source.west_m + 0.5 * source.width_m(), middle_y = source.north_m - 0.5 * source.height_m();
  source.cell_m *= params.scale;
  source.west_m = middle_x - 0.5 * source.width_m();
  source.north_m = middle_y + 0.5 * source.height_m();
  if (params.cell_m) {
    target = recelled(source, *params.cell_m);
  } else if (params.centre) {
    source.west_m = domain.west_m + 0.5 * (domain.width_m() - source.width_m());
    source.north_m = domain.north_m - 0.5 * (domain.height_m() - source.height_m());
  }
  return {source, target};
}

Reach resample_reach(const ResampleParams& params) {
  if (params.cell_m) return Reach::everything("cell_m makes a raster of another size");
  if (params.centre)
    return Reach::everything("it is put into the domain's middle; with centre false it lies where it lies");
  if (params.beyond == Beyond::unknown)
    return Reach::everything("what lies beyond the terrain is counted; beyond edge lets it go on");
  return Reach::place();
}

HeightField resample(const HeightField& terrain, const ResampleParams& params, const GridFrame& domain,
                     const RunContext& run) {
  check_params(params);
  if (terrain.empty()) throw InvalidArgument("terrain", "has no cells");
  run.check_cancelled();
  const auto [source, target] = resample_frames(terrain.frame(), params, domain);
  const bool in_domain = !params.cell_m && params.beyond == Beyond::unknown;
  if (params.scale == 1.0 && source == terrain.frame()) {
    HeightField out = geom::resample(terrain, target, run);
    if (in_domain) judge_beyond(forget_beyond(out, source), target, source, run);
    return out;
  }
  HeightField moved = terrain;
  moved.set_frame(source);
  if (params.scale != 1.0) {
    parallel_rows(run.part(0.0, 0.2), moved.width(), moved.height(), [&](int begin, int end) {
      for (int y = begin; y < end; ++y) {
        for (float& z : moved.row(y)) z = static_cast<float>(params.scale * z);
      }
    });
  }
  HeightField out = geom::resample(moved, target, run.part(0.2, 1.0));
  if (in_domain) judge_beyond(forget_beyond(out, source), target, source, run);
  return out;
}

}  // namespace seamount::terrain
