// Points that climb to a place that suits them better (P3 sec. 1.5.2, point-based skeletons).
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/skeleton/field.h"

namespace seamount::geom {

/// A field that each point sees in its own way: whose[k] is the index of the point that asks at places[k].
using FieldForPoints =
    std::function<void(std::span<const Vec2> places, std::span<const size_t> whose, std::span<double> values)>;

struct ClimbOptions {
  double cell_m = 1.0;             ///< what the field resolves, > 0: slopes are taken over a quarter of it each way
  double first_step_m = 0.0;       ///< >= 0; 0: one cell. A step that does not help is halved, one that does
                                   ///< grows by half up to this again
  double least_step_cells = 0.01;  ///< a point rests when its step is below this share of a cell, > 0
  double least_slope = 0.0;        ///< or the slope of the field below this, per metre, >= 0
  double most_distance_m = 0.0;    ///< no further from where it stood than this; 0: as far as it likes
  int steps = 200;                 ///< at most, >= 0
};

struct Climbed {
  Vec2 at;
  double value = 0.0;  ///< of the field there; as the field gave it where a point stood and stays unfit
  int steps = 0;       ///< accepted
  bool rests = false;  ///< false: it would still climb
};

/// Gradient ascent of all points side by side: five places a point and step, one call of the field for each step of
/// all. No point ever goes lower or to an unfit place; one that stands on an unfit place stays there. Where a step
/// along the slope does not help, the best of the places that the slope was taken from may; on a crest without breadth
/// that is all.
/// Throws InvalidArgument for options out of range. Linear in points and steps.
std::vector<Climbed> hill_climb(std::span<const Vec2> points, const ClimbOptions& options, const FieldForPoints& field,
                                const RunContext& run);
std::vector<Climbed> hill_climb(std::span<const Vec2> points, const ClimbOptions& options, const FieldAtPlaces& field,
                                const RunContext& run);

}  // namespace seamount::geom
