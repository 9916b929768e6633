// What objects make of the ground, as coarse shapes of the distance to their skeletons (P3 sec. 1.6.2, eq. 1.46-1.49).
//
// The shapes are in proxy_profile.h.
//
// Groups join as in the paper, object by object in their order:
//   G = smax of the ground and grounded shapes, A = smin of altitude shapes, H* = smax(G, A) + sum of surface shapes.
// At the end of its footprint (from the reach on, over a quarter of it) a shape fades with a weight w, so that the
// surface is continuous everywhere: a grounded one to ground + w (shape - ground) - (1 / w - 1) / (2 k), which does not
// count; altitude ones join as if each were there with chance w, and smax(G, A) as if any were, 1 - prod(1 - w).
//
// The blend 1 / (2 k) is blend_m, or a tenth of the shape's size where that is less: a pebble does not lift the ground
// by a metre.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/skeleton/box_tree.h"
#include "seamount/geom/skeleton/proxy_profile.h"
#include "seamount/geom/skeleton/skeleton_index.h"
#include "seamount/model/grid.h"
#include "seamount/model/skeleton.h"

namespace seamount::geom {

class HeightProxies {
 public:
  /// Skeletons and effects belong together one by one, and need not outlive this. Throws InvalidArgument as above.
  HeightProxies(std::span<const Skeleton> skeletons, std::span<const HeightEffect> effects, const ProxyGround& ground);

  /// H* at every cell's centre. Parallel over tiles, the same bytes for any number of threads; cost: cells under
  /// footprints, about 5 ns each for points and 30 ns for curves and regions.
  HeightField over(const HeightField& ground, const RunContext& run) const;

  /// Takes heights of the ground at places to H* there, as over() does for cells. About 0.5 us a place and shape.
  void over(std::span<const Vec2> places, std::span<double> heights, const RunContext& run) const;

 private:
  struct Object {
    ProxyProfile profile;
    std::vector<PointEdge> edges;
    std::shared_ptr<const RingRows> rows;         ///< of a region whose inside counts
    std::shared_ptr<const SkeletonIndex> search;  ///< where edges are many
    Box reach;
  };
  class Tile;
  double distance(const Object& object, Vec2 place) const;

  std::vector<Object> objects_;
  BoxTree tree_;
};

}  // namespace seamount::geom
