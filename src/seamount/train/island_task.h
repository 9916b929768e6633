// Samples for the island synthesizer: islands of the generator (island_samples.h) and their maps, clean or as a painter
// would make them.
//
// Source: P0 sec. 1.5 and 1.7. Ours: also at two and four times the resolution, as crops, so that larger maps are no
// surprise; blurred, noisy and wrongly coloured maps from the start.
#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/ops/learned/island_planes.h"
#include "seamount/train/island_samples.h"
#include "seamount/train/sample.h"

namespace seamount::train {

/// What the network sees of a map, and the heights that it should make of it; `labels` say what is deep sea floor.
Sample island_sample(const learned::IslandMap& map, const LabelMap& labels, const HeightField& heights, Seed noise);

class IslandTask : public Task {
 public:
  explicit IslandTask(Seed seed) : seed_(seed) {}
  std::string name() const override { return "island"; }
  learned::Architecture architecture() const override;
  std::vector<int> drawn_planes() const override { return {0, 1, 2, 3, 5}; }
  Sample training(uint64_t n) const override { return sample(n, seed_.derive("training")); }
  Sample held_out(uint64_t n) const override { return sample(n, seed_.derive("held out")); }

 private:
  struct Made {
    uint64_t group = 0;
    Seed seed;
    IslandPair pair;
    double subsidence = 0;
  };
  Sample sample(uint64_t n, Seed seed) const;
  std::shared_ptr<const Made> island(uint64_t group, Seed seed) const;

  Seed seed_;
  mutable std::mutex mutex_;
  mutable std::list<std::shared_ptr<const Made>> recent_;  ///< a few, since neighbouring samples are crops of one
};

}  // namespace seamount::train
