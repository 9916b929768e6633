#include "seamount/ops/terrain/samples.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/text.h"
#include "seamount/geom/grid/resample.h"

namespace seamount::terrain {
namespace {

int natural_size(int side, const std::vector<int>& sizes) {
  if (sizes.empty()) return side;
  int best = *std::min_element(sizes.begin(), sizes.end());
  for (const int size : sizes) {
    if (size <= side + 1) best = std::max(best, size);  // 2049 samples for 2048 cells
  }
  return best;
}

void check_two(int size, int side) {
  if (size < 2 || side < 2) throw InvalidArgument("samples", "at least two samples a side are needed");
}

/// The terrain on a larger frame of the same cells: what is added repeats its edge.
HeightField padded(const HeightField& terrain, const GridFrame& frame) {
  const auto west = static_cast<int>(std::lround(frame.column(terrain.frame().x(0))));
  const auto north = static_cast<int>(std::lround(frame.row(terrain.frame().y(0))));
  HeightField grown(frame);
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) grown(x, y) = terrain.clamped(x - west, y - north);
  return grown;
}

/// The frame with cells added at all sides.
GridFrame grown(GridFrame frame, int west, int north, int east, int south) {
  frame.west_m -= west * frame.cell_m;
  frame.north_m += north * frame.cell_m;
  frame.width += west + east;
  frame.height += north + south;
  return frame;
}

/// The smallest square around a frame; where it cannot be centred, the odd cell is in the east or south.
GridFrame square_around(const GridFrame& frame) {
  const int side = std::max(frame.width, frame.height);
  const int columns = side - frame.width, rows = side - frame.height;
  return grown(frame, columns / 2, rows / 2, columns - columns / 2, rows - rows / 2);
}

/// What is missing of the terrain between outer samples, or was added, on its way from `from` to `to`, in metres; and
/// how much coarser it is.
void tell_difference(const GridFrame& from, const GridFrame& to, const RunContext& run) {
  std::string cut, added;
  const auto side = [&](const char* name, double gained_m) {
    gained_m = std::round(gained_m * 100) / 100;
    if (gained_m == 0) return;
    std::string& list = gained_m < 0 ? cut : added;
    list += (list.empty() ? "" : ", ") + format_number(std::abs(gained_m)) + " m in the " + name;
  };
  side("west", from.x(0) - to.x(0));
  side("east", to.x(to.width - 1) - from.x(from.width - 1));
  side("north", to.y(0) - from.y(0));
  side("south", from.y(from.height - 1) - to.y(to.height - 1));
  if (!cut.empty()) run.say("cut off to fit: " + cut);
  if (!added.empty()) run.say("added to fit, as high as the terrain's edge: " + added);
  const auto shown = [](double metres) { return format_number(std::round(metres * 1e4) / 1e4); };
  if (to.cell_m > from.cell_m * (1 + 1e-6))
    run.say("cells of " + shown(to.cell_m) + " m instead of " + shown(from.cell_m) + " m: finer detail is averaged");
}

}  // namespace

GridFrame square_frame(const GridFrame& source, int size) {
  const int side = std::min(source.width, source.height);
  check_two(size, side);
  GridFrame frame = source;
  frame.width = frame.height = size;
  frame.cell_m = source.cell_m * (side - 1) / (size - 1);
  const double west = source.x(0.5 * (source.width - side)), north = source.y(0.5 * (source.height - side));
  frame.west_m = west - 0.5 * frame.cell_m;
  frame.north_m = north + 0.5 * frame.cell_m;
  return frame;
}

GridFrame whole_frame(const GridFrame& source, int size) {
  const int longer = std::max(source.width, source.height), shorter = std::min(source.width, source.height);
  check_two(size, shorter);
  if (size == longer) return source;
  GridFrame frame = source;
  frame.cell_m = source.cell_m * (longer - 1) / (size - 1);
  const auto cells = static_cast<int>(std::ceil(source.cell_m * (shorter - 1) / frame.cell_m - 1e-6));
  frame.width = source.width == longer ? size : cells + 1;
  frame.height = source.width == longer ? cells + 1 : size;
  if (source.width == source.height) frame.height = size;
  frame.west_m = source.x(0) - 0.5 * frame.cell_m;
  frame.north_m = source.y(0) + 0.5 * frame.cell_m;
  return frame;
}

GridFrame tiled_frame(const GridFrame& source, int tile_size) {
  const int step = tile_size - 1;
  const auto missing = [step](int samples) { return std::max(1, (samples - 2 + step) / step) * step + 1 - samples; };
  return grown(source, 0, 0, missing(source.width), missing(source.height));
}

GridFrame samples_frame(const GridFrame& source, const SamplesParams& params) {
  const bool square = params.layout == SampleLayout::square;
  const GridFrame frame = square && params.fit == SquareFit::pad ? square_around(source) : source;
  const int side = square ? std::min(frame.width, frame.height) : std::max(frame.width, frame.height);
  const int size = params.samples > 0 ? params.samples : natural_size(side, params.choices);
  return square ? square_frame(frame, size) : whole_frame(frame, size);
}

HeightField samples(const HeightField& terrain, const SamplesParams& params, const RunContext& run) {
  check_params(params);
  const GridFrame& frame = terrain.frame();
  if (frame.cells() == 0) throw InvalidArgument("samples", "there is no terrain");
  if (params.layout == SampleLayout::tiles) {
    const int size =
        params.samples > 0 ? params.samples : natural_size(std::min(frame.width, frame.height), params.choices);
    check_two(size, 2);
    const GridFrame tiled = tiled_frame(frame, size);
    tell_difference(frame, tiled, run);
    return tiled == frame ? terrain : padded(terrain, tiled);
  }
  const bool square = params.layout == SampleLayout::square, pad = square && params.fit == SquareFit::pad;
  if (pad && frame.width != frame.height) {
    SamplesParams of_square = params;
    of_square.fit = SquareFit::crop;
    const GridFrame around = square_around(frame);
    tell_difference(frame, around, run);
    return samples(padded(terrain, around), of_square, run);
  }
  const GridFrame wanted = samples_frame(frame, params);
  run.check_cancelled();
  tell_difference(frame, wanted, run);
  if (wanted == frame) return terrain;
  if (square) return geom::resample(terrain, wanted, run);
  // The last row or column may lie up to one cell beyond the terrain.
  const auto beyond = static_cast<int>(std::ceil(wanted.cell_m / frame.cell_m)) + 1;
  return geom::resample(padded(terrain, grown(frame, 0, 0, beyond, beyond)), wanted, run);
}

}  // namespace seamount::terrain
