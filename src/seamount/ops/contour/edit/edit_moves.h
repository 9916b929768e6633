// The tools of contour.edit that move contours by a map of the plane, or one by one.
#pragma once

#include <string>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/contour_set.h"
#include "seamount/ops/contour/edit/edit_params.h"

namespace seamount::contour {

/// Where a tool works and how it speaks: its place in the session ("edits[3]") and what to do about crossings.
struct ToolContext {
  std::string name;
  OnCrossing on_crossing = OnCrossing::limit;
  Seed seed;
  const RunContext& run;
};

// A tool that throws may leave the set half edited: a session is given up then.
void apply(const WarpTool& tool, ContourSet& set, const ToolContext& context);
void apply(const SlopeTool& tool, ContourSet& set, const ToolContext& context);
void apply(const SmoothTool& tool, ContourSet& set, const ToolContext& context);
void apply(const FractalizeTool& tool, ContourSet& set, const ToolContext& context);

}  // namespace seamount::contour
