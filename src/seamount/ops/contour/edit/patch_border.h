// Contours cut at the border of a patch (patch.h).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/contour_set.h"
#include "seamount/ops/contour/edit/patch.h"

namespace seamount::contour {

/// Where a contour crosses the patch's border.
struct BorderCut {
  Vec2 at;
  double height_m;
  int64_t edge;       ///< key of the lattice edge that it lies on
  double along;       ///< from the edge's first node (west or north) to the other, in (0, 1)
  bool enters;        ///< the contour goes into the patch here
  bool first_higher;  ///< higher ground lies towards the edge's first node
};

/// What stays outside of a contour that crosses the border: from the cut where it leaves to the one where it enters.
struct OuterPiece {
  size_t from, to;   ///< cuts
  Polyline between;  ///< the contour's points between them
};

struct CutContours {
  std::vector<BorderCut> cuts;
  std::map<int64_t, std::vector<size_t>> on_edge;  ///< cuts of each border edge that has any, in their order along it
  std::vector<OuterPiece> pieces;
  std::vector<Contour> whole;  ///< contours wholly outside
};

/// Key of the edge from node (x, y) to the east or to the south.
int64_t edge_key(const Patch& patch, int x, int y, bool south);

/// Nothing where two cuts, or a cut and a node, fall on one place: the lattice has to be shifted.
std::optional<CutContours> cut_contours(const ContourSet& set, const Patch& patch, const RunContext& run);

}  // namespace seamount::contour
