// contour.edit: an editing session on contours, as a list of tools that can be replayed.
//
// Source: P2 sec. 5 (smoothing, warping, slope), sec. 6.2 (patterns), sec. 6.6 (tools that it leaves to future work:
// delete, cut, copy, paste, fill, fractalize). Contours never cross after any edit: it is checked after each.
// Departures of each tool stand in its own header: drag.h (warp), squeeze.h (slope), smooth.h, roughen.h (fractalize),
// pattern.h (copy, cut, paste), fill.h.
#pragma once

#include <functional>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"
#include "seamount/model/contour_set.h"
#include "seamount/ops/contour/edit/edit_params.h"

namespace seamount::contour {

/// What pastes read besides the session itself.
struct PatternSource {
  const Drawing* input = nullptr;                     ///< pasted where nothing was copied and no file is named
  std::function<Drawing(const FilePath&)> read_file;  ///< for `paste` with a file
};

/// The contours after all edits. What was limited is said to run.say(). Throws InvalidArgument{"edits[i]..."} for a
/// tool that cannot work: a stroke of one point or outside the domain, a step above its bound, nothing selected,
/// nothing to paste, an edit that is refused with the strength that would do; IncompatibleInputs where contours cross
/// already. Costs what its tools cost; fractalize and fill depend on the seed.
ContourSet edit(const ContourSet& contours, const EditParams& params, const PatternSource& patterns, Seed seed,
                const RunContext& run);

}  // namespace seamount::contour
