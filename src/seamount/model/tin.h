// A triangulated irregular network: scattered nodes, the triangles between them, and what growth or a survey says of
// each node.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"

namespace seamount {

/// An area of a network that its own outline bounds (P2 sec. 4.5). Regions form a tree; parents stand before children.
struct TinRegion {
  std::string name;
  int parent = -1;                 ///< the region around it; -1: the world outside all regions
  Ring outline;                    ///< counter-clockwise; empty where it is not known
  std::optional<double> height_m;  ///< of its outline, where its author gave one
  bool basin = false;            ///< its inside lies lower than its outline: an endorheic region that the author wants
  std::optional<double> peak_m;  ///< of its summit or, a basin, its deepest place, where its author gave one
  bool operator==(const TinRegion&) const = default;
};

struct Tin {
  /// region[] of a node that lies in none: kept around the regions so that contours can close there.
  static constexpr int32_t kOutside = -1;
  /// bed_m[] of a node off the rivers.
  static constexpr float kNoBed = -std::numeric_limits<float>::infinity();

  GridFrame frame;                                ///< the document's frame; nodes may lie a little beyond it
  std::vector<Vec2> nodes;                        ///< metres
  std::vector<std::array<int32_t, 3>> triangles;  ///< node indices, counter-clockwise
  std::vector<TinRegion> regions;                 ///< empty for a surveyed network
  std::vector<int32_t> region;                    ///< per node: index into regions or kOutside; empty with regions
  std::vector<float> rank;      ///< per node: from its region's lower border (0) to its upper one (1); empty: not grown
  std::vector<float> bed_m;     ///< per node: of the river bed there, kNoBed off the rivers; empty: no rivers
  std::vector<float> height_m;  ///< per node; empty: not assigned yet

  bool operator==(const Tin&) const = default;
};

}  // namespace seamount
