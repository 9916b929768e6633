// The beds under the cells of a grid (lithology.h): how far rivers and slopes get in a step that cuts many of them.
//
// In a step of an implicit scheme every bed wears at the slope that the step ends with, so a metre of it counts as many
// metres as it is hard: steps may cut through any number of beds. Slopes stand over their foot as steep as each bed
// that they pass. Within a step the block of rock that a cell's bedrock lies in goes down without end: a fault that
// dips is crossed between steps.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/ops/erosion/layers.h"
#include "seamount/ops/erosion/lithology.h"

namespace seamount::erosion {

class Beds {
 public:
  /// REQUIRES: rock.beds() is not empty; `rock` outlives this.
  Beds(const Lithology& rock, const GridFrame& frame, const RunContext& run);

  /// Finds the beds below a ground whose rock has risen by `risen_m`, times the maps, since the beds were given.
  /// Before the first question, and whenever the ground has risen or worn. Parallel, about 20 ns per cell, more with
  /// faults.
  void settle(const Layers& ground, const Maps& site, float risen_m, const RunContext& run);

  /// Number, from 0, and hardness of the bed at a height in the column of a cell; at a border: of the bed below it.
  int bed(size_t cell, float height) const { return at(cell, height).index; }
  float hardness(size_t cell, float height) const { return at(cell, height).hardness; }

  /// Height after a step of dh/dt = -F (h - base) that has worn loose layers down to the bedrock at `top` >= base:
  /// `rate` is F dt for a hardness of 1, `worn` what the loose layers took (rivers.cpp).
  float cut(size_t cell, float top, float base, float worn, float rate) const;

  /// Height up to which rock stands between two neighbours of heights low <= other, or `here` if that is lower; over a
  /// cell rock of hardness 1 rises by `rise`. Godunov's upwind differences of the distance that beds take.
  float stand(size_t cell, float low, float other, float here, float rise) const;

 private:
  using Bed = BedSequence::Bed;
  struct Column;

  Column column(size_t cell) const;
  Bed at(size_t cell, float height) const;

  const Lithology& rock_;
  ScalarField datum_, stretch_;
  float uniform_stretch_;
  float settled_m_ = -1.0F;  // risen, when the datum was found
};

/// Hardness of the bedrock at a cell's top, or 1 times the map's where there are no beds.
float bedrock_hardness(const Layers& ground, const Maps& site, size_t cell);

}  // namespace seamount::erosion
