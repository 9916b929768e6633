// Cells that hold a code for "nothing is known here" which the file does not declare, and heights that cannot be.
#pragma once

#include <string>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::io {

/// Cells of the usual codes (-9999, -32768, 32767, 3.4e38 and what is like it) become NaN, and it is said how many;
/// -9999 and the like only where no other value comes near them, so that a deep sea stays. `stored`: values as the file
/// holds them, before any scale or unit. Numbers above 0 are codes in rasters of heights only: of anything else 32767
/// may be a count. Linear.
void take_out_void_codes(Grid<float>& stored, const std::string& name, bool heights, const RunContext& run);

/// Heights more than 30 km from sea level become NaN, and it is said how many. Throws IoError where most are such: then
/// the unit is not what it was taken for. Linear.
void take_out_impossible_heights(Grid<float>& heights, const std::string& name, const RunContext& run);

}  // namespace seamount::io
