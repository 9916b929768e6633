// A channel network: the cells through which enough water passes, cut at confluences into links with their stream order
// (Strahler 1957).
#pragma once

#include <cstdint>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/water/flow.h"
#include "seamount/model/grid.h"

namespace seamount::hydrology {

/// A reach between two confluences.
struct Link {
  std::vector<int32_t> cells;  ///< downstream; the last is the confluence or the end of flow, and the next link's first
  int order = 1;               ///< 1 without tributaries; one more than the highest of them where two of it meet
  int next = -1;               ///< link downstream; -1: flow ends
  double drained = 0.0;        ///< accumulation just above its lower end
};

/// The links of the cells whose accumulation is at least `threshold`, every link after those that feed it. Flow ends at
/// outlets, at pits, and where `mask` (null: nowhere) is 0. Linear.
std::vector<Link> find_links(const geom::FlowDirections& directions, const ScalarField& accumulation, double threshold,
                             const Grid<uint8_t>* mask, const RunContext& run);

/// Number of streams of each order, from order 1 on: links of one order that follow each other are one stream.
std::vector<int> streams_by_order(const std::vector<Link>& links);

}  // namespace seamount::hydrology
