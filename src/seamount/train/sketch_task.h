// Samples for the sketch synthesizer: real ground, and a sketch of it as somebody might have drawn it.
//
// Source: P1 sec. 5 (database of sketch and terrain pairs). Ours: sketches are extracted once per tile at three degrees
// of detail (sketch.extract); a sample is a crop, turned and mirrored, with a random part of the strokes, shifted by up
// to three cells, and kinds left out at random, so that one network learns every mix (P1 sec. 7.4), a few strokes, and
// none.
#pragma once

#include <string>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/train/ground_tiles.h"
#include "seamount/train/sample.h"

namespace seamount::train {

/// Lines and places of a tile in cells (fractional column, row).
struct DrawnTile {
  struct Cue {
    float x, y, height_m;
  };
  std::vector<std::vector<std::pair<float, float>>> rivers, ridges;
  std::vector<Cue> cues;
};

class SketchTask : public Task {
 public:
  /// Reads and sketches all ground of a folder, a minute or two for 60 tiles. Throws as read_ground().
  SketchTask(const std::string& dem_folder, int size, Seed seed, const RunContext& run);

  std::string name() const override { return "sketch"; }
  learned::Architecture architecture() const override;
  std::vector<int> drawn_planes() const override;
  Sample training(uint64_t n) const override { return sample(training_, seed_.derive("training", n)); }
  Sample held_out(uint64_t n) const override { return sample(held_out_, seed_.derive("held out", n)); }

 private:
  struct Ground {
    GroundTile tile;
    std::vector<DrawnTile> drawn;  ///< from much detail to little
  };
  Sample sample(const std::vector<Ground>& grounds, Seed seed) const;
  static std::vector<Ground> sketched(std::vector<GroundTile> tiles, Seed seed, const RunContext& run);

  int size_;
  Seed seed_;
  std::vector<Ground> training_, held_out_;
};

}  // namespace seamount::train
