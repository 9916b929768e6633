// Contours made anew within a patch of the plane and joined to those outside it.
//
// The patch is a set of squares of a lattice. Contours outside are cut at its border, which is where their heights are
// known exactly; squares are split into triangles about their middle, with a corner at every such place, so that the
// contours of the new ground reach the border exactly where those outside end. Contours of one surface of triangles
// cannot cross (P2 sec. 4.4), so the whole nests by construction; it is checked all the same.
#pragma once

#include <string>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/contour_set.h"
#include "seamount/model/grid.h"

namespace seamount::contour {

/// Squares between the cell centres of a frame: square (x, y) has the nodes (x, y), (x + 1, y), (x, y + 1),
/// (x + 1, y + 1).
struct Patch {
  GridFrame nodes;
  Grid<uint8_t> squares;  ///< (width - 1) x (height - 1); 1: belongs to the patch. None at the lattice's edge

  explicit Patch(const GridFrame& frame);
  bool has(int x, int y) const { return squares.contains(x, y) && squares(x, y) != 0; }
  /// Is the node a corner of the patch's border?
  bool at_border(int x, int y) const;
};

/// Can the set be cut at the patch's border: does no contour pass through a node, nor two through one place?
bool is_clear(const Patch& patch, const ContourSet& set, const RunContext& run);

/// Replaces all contours within the patch by those of `heights` at `levels` (ascending); loops of less than two squares
/// are left out. At nodes of the border `heights` must be what lattice_heights() finds for the set. `name` stands in
/// messages. Throws InvalidArgument{name} where a contour outside has nothing to be joined to because its neighbours'
/// levels are missing. Ends of contours without a counterpart outside are dropped with their line. REQUIRES:
/// is_clear(). n log n in the set's points and the patch's nodes.
void replace_patch(ContourSet& set, const Patch& patch, const ScalarField& heights, const std::vector<double>& levels,
                   const std::string& name, const RunContext& run);

}  // namespace seamount::contour
