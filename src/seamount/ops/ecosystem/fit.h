// Skeletons of objects, fitted to what surrounds them (P3 sec. 1.5.2): new ones from where they begin, living ones
// again in every iteration.
#pragma once

#include <vector>

#include "seamount/ops/ecosystem/survey.h"

namespace seamount::ecosystem {

/// Skeletons of new objects of a class that begin at these places, with a size each (times the class's). Those that
/// cannot grow are without points. Points climb at most half the class's spacing, or a cell.
std::vector<Skeleton> first_skeletons(const Scene& scene, const Rules& rules, const Environment& environment,
                                      int of_class, std::span<const Vec2> places, std::span<const double> sizes,
                                      const RunContext& run);

/// The living objects of a window fitted again, those that are held but as far as they are. Each sees the others where
/// they were. Returns whether any moved.
bool fit_again(Scene& scene, const Rules& rules, const Environment& environment, int window, const RunContext& run);

}  // namespace seamount::ecosystem
