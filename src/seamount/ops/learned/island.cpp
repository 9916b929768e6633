#include "seamount/ops/learned/island.h"

#include <string>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"

namespace seamount::learned {

std::array<Mask, kRegionCount> shares_of(const LabelMap& labels, const RunContext& run) {
  std::array<Mask, kRegionCount> shares;
  for (Mask& share : shares) share = Mask(labels.frame(), 0.0F);
  parallel_rows(run, labels.width(), labels.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < labels.width(); ++x) {
        for (int dy = -1; dy <= 1; ++dy) {
          for (int dx = -1; dx <= 1; ++dx) {
            const float weight = (dx == 0 ? 0.5F : 0.25F) * (dy == 0 ? 0.5F : 0.25F);
            shares[static_cast<size_t>(labels.clamped(x + dx, y + dy))](x, y) += weight;
          }
        }
      }
    }
  });
  return shares;
}

HeightField island(const IslandMap& map, const Network& network, Seed seed, const RunContext& run) {
  if (network.architecture().planes != kIslandPlanes)
    throw InvalidArgument("model", "is a network of " + std::to_string(network.architecture().planes) +
                                       " planes, and an island has " + std::to_string(kIslandPlanes));
  const IslandPlanes planes(map, seed, run);
  HeightField heights = network.evaluate(planes.planes(), map.frame, run);
  parallel_rows(run, map.frame.width, map.frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (float& z : heights.row(y)) z = static_cast<float>(island_height_m(z, map.scale));
    }
  });
  return heights;
}

}  // namespace seamount::learned
