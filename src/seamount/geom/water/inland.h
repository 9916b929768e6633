// What is sea: the one place that decides it.
//
// "At or below sea level is open water" makes seas of every cell at -0.5 m far from the coast, of drained polders and
// of the land around the Dead Sea. Sea is water that reaches the edge of the terrain; enclosed water is sea too if it
// is large and could be: the lagoon of an atoll behind its low rim, a deep sea whose strait is too narrow for the
// cells. The rest are hollows, ground like any other, whose water finds a way out or stands as a lake.
#pragma once

#include <cstdint>
#include <optional>

#include "seamount/base/run_context.h"
#include "seamount/geom/water/flow.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// What a parameter of that area says of itself, the same in every operator that has one.
inline constexpr const char* kLeastSeaMeaning =
    "enclosed water below sea level that is smaller is no sea but a hollow; if absent, only what is deeper than 1000 "
    "m, "
    "or deeper than 10 m behind a rim of at most 10 m and a hundredth of the terrain, is sea";

/// What water does with cells of which nothing is known (NaN): it leaves there. As a height they are below all others.
inline constexpr float kUnknownGround = kNoSea;

/// 1 in hollows: cells at or below the sea's level that are no sea; an empty grid where there are none. Waters are
/// cells that hang together by sides or corners. Sea is what reaches the edge of the terrain or an unknown cell (NaN).
/// If min_sea_m2 is given, so is what covers at least that. If not, so is what is deeper than 1000 m, where no dry
/// ground of the Earth lies, and what covers at least a hundredth of the terrain, is deeper than 10 m, which polders
/// are not, and has a way to the sea or the edge that climbs at most 10 m above the sea. Of enclosed waters so large it
/// says how they were taken. Linear; about 1 ns per cell without water below sea level, some ns per cell with it, as
/// fill_depressions() where large ones are enclosed.
Grid<uint8_t> find_hollows(const HeightField& terrain, float sea_level_m, const std::optional<double>& min_sea_m2,
                           const RunContext& run);

/// The terrain in which hollows lie at that height, for what asks how deep the sea is. Cost as above.
HeightField fill_hollows(HeightField terrain, float sea_level_m, float height_m, const RunContext& run);

/// The terrain in which hollows lie just above sea level. Filled or not, water flows from the result as it would from
/// the terrain if its hollows were no sea. Unknown cells become kUnknownGround, where flow ends. Cost as above.
HeightField raise_inland(HeightField terrain, float sea_level_m, const std::optional<double>& min_sea_m2,
                         const RunContext& run);

/// The terrain with its hollows as they are and the sea lowered: all of it lies at the new sea_level_m, below all
/// ground. Water flows inside the hollows as well. Without a sea (kNoSea) the level is that low too, and nothing lies
/// there.
HeightField lower_sea(HeightField terrain, float& sea_level_m, const std::optional<double>& min_sea_m2,
                      const RunContext& run);

/// The inverse for results: kUnknownGround becomes NaN. Linear.
void forget_unknown(HeightField& terrain);

}  // namespace seamount::geom
