// Regions fitted to what a network of their size can show.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/tin.h"

namespace seamount::contour {

/// Gives sea that land nearer than nodes shuts off from the domain's edge to the land around it, where its water could
/// not run off. How many nodes. About linear.
int64_t close_shut_waters(Tin& tin);

/// Gives parts of a hill's region that the network cuts off from all lower ground to the region around or beside them:
/// between hills that are too near each other for nodes in the valley. About linear.
void join_strays(Tin& tin, const RunContext& run);

/// Takes out regions without nodes; what they enclosed belongs to what encloses them. Their names. Linear.
std::vector<std::string> drop_empty_regions(Tin& tin);

}  // namespace seamount::contour
