// Parallel loops: the only place where threads are made. Blocks depend on the range and the grain alone, never on the
// number of threads, so that a value per block (and reductions in block order) are the same bytes on every machine.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "seamount/base/run_context.h"

namespace seamount {

using BlockBody = std::function<void(int64_t begin, int64_t end)>;

/// Calls body(begin, end) for the blocks [0, grain), [grain, 2 grain), ... of [0, count), side by side on up to
/// run.threads threads. Checks for cancellation before each block and reports progress after it. An exception of a body
/// ends the loop; that of the lowest block is rethrown, the same one on any number of threads. Who waits in it takes no
/// other work up. REQUIRES: grain >= 1, disjoint writes.
void parallel_blocks(const RunContext& run, int64_t count, int64_t grain, const BlockBody& body);

/// The same for image rows, with a grain that gives each block about 64 Ki cells: a block is long enough to pay for its
/// scheduling and short enough that cancelling is prompt.
void parallel_rows(const RunContext& run, int width, int height, const std::function<void(int begin, int end)>& body);

/// Sum over blocks, added in block order: the same bits on any number of threads.
template <class T>
T parallel_sum(const RunContext& run, int64_t count, int64_t grain,
               const std::function<T(int64_t begin, int64_t end)>& body) {
  std::vector<T> parts(static_cast<size_t>((count + grain - 1) / grain));
  parallel_blocks(run, count, grain, [&](int64_t begin, int64_t end) { parts[begin / grain] = body(begin, end); });
  T total{};
  for (const T& part : parts) total += part;
  return total;
}

/// Threads that a context really gets: run.threads, or the machine's processors where that is 0.
int thread_count(const RunContext& run);

}  // namespace seamount
