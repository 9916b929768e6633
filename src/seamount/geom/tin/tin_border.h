// Where a triangulated network ends.
#pragma once

#include <cstdint>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/tin.h"

namespace seamount::geom {

/// The rings of nodes along the edges that belong to one triangle only, triangles on the left: counter-clockwise around
/// the network, clockwise around holes in it. Rings that meet at a node stay apart. REQUIRES: triangles name nodes that
/// exist. Where more than two triangles share an edge, rings may be left out. Linear in the triangles plus n log n in
/// the border's length.
std::vector<std::vector<int32_t>> border_rings(const Tin& tin, const RunContext& run = {});

/// Takes out triangles until the network is nowhere joined by a node alone: of the parts that meet there the one of the
/// most triangles about the node stays. Linear, where few nodes are such.
void open_pinches(Tin& tin, const RunContext& run = {});

}  // namespace seamount::geom
