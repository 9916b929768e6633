#include "seamount/train/stored_islands.h"

#include <algorithm>
#include <utility>

#include "seamount/geom/grid/painted_labels.h"
#include "seamount/ops/learned/island.h"
#include "seamount/train/island_task.h"
#include "seamount/train/sample_set.h"
#include "seamount/train/stored_view.h"

namespace seamount::train {

StoredIslandTask::StoredIslandTask(std::string folder, const IslandSetParams& params, size_t count, Seed seed)
    : folder_(std::move(folder)), params_(params), size_(learned_size(params.size)), seed_(seed) {
  // The levels of subsidence of one island follow each other.
  const auto levels = static_cast<size_t>(params.levels);
  split_ = split_samples(count, seed, [levels](size_t i) { return static_cast<uint64_t>(i / levels); });
}

learned::Architecture StoredIslandTask::architecture() const { return {.planes = learned::kIslandPlanes}; }

Sample StoredIslandTask::sample(const std::vector<size_t>& among, Seed seed) const {
  RunContext alone;
  alone.threads = 1;
  Rng rng(seed);
  const size_t index = among[static_cast<size_t>(rng.integer(0, static_cast<int>(among.size()) - 1))];
  const StoredView view = StoredView::any(size_, params_.size, rng);
  const std::string labels_file = sample_file(folder_, index, "labels");
  const HeightField stored = read_stored_heights(sample_file(folder_, index, "height"), params_.size,
                                                 params_.width_m / params_.size, {params_.low_m, params_.high_m});
  const geom::PaintedLabels painted =
      geom::decode_labels(read_stored_picture(labels_file, params_.size), stored.frame(), alone);
  const HeightField heights = seen(stored, view);
  learned::IslandMap map;
  map.frame = heights.frame();
  for (size_t k = 0; k < map.shares.size(); ++k) map.shares[k] = seen(painted.shares[k], view);
  map.subsidence = seen(painted.subsidence_per_cell, view);
  const auto [low, high] = std::minmax_element(stored.cells().begin(), stored.cells().end());
  if (rng.chance(0.7) && *high > 0) map.peak_m = *high;
  if (rng.chance(0.7)) map.floor_m = *low;
  return island_sample(map, seen(painted.labels, view), heights, seed.derive("noise"));
}

}  // namespace seamount::train
