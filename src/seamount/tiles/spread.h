// Work on many tiles, spread over ranks and over the threads of each.
#pragma once

#include <functional>

#include "seamount/base/run_context.h"
#include "seamount/tiles/ranks.h"

namespace seamount::tiles {

/// Threads of a rank where the user says nothing: the ranks of a machine share its processors.
int threads_of(const Ranks& ranks);

/// How many pieces of work of so many bytes one process does at once: as many as it has threads, fewer if they do not
/// fit into `memory_bytes`, one at least.
int at_once(double bytes, double memory_bytes, const RunContext& run);

/// Calls body(i, own) once for every i of [0, count), on whichever rank and thread is free, `pieces` at once in each
/// process, and returns when all ranks have done all of them. Where a body returns false, no more are begun. Reports
/// the share that has been begun by anybody. Where bodies throw, no more are begun, and what that of the lowest number
/// threw on this rank is rethrown on it.
void spread(Ranks& ranks, const RunContext& run, int count, int pieces,
            const std::function<bool(int i, const RunContext& own)>& body);

}  // namespace seamount::tiles
