// Samples for the sketch synthesizer: real ground, and a sketch of it as somebody might have drawn it.
//
// Source: P1 sec. 5 (database of sketch and terrain pairs). Ours: sketches are extracted once per tile at three degrees
// of detail (sketch.extract); a sample is a crop, turned and mirrored, with a random part of the strokes, shifted by up
// to three cells, and kinds left out at random, so that one network learns every mix (P1 sec. 7.4), a few strokes, and
// none.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/ops/sketch/extract.h"
#include "seamount/train/ground_tiles.h"
#include "seamount/train/sample.h"

namespace seamount::train {

/// Degrees of detail in which ground is sketched, from much to little.
inline constexpr int kSketchDetails = 3;
sketch::ExtractParams extract_params(int detail, double cell_m);

/// A tile at random, larger ones more often.
size_t choose_tile(const std::vector<GroundTile>& tiles, Rng& rng);

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
    std::vector<GroundTile> tiles;
    std::vector<std::array<DrawnTile, kSketchDetails>> drawn;  ///< of each tile
  };
  Sample sample(const Ground& ground, Seed seed) const;
  static Ground sketched(std::vector<GroundTile> tiles, Seed seed, const RunContext& run);

  int size_;
  Seed seed_;
  Ground training_, held_out_;
};

}  // namespace seamount::train
