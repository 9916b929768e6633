// What the sketch synthesizer sees: a sketch of any mix of ridges, rivers, altitude cues, levelset and known ground, as
// planes of numbers, the same in training and in use.
//
// Source: P1 sec. 4.1 and 5, whose networks see one kind each; here all kinds are planes, absent ones empty (P1
// sec. 7.4 lists that as the limit). Heights are shares of the relief over the low ground: (z - low_m) / relief_m.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/ops/learned/planes.h"

namespace seamount::learned {

/// Every grid may be empty: nothing of its kind was drawn. The others are in the frame.
struct SketchMap {
  GridFrame frame;
  Grid<uint8_t> river, ridge;  ///< not 0 on lines
  Grid<uint8_t> cue;           ///< not 0 at places whose height is given
  ScalarField cue_m;           ///< that height
  Grid<int8_t> level;          ///< 1: high ground, -1: low ground, 0: not said
  HeightField known_m;         ///< ground that stays as it is; NaN: none
  double low_m = 0.0;          ///< height of the low ground
  double relief_m = 1000.0;    ///< of the high ground above it, > 0
};

inline constexpr int kSketchPlanes = 16;

/// Planes of the drawing that a critic of the result may compare it with: lines, cues, levelset; the last two are
/// empty. Known ground is in the base alone: beside ground that it is shown the network makes a level rim of 30 cells,
/// the mean of all that might follow.
inline constexpr int kSketchDrawnPlanes[] = {0, 2, 4, 5, 6, 7, 8};

class SketchPlanes {
 public:
  /// Distances and the base of a sketch. Throws InvalidArgument{"relief_m"} unless it is > 0. Parallel, linear; up to
  /// 28 bytes per cell.
  SketchPlanes(const SketchMap& map, Seed seed, const RunContext& run);

  Planes planes() const;

  /// Heights that the drawing itself gives, spread smoothly (geom/grid/pyramid_fill.h), as shares of the relief: what
  /// the network's result is added to.
  const ScalarField& base() const { return base_; }

  /// Distances in cells from what is drawn; empty where nothing of a kind is.
  const ScalarField& from_river() const { return river_; }
  const ScalarField& from_ridge() const { return ridge_; }

 private:
  void fill_row(int y, float* values) const;

  const SketchMap& map_;  ///< must outlive this
  Seed seed_;
  ScalarField river_, ridge_, cue_;  ///< distances in cells; empty: none drawn
  Grid<int32_t> nearest_cue_;
  ScalarField base_;
};

}  // namespace seamount::learned
