#include "seamount/geom/water/path_areas.h"

#include <atomic>

#include "seamount/base/parallel.h"

namespace seamount::geom {
namespace {

constexpr int64_t kGrain = 1 << 16;

/// The cell that each cell's water enters next; -1: it ends.
Grid<int32_t> receivers(const FlowDirections& directions, const RunContext& run) {
  const auto steps = flow_steps(directions.width());
  Grid<int32_t> made(directions.frame());
  parallel_blocks(run, static_cast<int64_t>(made.size()), kGrain, [&](int64_t begin, int64_t end) {
    for (int64_t i = begin; i < end; ++i) {
      const uint8_t code = directions.data()[i];
      made.data()[i] = code < kOutlet ? static_cast<int32_t>(i + steps[code]) : -1;
    }
  });
  return made;
}

}  // namespace

Grid<uint32_t> path_areas(const FlowDirections& directions, int doublings, const RunContext& run) {
  RunContext quiet = run;
  quiet.progress = nullptr;
  Grid<int32_t> ahead = receivers(directions, quiet), twice(directions.frame());
  Grid<uint32_t> areas(directions.frame(), 1), sums(directions.frame());
  const auto cells = static_cast<int64_t>(areas.size());
  for (int k = 0; k < doublings; ++k) {
    sums = areas;
    parallel_blocks(quiet, cells, kGrain, [&](int64_t begin, int64_t end) {
      for (int64_t i = begin; i < end; ++i) {
        const int32_t to = ahead.data()[i];
        twice.data()[i] = to < 0 ? -1 : ahead.data()[to];
        // Whole numbers: their sum does not hang on the order.
        if (to >= 0) std::atomic_ref(sums.data()[to]).fetch_add(areas.data()[i], std::memory_order_relaxed);
      }
    });
    std::swap(areas, sums);
    std::swap(ahead, twice);
    run.report((k + 1.0) / doublings);
  }
  return areas;
}

}  // namespace seamount::geom
