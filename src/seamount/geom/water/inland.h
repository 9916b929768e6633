// Hollows below sea level that are no sea: a cell of an elevation model at -0.5 m far from the coast, a drained polder.
//
// "At or below sea level is open water" ends rivers in every such cell. Sea is water that reaches the edge of the
// terrain, and enclosed water that is large; the rest is ground like any other, whose water finds a way out.
#pragma once

#include <optional>

#include "seamount/base/run_context.h"
#include "seamount/geom/water/flow.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// What a parameter of that area says of itself, the same in every operator that has one.
inline constexpr const char* kLeastSeaMeaning =
    "enclosed water below sea level that is smaller is no sea but a hollow; a hundredth of the terrain's area if "
    "absent";

/// What water does with cells of which nothing is known (NaN): it leaves there. As a height they are below all others.
inline constexpr float kUnknownGround = kNoSea;

/// The terrain in which hollows lie just above sea level: cells at or below it that hang together (by sides or
/// corners), do not reach the edge or an unknown cell (NaN) and cover less than `min_sea_m2` (a hundredth of the
/// terrain if absent). Filled or not, water flows from the result as it would from the terrain if its hollows were no
/// sea. Unknown cells become kUnknownGround, where flow ends. Linear; about 1 ns per cell without water below sea
/// level, some ns per cell with it.
HeightField raise_inland(HeightField terrain, float sea_level_m, const std::optional<double>& min_sea_m2,
                         const RunContext& run);

/// The inverse for results: kUnknownGround becomes NaN. Linear.
void forget_unknown(HeightField& terrain);

}  // namespace seamount::geom
