#include "seamount/ops/learned/sketch.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/grid/pyramid_fill.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/solve/continue_surface.h"
#include "seamount/geom/solve/drain.h"
#include "seamount/ops/learned/plane_math.h"
#include "seamount/ops/learned/sketch_level.h"
#include "seamount/ops/learned/sketch_map.h"
#include "seamount/ops/learned/sketch_planes.h"

namespace seamount::learned {
namespace {

constexpr float kLineDepth = 0.015F;  ///< of the relief, by which lines are deepened and sharpened
constexpr float kLineCells = 1.7F;    ///< deviation of that across them
constexpr float kLast = 3e-4F;        ///< of their profile, below which it is 0
constexpr double kGuideCells = 16.0;  ///< wide cells that a line of the guide drains
constexpr float kHollow = 0.012F;     ///< of the relief: hollows no deeper are opened

/// Takes the residual at known ground (all of it) and drawn heights (a share) away, spread over what is near.
void meet_heights(const SketchMap& map, double adherence, HeightField& heights, const RunContext& run) {
  const bool known = !map.known_m.empty(), cues = !map.cue.empty() && adherence > 0;
  if (!known && !cues) return;
  ScalarField residual(map.frame);
  Grid<float> weight(map.frame);
  parallel_rows(run, map.frame.width, map.frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < map.frame.width; ++x) {
        residual(x, y) = weight(x, y) = 0;
        if (known && !std::isnan(map.known_m(x, y))) {
          residual(x, y) = map.known_m(x, y) - heights(x, y);
        } else if (cues && map.cue(x, y) != 0) {
          residual(x, y) = static_cast<float>(adherence) * (map.cue_m(x, y) - heights(x, y));
        } else {
          continue;
        }
        weight(x, y) = 1;
      }
    }
  });
  geom::pyramid_fill(residual, std::move(weight), {.prior = 0.0F, .fade = 0.7F}, run);
  parallel_rows(run, map.frame.width, map.frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < map.frame.width; ++x) {
        const bool stays = known && !std::isnan(map.known_m(x, y));
        heights(x, y) = stays ? map.known_m(x, y) : heights(x, y) + residual(x, y);
      }
    }
  });
}

/// Adds a profile across lines from which a row lies `distance` cells away.
SEAMOUNT_VECTORISED void add_profile(const float* distance, int width, float by, float* heights) {
  for (int x = 0; x < width; ++x) {
    const float d = distance[x] / kLineCells;
    heights[x] += by * std::max(0.0F, fast_exp(-0.5F * d * d) - kLast);
  }
}

/// Deepens drawn rivers and sharpens drawn crests a little, so that water takes and leaves them. Distances in cells.
void meet_lines(const ScalarField& from_river, const ScalarField& from_ridge, float depth, HeightField& heights,
                const RunContext& run) {
  if (!(depth > 0)) return;
  for (const ScalarField* distance : {&from_river, &from_ridge}) {
    if (distance->empty()) continue;
    const float by = distance == &from_river ? -depth : depth;
    parallel_rows(run, heights.width(), heights.height(), [&](int begin, int end) {
      for (int y = begin; y < end; ++y)
        add_profile(distance->row(y).data(), heights.width(), by, heights.row(y).data());
    });
  }
}

/// The same, of a map whose distances are not known.
void meet_lines(const SketchMap& map, float depth, HeightField& heights, const RunContext& run) {
  const auto from = [&](const Grid<uint8_t>& lines) {
    if (lines.empty()) return ScalarField();
    Grid<uint8_t> cells = lines;
    GridFrame frame = map.frame;
    frame.cell_m = 1;
    cells.set_frame(frame);
    return geom::distance_to(cells, run);
  };
  meet_lines(from(map.river), from(map.ridge), depth, heights, run);
}

/// Opens hollows that are shallow for the relief, but for those of known ground and of drawn heights: water runs off.
void open_hollows(const SketchMap& map, HeightField& heights, const RunContext& run) {
  const auto stays = [&](int x, int y) { return !map.known_m.empty() && !std::isnan(map.known_m(x, y)); };
  std::vector<int64_t> sinks = geom::find_sinks(heights, run);
  std::erase_if(sinks, [&](int64_t sink) {
    const auto x = static_cast<int>(sink % map.frame.width), y = static_cast<int>(sink / map.frame.width);
    bool meant = stays(x, y);
    for (int v = y - 1; v <= y + 1 && !meant && !map.cue.empty(); ++v)
      for (int u = x - 1; u <= x + 1 && !meant; ++u) meant = map.cue.contains(u, v) && map.cue(u, v) != 0;
    return meant;
  });
  geom::drain_shallow(heights, sinks, kHollow * static_cast<float>(map.relief_m), run);
  if (map.known_m.empty()) return;
  for (size_t i = 0; i < heights.size(); ++i) {
    if (!std::isnan(map.known_m.data()[i])) heights.data()[i] = map.known_m.data()[i];
  }
}

/// Terrain of a map; `seen` is what the network sees of it, with lines that nobody drew in wide gaps.
HeightField make(const SketchMap& map, const SketchMap& seen, double adherence, const Network& network, Seed seed,
                 const RunContext& run) {
  const SketchPlanes planes(seen, seed, run);
  HeightField heights = network.evaluate(planes.planes(), map.frame, run);
  const auto low = static_cast<float>(map.low_m), relief = static_cast<float>(map.relief_m);
  parallel_rows(run, map.frame.width, map.frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < map.frame.width; ++x) heights(x, y) = low + relief * (planes.base()(x, y) + heights(x, y));
    }
  });
  meet_level(map, adherence, heights, run);
  const float depth = kLineDepth * static_cast<float>(adherence * map.relief_m);
  if (&map == &seen) {
    meet_lines(planes.from_river(), planes.from_ridge(), depth, heights, run);
  } else {
    meet_lines(map, depth, heights, run);
  }
  meet_heights(map, adherence, heights, run);
  return heights;
}

HeightField make_guided(const SketchMap& map, const Redraw& redraw, double adherence, const Network& network, Seed seed,
                        const RunContext& run) {
  const auto distance = redraw ? distance_in_gaps(map, run) : std::nullopt;
  if (!distance) return make(map, map, adherence, network, seed, run);
  const SketchMap wide = coarser(map);
  const HeightField rough = make_guided(wide, redraw, adherence, network, seed.derive("rough"), run);
  GridFrame half = wide.frame;  // lines are smoother on finer cells
  half.cell_m /= 2;
  half.width *= 2;
  half.height *= 2;
  SketchMap seen = map;
  const double least_m2 = kGuideCells * wide.frame.cell_m * wide.frame.cell_m;
  add_guide(redraw(geom::resample(rough, half, run), least_m2, seed.derive("redraw"), run), *distance, seen);
  return make(map, seen, adherence, network, seed, run);
}

}  // namespace

HeightField sketch(const SketchInputs& inputs, const SketchParams& params, const Network& network,
                   const GridFrame& frame, Seed seed, const RunContext& run) {
  check_params(params);
  if (network.architecture().planes != kSketchPlanes)
    throw InvalidArgument("model", "is a network of " + std::to_string(network.architecture().planes) +
                                       " planes, and a sketch has " + std::to_string(kSketchPlanes));
  const SketchMap map = map_of(inputs, params, frame, run);
  HeightField heights = make_guided(map, inputs.redraw, params.adherence, network, seed, run);
  if (!map.known_m.empty()) {
    geom::continue_surface(map.known_m, {}, heights, run);
    if (!map.cue.empty()) meet_heights(map, params.adherence, heights, run);  // those beside the rim
  }
  open_hollows(map, heights, run);
  return heights;
}

}  // namespace seamount::learned
