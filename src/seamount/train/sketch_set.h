// Examples of real ground and its sketch on disk, P1's database, for a set of samples (sample_set.h):
//
//   000000_height.png     16 bits: code 0 is low_m, 65535 is high_m, the lowest and the highest ground of the example
//   000000_sketch.png     ridges red, rivers blue, cues green by height, of sketch.extract (ops/sketch/extract.h)
//   000000_levelset.png   high ground white, of sketch.levelset
//
// Source: P1 sec. 4.2, 5.1 and 5.2. Ours: three degrees of detail and any percentile instead of one.
#pragma once

#include <string>
#include <tuple>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/base/hash.h"
#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/train/ground_tiles.h"

namespace seamount::train {

inline constexpr const char* kSketchFiles[] = {"height", "sketch", "levelset"};

/// What all examples of a set share, beside the ground.
struct SketchSetParams {
  int size = 256;
  double unknown = 0.0;
  bool held_out = false;

  static constexpr auto fields() {
    using P = SketchSetParams;
    return std::tuple(
        field(&P::size, "size", "", between(32, 4096), "cells a side of each example"),
        field(&P::unknown, "unknown", "", between(0, 0.5),
              "share of an example that may be without ground (voids, lakes, the sea), and is filled smoothly"),
        field(&P::held_out, "held_out", "show the ground that training does not see: that of a fifth of the regions"));
  }
};

/// Everything that was drawn for an example, and what its pictures mean.
struct SketchDraw {
  double cell_m = 30.0;
  int left = 0, top = 0;
  bool flip_x = false, flip_y = false, transpose = false;
  double low_m = 0.0, high_m = 1.0;
  int detail = 0;
  double lowest_cue_m = 0.0, highest_cue_m = 0.0;
  double percentile = 60.0, blur_m = 0.0, level_m = 0.0;

  static constexpr auto fields() {
    using P = SketchDraw;
    constexpr Range kHeight = between(-12000, 9000);
    return std::tuple(
        field(&P::cell_m, "cell_m", "m", between(0.01, 1e6), "size of a cell"),
        field(&P::left, "left", "", between(0, 1e6), "western column of the tile that is shown"),
        field(&P::top, "top", "", between(0, 1e6), "northern row"),
        field(&P::flip_x, "flip_x", "columns from east to west"),
        field(&P::flip_y, "flip_y", "rows from south to north"),
        field(&P::transpose, "transpose", "columns become rows, after the flips are undone"),
        field(&P::low_m, "low_m", "m", kHeight, "height of code 0"),
        field(&P::high_m, "high_m", "m", kHeight, "height of code 65535"),
        field(&P::detail, "detail", "", between(0, 2), "0: many lines, 1, 2: few"),
        field(&P::lowest_cue_m, "lowest_cue_m", "m", kHeight, "height of green 32; 0 without cues"),
        field(&P::highest_cue_m, "highest_cue_m", "m", kHeight, "height of green 255"),
        field(&P::percentile, "percentile", "%", between(0, 100), "share of the ground below the levelset"),
        field(&P::blur_m, "blur_m", "m", between(0, 1e6), "deviation of the blur before it"),
        field(&P::level_m, "level_m", "m", kHeight, "height of the levelset's line"));
  }
};

struct SketchExample {
  std::string tile;  ///< whose ground it shows
  SketchDraw draw;
  std::vector<std::string> digests;  ///< of its files, in the order of kSketchFiles
};

/// The tiles that are as large as an example. Throws InvalidArgument{"--size"} where there are none, and as
/// read_ground().
std::vector<GroundTile> read_sketch_ground(const std::string& folder, const SketchSetParams& params,
                                           const RunContext& run);

/// Of names, places and heights: sets of one digest, seed and params are the same.
Digest ground_digest(const std::vector<GroundTile>& tiles);

/// Writes the files of example `index`, a function of (tiles, params, seed, index). Throws InvalidArgument{"--dem"}
/// where hardly any square of the tiles is ground with relief, WriteError, Cancelled. About 0.1 s for 256 x 256.
SketchExample make_sketch_files(const std::vector<GroundTile>& tiles, const SketchSetParams& params, uint64_t index,
                                Seed seed, const std::string& folder, const RunContext& run);

}  // namespace seamount::train
