#include "seamount/ops/terrain/resample.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/resample.h"

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

HeightField resample(const HeightField& terrain, const ResampleParams& params, const GridFrame& domain,
                     const RunContext& run) {
  check_params(params);
  if (terrain.empty()) throw InvalidArgument("terrain", "has no cells");
  run.check_cancelled();
  GridFrame source = terrain.frame();
  const double middle_x = source.west_m + 0.5 * source.width_m(), middle_y = source.north_m - 0.5 * source.height_m();
  source.cell_m *= params.scale;
  source.west_m = middle_x - 0.5 * source.width_m();
  source.north_m = middle_y + 0.5 * source.height_m();
  GridFrame target = domain;
  if (params.cell_m) {
    target = recelled(source, *params.cell_m);
  } else if (params.centre) {
    source.west_m = domain.west_m + 0.5 * (domain.width_m() - source.width_m());
    source.north_m = domain.north_m - 0.5 * (domain.height_m() - source.height_m());
  }
  if (params.scale == 1.0 && source == terrain.frame()) return geom::resample(terrain, target, run);
  HeightField moved = terrain;
  moved.set_frame(source);
  if (params.scale != 1.0) {
    parallel_rows(run.part(0.0, 0.2), moved.width(), moved.height(), [&](int begin, int end) {
      for (int y = begin; y < end; ++y) {
        for (float& z : moved.row(y)) z = static_cast<float>(params.scale * z);
      }
    });
  }
  return geom::resample(moved, target, run.part(0.2, 1.0));
}

}  // namespace seamount::terrain
