// Many skeletons of one class, asked in bulk: how far is the nearest, which way, how does it bend there, does a place
// lie inside. What the expressions of P3 read as distance, normal, curvature and inside of a class (sec. 1.3.1, 1.5.1).
//
// Exact, by a balanced tree over points and edges. An object that asks for the nearest *other* one of its class names
// its own owner number as excluded.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/skeleton/box_tree.h"
#include "seamount/geom/skeleton/point_edge.h"
#include "seamount/geom/skeleton/ring_rows.h"
#include "seamount/model/skeleton.h"

namespace seamount::geom {

struct NearestSkeleton {
  static constexpr int32_t kNobody = -1;

  double distance = std::numeric_limits<double>::infinity();  ///< metres, to the point, the curve or the outline
  Vec2 at = {};                                               ///< the nearest place of it
  Vec2 normal = {};  ///< unit: from the skeleton to the place, of a region outwards; see below where distance is 0
  double curvature = 0.0;  ///< 1/m at `at`, of curves and regions; 0 of points. Positive where it bends to its left
  int32_t owner = kNobody;
  bool inside = false;  ///< whether the place lies in any region (nearest or not) but the excluded owner's

  bool operator==(const NearestSkeleton&) const = default;
};

/// Curvature is the turn at a vertex over the mean length of its two edges, linear between vertices, constant along
/// the end edges of a curve: of an outline (counter-clockwise) positive on capes and negative in bays. On the skeleton
/// itself the normal is the right-hand normal of the edge (of an outline outwards), of a point {0, 0}. Of several at
/// the same distance the one given first answers. Inside is decided exactly, by the even-odd rule.
class SkeletonIndex {
 public:
  SkeletonIndex() = default;

  /// owners[i] >= 0 is the owner of skeletons[i]; an owner may have several. A skeleton without points counts for
  /// nothing, a curve of one point as that point. About 0.3 us a point. REQUIRES: equal sizes, finite places.
  SkeletonIndex(std::span<const Skeleton> skeletons, std::span<const int32_t> owners);

  /// No skeleton at all: every distance is +infinity.
  bool empty() const { return edges_.empty(); }

  /// `excluded` of the following: nothing, one owner for all places, or one for each; kNobody excludes none. All are
  /// parallel and take about log(points) each, 0.3 us for 10 000 points. REQUIRES: results as long as places.
  void nearest(std::span<const Vec2> places, std::span<const int32_t> excluded, std::span<NearestSkeleton> results,
               const RunContext& run) const;
  void distances(std::span<const Vec2> places, std::span<const int32_t> excluded, std::span<double> results,
                 const RunContext& run) const;
  /// 1 where a place lies in a region.
  void inside(std::span<const Vec2> places, std::span<const int32_t> excluded, std::span<uint8_t> results,
              const RunContext& run) const;
  /// 1 where the distance is at most radius_m; quicker than distances().
  void any_within(std::span<const Vec2> places, std::span<const int32_t> excluded, double radius_m,
                  std::span<uint8_t> results, const RunContext& run) const;

  /// The same for one place.
  NearestSkeleton nearest(Vec2 place, int32_t excluded = NearestSkeleton::kNobody) const;
  bool inside(Vec2 place, int32_t excluded = NearestSkeleton::kNobody) const;

 private:
  struct Source {
    uint32_t number;  ///< in the order given
    int32_t region;   ///< in regions_, -1 for none
    float curvature_a, curvature_b;
  };
  struct Region {
    RingRows rows;
    int32_t owner;
  };
  struct Hit {
    double squared;
    uint32_t edge;
  };

  void add(const Skeleton& skeleton, int32_t owner, std::vector<PointEdge>& edges, std::vector<Source>& sources,
           std::vector<int32_t>& owners);
  void sort_into_tree(const std::vector<PointEdge>& edges, const std::vector<Source>& sources,
                      const std::vector<int32_t>& owners);
  /// The nearest edge nearer than `known`, which is returned unless there is one; any such one if `any`.
  Hit search(Vec2 place, int32_t excluded, Hit known, bool any) const;
  /// The nearest edge, and how far the next one is (squared).
  Hit search_two(Vec2 place, int32_t excluded, double& second) const;
  class Walk;
  NearestSkeleton describe(Vec2 place, int32_t excluded, Hit hit) const;

  BoxTree tree_, region_tree_;
  std::vector<PointEdge> edges_;  ///< in the order of the tree's leaves, as what follows
  std::vector<int32_t> owners_;
  std::vector<Source> sources_;
  std::vector<int32_t> node_owners_;     ///< the one owner of all edges below a node, or kNobody
  std::vector<uint32_t> node_earliest_;  ///< the lowest number of an edge below a node
  std::vector<Region> regions_;
  bool points_only_ = true;
};

}  // namespace seamount::geom
