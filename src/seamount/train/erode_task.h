// Samples for the erosion synthesizer: squares of pairs of terrain and what erosion.run makes of it (erode_pairs.h),
// turned and mirrored. Pairs are made once, since the simulation takes longer than a step of the training.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/train/erode_pairs.h"
#include "seamount/train/sample.h"

namespace seamount::train {

class ErodeTask : public Task {
 public:
  /// Makes `pairs` pairs to train with and an eighth as many held out, of ground and noise that training never shows: a
  /// minute or two for 400. `dem_folder`: of elevation models (ground_tiles.h); empty: noise alone. `size`: of samples,
  /// up to kErodeCells. Throws as read_ground(); InvalidArgument{"--pairs"}, {"--size"}; Cancelled. Memory: 5 MB a
  /// pair.
  ErodeTask(const std::string& dem_folder, int size, int pairs, Seed seed, const RunContext& run);

  std::string name() const override { return "erode"; }
  learned::Architecture architecture() const override;
  std::vector<int> drawn_planes() const override { return {0, 3, 7}; }
  Sample training(uint64_t n) const override { return sample(training_, seed_.derive("training", n)); }
  Sample held_out(uint64_t n) const override { return sample(held_out_, seed_.derive("held out", n)); }

 private:
  /// A pair as the network sees it, all of it.
  struct Seen {
    int width = 0, height = 0;
    std::vector<float> planes, base, target;
  };
  static std::vector<Seen> seen_pairs(const std::vector<GroundTile>& tiles, int count, Seed seed,
                                      const RunContext& run);
  Sample sample(const std::vector<Seen>& pairs, Seed seed) const;

  int size_;
  Seed seed_;
  std::vector<Seen> training_, held_out_;
};

}  // namespace seamount::train
