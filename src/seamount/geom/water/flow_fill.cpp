#include <algorithm>
#include <cmath>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/water/flow.h"
#include "seamount/geom/water/flow_passes.h"
#include "seamount/geom/water/groups.h"

namespace seamount::geom {
namespace {

/// Kruskal: when a group of basins first meets the outside, the pass where it does is the water level of all of them.
std::vector<float> water_levels(const std::vector<Pass>& passes, int32_t count) {
  std::vector<float> levels(static_cast<size_t>(count), kNoSea);
  Groups groups(count);
  for (const Pass& pass : passes) {
    const int32_t a = groups.find(pass.a), b = groups.find(pass.b);
    if (a == b) continue;
    if (std::min(a, b) == kOutside) {
      groups.for_each_member(std::max(a, b), [&](int32_t basin) { levels[static_cast<size_t>(basin)] = pass.height; });
    }
    groups.join(a, b);
  }
  return levels;
}

/// The same for groups that are shallow where they meet a group with lower ground; the others keep kNoSea.
std::vector<float> shallow_levels(const HeightField& terrain, const Basins& basins, const std::vector<Pass>& passes,
                                  float min_depth_m) {
  std::vector<float> levels(static_cast<size_t>(basins.count()), kNoSea), lowest(levels.size(), kNoSea);
  for (size_t i = 1; i < lowest.size(); ++i) lowest[i] = terrain.data()[basins.pits[i]];
  Groups groups(basins.count());
  for (const Pass& pass : passes) {
    const int32_t a = groups.find(pass.a), b = groups.find(pass.b);
    if (a == b) continue;
    const auto low_of = [&](int32_t group) -> float& { return lowest[static_cast<size_t>(group)]; };
    const int32_t higher = low_of(a) > low_of(b) ? a : b;  // never the outside
    if (pass.height - low_of(higher) < min_depth_m) {
      groups.for_each_member(higher, [&](int32_t basin) { levels[static_cast<size_t>(basin)] = pass.height; });
    }
    const float low = std::min(low_of(a), low_of(b));
    groups.join(a, b);
    low_of(std::min(a, b)) = low;
  }
  return levels;
}

HeightField raise_to(const HeightField& terrain, const Basins& basins, const std::vector<float>& levels,
                     const RunContext& run) {
  HeightField filled = terrain;
  parallel_rows(run, terrain.width(), terrain.height(), [&](int begin, int end) {
    for (int64_t i = static_cast<int64_t>(begin) * terrain.width(); i < static_cast<int64_t>(end) * terrain.width();
         ++i) {
      const float level = levels[static_cast<size_t>(basins.of.data()[i])];
      if (filled.data()[i] < level) filled.data()[i] = level;
    }
  });
  return filled;
}

}  // namespace

HeightField fill_depressions(const HeightField& terrain, float sea_level_m, const RunContext& run) {
  const Basins basins = find_basins(flow_directions(terrain, sea_level_m, run.part(0.0, 0.3)), run.part(0.3, 0.6));
  if (basins.count() == 1) return terrain;
  const std::vector<float> levels = water_levels(find_passes(terrain, basins, run.part(0.6, 0.9)), basins.count());
  return raise_to(terrain, basins, levels, run.part(0.9, 1.0));
}

HeightField fill_shallow_depressions(const HeightField& terrain, float sea_level_m, float min_depth_m,
                                     const RunContext& run) {
  const Basins basins = find_basins(flow_directions(terrain, sea_level_m, run.part(0.0, 0.3)), run.part(0.3, 0.6));
  if (basins.count() == 1) return terrain;
  const std::vector<float> levels =
      shallow_levels(terrain, basins, find_passes(terrain, basins, run.part(0.6, 0.9)), min_depth_m);
  return raise_to(terrain, basins, levels, run.part(0.9, 1.0));
}

void tilt_flats(HeightField& filled, const FlowDirections& directions, const RunContext& run) {
  const int width = filled.width();
  const std::array<int64_t, 8> steps = flow_steps(width);
  float* z = filled.data();
  const uint8_t* code = directions.data();
  const auto too_low = [&](int64_t i) { return code[i] < 8 && z[i] <= z[i + steps[code[i]]]; };
  std::vector<int32_t> low;
  for (int y = 0; y < filled.height(); ++y) {
    run.check_cancelled();
    for (int x = 0; x < width; ++x) {
      const int64_t i = static_cast<int64_t>(y) * width + x;
      // Only from the first cell of a chain, whose receiver stands: the rest follows upstream.
      if (!too_low(i) || too_low(i + steps[code[i]])) continue;
      low.push_back(static_cast<int32_t>(i));
      while (!low.empty()) {
        const int32_t cell = low.back();
        low.pop_back();
        z[cell] = std::nextafter(z[cell + steps[code[cell]]], INFINITY);
        for (size_t k = 0; k < 8; ++k) {
          const int cx = cell % width + kFlowDx[k], cy = cell / width + kFlowDy[k];
          if (cx < 0 || cy < 0 || cx >= width || cy >= filled.height()) continue;
          const int64_t other = cell + steps[k];
          if (code[other] == (k + 4) % 8 && z[other] <= z[cell]) low.push_back(static_cast<int32_t>(other));
        }
      }
    }
  }
}

}  // namespace seamount::geom
