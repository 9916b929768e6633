// How well objects do where they are (P3 sec. 1.5.2): the mean of the fitness over the skeleton.
#pragma once

#include <span>
#include <vector>

#include "seamount/ops/ecosystem/survey.h"

namespace seamount::ecosystem {

/// Where a skeleton is asked: a point itself, the vertices of a curve, about 64 places of a raster within a region (its
/// vertices if none lies within).
std::vector<Vec2> places_of(const Skeleton& skeleton);

/// Fitness of the objects with these indices, as they stand: the mean over their places; NaN where one of these lies
/// outside the frame or has no value, -infinity where more than half of them lie where the class may not be (within,
/// outside). Parallel; about 50 ns a place and word.
std::vector<double> fitness_of(const Scene& scene, const Rules& rules, const Environment& environment,
                               std::span<const size_t> objects, const RunContext& run);

}  // namespace seamount::ecosystem
