#include "seamount/ops/terrain/samples.h"

#include <algorithm>
#include <cmath>

#include "seamount/geom/grid/resample.h"

namespace seamount::terrain {
namespace {

int natural_size(const GridFrame& frame, const std::vector<int>& sizes) {
  const int side = std::min(frame.width, frame.height);
  if (sizes.empty()) return side;
  int best = *std::min_element(sizes.begin(), sizes.end());
  for (const int size : sizes) {
    if (size <= side + 1) best = std::max(best, size);  // 2049 samples for 2048 cells
  }
  return best;
}

}  // namespace

GridFrame square_frame(const GridFrame& source, int size) {
  const int side = std::min(source.width, source.height);
  if (size < 2 || side < 2) throw InvalidArgument("samples", "at least two samples a side are needed");
  GridFrame frame = source;
  frame.width = frame.height = size;
  frame.cell_m = source.cell_m * (side - 1) / (size - 1);
  const double west = source.x(0.5 * (source.width - side)), north = source.y(0.5 * (source.height - side));
  frame.west_m = west - 0.5 * frame.cell_m;
  frame.north_m = north + 0.5 * frame.cell_m;
  return frame;
}

GridFrame tiled_frame(const GridFrame& source, int tile_size) {
  const int step = tile_size - 1;
  if ((source.width - 1) % step == 0 && (source.height - 1) % step == 0) return source;
  const int side = std::max(1, static_cast<int>(std::lround(static_cast<double>(source.width) / step)));
  GridFrame tiled = source;
  const double span = source.cell_m * (source.width - 1);
  tiled.width = side * step + 1;
  tiled.cell_m = span / (tiled.width - 1);
  const int rows =
      std::max(1, static_cast<int>(std::floor((source.height - 1) * source.cell_m / (step * tiled.cell_m) + 1e-6)));
  tiled.height = rows * step + 1;
  tiled.west_m = source.x(0) - 0.5 * tiled.cell_m;
  tiled.north_m = source.y(0) + 0.5 * tiled.cell_m;
  return tiled;
}

HeightField samples(const HeightField& terrain, const SamplesParams& params, const RunContext& run) {
  check_params(params);
  const GridFrame& frame = terrain.frame();
  const int size = params.samples > 0 ? params.samples : natural_size(frame, params.choices);
  if (params.layout == SampleLayout::tiles && size < 2)
    throw InvalidArgument("samples", "at least two samples a side are needed");
  const GridFrame wanted = params.layout == SampleLayout::tiles ? tiled_frame(frame, size) : square_frame(frame, size);
  run.check_cancelled();
  return wanted == frame ? terrain : geom::resample(terrain, wanted, run);
}

}  // namespace seamount::terrain
