// One front (growth.h): Algorithm 1 of P2 with draws in constant time.
#include <algorithm>
#include <cmath>

#include "seamount/geom/scalar/weighted_sampler.h"
#include "seamount/ops/contour/growth/growth.h"

namespace seamount::contour {

using geom::WeightedSampler;

uint32_t growth_weight(double probability) {
  return static_cast<uint32_t>(std::lround(std::clamp(probability, 0.001, 0.999) * WeightedSampler::kMost));
}

void eden_growth(const RegionGraph& graph, std::span<const int32_t> seeds, std::span<const uint32_t> weights,
                 bool against, Rng rng, std::span<uint32_t> step, const RunContext& run) {
  constexpr uint32_t kStepsPerCheck = 1 << 13;
  WeightedSampler frontier;
  uint32_t steps = 0;
  const auto reach = [&](int32_t node) {
    const auto n = static_cast<size_t>(node);
    step[n] = ++steps;
    frontier.add(static_cast<uint32_t>(node), against ? WeightedSampler::kMost - weights[n] : weights[n]);
  };
  for (const int32_t node : seeds) {
    if (step[static_cast<size_t>(node)] == 0) reach(node);
  }
  std::vector<int32_t> free;
  for (uint32_t draws = 0; !frontier.empty(); ++draws) {
    if (draws % kStepsPerCheck == 0) run.check_cancelled();
    const WeightedSampler::Place place = frontier.draw(rng);
    const auto node = static_cast<int32_t>(frontier.item(place));
    free.clear();
    for (const int32_t neighbour : graph.around(node)) {
      if (step[static_cast<size_t>(neighbour)] == 0) free.push_back(neighbour);
    }
    if (!free.empty()) reach(free[((rng.bits() >> 32) * free.size()) >> 32]);
    if (free.size() <= 1) frontier.remove(place);
  }
}

}  // namespace seamount::contour
