// Samples for the island synthesizer from a set on disk (island_set.h), made by `dataset islands` or painted by hand.
#pragma once

#include <string>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/train/held_out.h"
#include "seamount/train/island_samples.h"
#include "seamount/train/sample.h"

namespace seamount::train {

/// A sample is one of the set, turned and mirrored, with its range of heights told or not; larger ones are cut. Maps
/// are read as painted ones are: blurred or noisy pictures of a set teach what such pictures mean.
class StoredIslandTask : public Task {
 public:
  /// `folder` holds samples 0 to count - 1. Throws InvalidArgument{"--set"} for samples of less than 64 cells and where
  /// there are too few; training() and held_out() throw IoError for files that cannot be read or are of another size.
  StoredIslandTask(std::string folder, const IslandSetParams& params, size_t count, Seed seed);

  std::string name() const override { return "island"; }
  learned::Architecture architecture() const override;
  std::vector<int> drawn_planes() const override { return {0, 1, 2, 3, 5}; }
  Sample training(uint64_t n) const override { return sample(split_.learned, seed_.derive("training", n)); }
  Sample held_out(uint64_t n) const override { return sample(split_.held_out, seed_.derive("held out", n)); }

 private:
  Sample sample(const std::vector<size_t>& among, Seed seed) const;

  std::string folder_;
  IslandSetParams params_;
  int size_;
  Seed seed_;
  Split split_;
};

}  // namespace seamount::train
