// The profile of a terrain along a row or a column of cells as a polyline: where two blocks of a mesh meet, both take
// its vertices, so it depends on the profile alone. The cell that is farthest from the line becomes a vertex, and
// again.
#pragma once

#include <cstdint>
#include <queue>
#include <tuple>
#include <vector>

#include "seamount/geom/mesh/mesh_domain.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

class EdgeFit {
 public:
  /// From one cell to another in its row or column, its ends. REQUIRES: they differ; heights and domain outlive this.
  EdgeFit(const HeightField& heights, const MeshDomain& domain, LatticePoint from, LatticePoint to);

  LatticePoint from() const { return from_; }
  LatticePoint to() const { return to_; }

  /// The first vertices: the ends and rim cells where the domain holds them, and `more` of its cells. A frozen edge
  /// takes no others.
  void start(std::vector<LatticePoint> more, bool frozen);

  /// Adds vertices while the profile departs by more than error_m, at most so many. They are appended to vertices().
  void refine(double error_m, int64_t most);

  double error_m() const { return spans_.empty() ? 0.0 : std::get<0>(spans_.top()); }
  const std::vector<LatticePoint>& vertices() const { return vertices_; }

 private:
  using Span = std::tuple<double, int, int, int>;  ///< largest error, where, between which steps along the edge
  LatticePoint cell(int step) const;
  void measure(int first, int last);

  const HeightField& heights_;
  const MeshDomain& domain_;
  LatticePoint from_, to_;
  int length_, dx_, dy_;
  std::vector<LatticePoint> vertices_;
  std::priority_queue<Span> spans_;
};

}  // namespace seamount::geom
