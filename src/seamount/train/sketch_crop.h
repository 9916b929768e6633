// One sample of the sketch task: a square of ground, and what is drawn of it.
#pragma once

#include <optional>

#include "seamount/base/rng.h"
#include "seamount/model/grid.h"
#include "seamount/ops/learned/sketch_planes.h"
#include "seamount/train/sample.h"
#include "seamount/train/sketch_task.h"

namespace seamount::train {

/// A square of a tile, turned and mirrored: cell (x, y) of it is (column, row) of the tile as below.
struct Crop {
  HeightField heights;  ///< unknown cells filled
  Grid<uint8_t> filled;
  int left = 0, top = 0;
  bool flip_x = false, flip_y = false, transpose = false;

  /// A place of the tile, in cells, as a place of the crop.
  std::pair<float, float> placed(std::pair<float, float> cell) const;
};

/// A random square of which at least the share `known` has heights, with some relief (more than a 200th of its width);
/// nullopt after 20 tries. REQUIRES: the tile is as large.
std::optional<Crop> find_crop(const HeightField& tile, int size, double known, Rng& rng);

/// Draws of the kinds present, strokes, their shift, levelset, and known ground at random.
Sample sketch_sample(const Crop& crop, const DrawnTile& drawn, Seed seed);

/// A map without strokes whose low ground and relief are stated about right.
learned::SketchMap scaled_map(const Crop& crop, Rng& rng);

/// What the network sees of a map, and the crop that it should make of it.
Sample sample_of(const learned::SketchMap& map, const Crop& crop, Seed noise);

}  // namespace seamount::train
