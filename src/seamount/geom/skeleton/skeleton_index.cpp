// See skeleton_index.h.
#include "seamount/geom/skeleton/skeleton_index.h"

#include <array>
#include <cmath>

#include "seamount/base/parallel.h"

namespace seamount::geom {
namespace {

constexpr int64_t kPlacesPerBlock = 2048;
constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();
/// A distance below this share of the coordinates is rounding.
constexpr double kOnIt = 1e-14;
constexpr int32_t kNobody = NearestSkeleton::kNobody;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

int32_t excluded_at(std::span<const int32_t> excluded, int64_t i) {
  if (excluded.empty()) return kNobody;
  return excluded[excluded.size() == 1 ? 0 : static_cast<size_t>(i)];
}

/// Signed turn at every vertex over the mean length of the edges beside it.
std::vector<double> curvatures(const Polyline& points, bool closed) {
  const size_t n = points.size();
  std::vector<double> result(n, 0.0);
  if (n < 3) return result;
  for (size_t i = closed ? 0 : 1; i < (closed ? n : n - 1); ++i) {
    const Vec2 in = points[i] - points[(i + n - 1) % n];
    const Vec2 out = points[(i + 1) % n] - points[i];
    const double length = 0.5 * (std::hypot(in.x, in.y) + std::hypot(out.x, out.y));
    if (length > 0.0) result[i] = std::atan2(cross(in, out), dot(in, out)) / length;
  }
  if (!closed) {
    result.front() = result[1];
    result.back() = result[n - 2];
  }
  return result;
}

}  // namespace

SkeletonIndex::SkeletonIndex(std::span<const Skeleton> skeletons, std::span<const int32_t> owners) {
  std::vector<PointEdge> edges;
  std::vector<Source> sources;
  std::vector<int32_t> edge_owners;
  std::vector<Box> boxes;
  for (size_t i = 0; i < skeletons.size(); ++i) {
    const size_t regions = regions_.size();
    add(skeletons[i], owners[i], edges, sources, edge_owners);
    if (regions_.size() > regions) boxes.push_back(bounding_box(skeletons[i].points));
  }
  region_tree_ = BoxTree(boxes);
  sort_into_tree(edges, sources, edge_owners);
}

void SkeletonIndex::add(const Skeleton& skeleton, int32_t owner, std::vector<PointEdge>& edges,
                        std::vector<Source>& sources, std::vector<int32_t>& owners) {
  const Polyline& points = skeleton.points;
  const size_t n = points.size();
  const bool closed = skeleton.kind == SkeletonKind::region && n >= 2;
  int32_t region = -1;
  if (skeleton.kind == SkeletonKind::region && n >= 3) {
    region = static_cast<int32_t>(regions_.size());
    regions_.push_back({RingRows(points), owner});
  }
  const auto push = [&](Vec2 a, Vec2 b, double bend_a, double bend_b) {
    edges.push_back(PointEdge::between(a, b));
    points_only_ = points_only_ && edges.back().inverse == 0.0;
    sources.push_back(
        {static_cast<uint32_t>(sources.size()), region, static_cast<float>(bend_a), static_cast<float>(bend_b)});
    owners.push_back(owner);
  };
  if (skeleton.kind == SkeletonKind::point || n == 1) {
    for (const Vec2 p : points) push(p, p, 0.0, 0.0);
    return;
  }
  const std::vector<double> bends = curvatures(points, closed);
  for (size_t i = 0; i + 1 < n + (closed ? 1 : 0); ++i) {
    const size_t j = (i + 1) % n;
    push(points[i], points[j], bends[i], bends[j]);
  }
}

void SkeletonIndex::sort_into_tree(const std::vector<PointEdge>& edges, const std::vector<Source>& sources,
                                   const std::vector<int32_t>& owners) {
  std::vector<Box> boxes(edges.size());
  for (size_t i = 0; i < edges.size(); ++i) {
    const Vec2 a = edges[i].a, b = a + edges[i].along;
    boxes[i] = {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
  }
  tree_ = BoxTree(boxes);
  for (const uint32_t i : tree_.order()) {
    edges_.push_back(edges[i]);
    sources_.push_back(sources[i]);
    owners_.push_back(owners[i]);
  }
  const auto& nodes = tree_.nodes();
  node_owners_.assign(nodes.size(), kNobody);
  node_earliest_.assign(nodes.size(), kNone);
  for (size_t i = nodes.size(); i-- > 0;) {
    if (nodes[i].count == 0) {
      const int32_t owner = node_owners_[i + 1];
      node_owners_[i] = owner == node_owners_[nodes[i].first] ? owner : kNobody;
      node_earliest_[i] = std::min(node_earliest_[i + 1], node_earliest_[nodes[i].first]);
      continue;
    }
    node_owners_[i] = owners_[nodes[i].first];
    for (uint32_t k = nodes[i].first; k < nodes[i].first + nodes[i].count; ++k) {
      if (owners_[k] != node_owners_[i]) node_owners_[i] = kNobody;
      node_earliest_[i] = std::min(node_earliest_[i], sources_[k].number);
    }
  }
}

SkeletonIndex::Hit SkeletonIndex::search(Vec2 place, int32_t excluded, Hit known, bool any) const {
  // A hair is allowed for, by which rounding may make a box seem further away than what lies in it.
  constexpr double kHair = 1.0 - 1e-12;
  Hit best = known;
  uint32_t earliest = known.edge == kNone ? kNone : sources_[known.edge].number;
  const auto& nodes = tree_.nodes();
  if (nodes.empty()) return best;
  struct Waiting {
    double squared;
    uint32_t node;
  };
  const auto waiting_at = [&](uint32_t node) { return Waiting{squared_distance(nodes[node], place), node}; };
  const auto comes_first = [&](const Waiting& a, const Waiting& b) {
    return a.squared < b.squared || (a.squared == b.squared && node_earliest_[a.node] < node_earliest_[b.node]);
  };
  std::array<Waiting, BoxTree::kDepth> stack;
  size_t waiting = 0;
  stack[waiting++] = waiting_at(0);
  while (waiting > 0) {
    const Waiting next = stack[--waiting];
    if (next.squared * kHair > best.squared) continue;
    if (next.squared >= best.squared && node_earliest_[next.node] > earliest) continue;
    if (excluded != kNobody && node_owners_[next.node] == excluded) continue;
    const BoxTree::Node& node = nodes[next.node];
    if (node.count == 0) {
      Waiting near = waiting_at(next.node + 1), far = waiting_at(node.first);
      if (comes_first(far, near)) std::swap(near, far);
      stack[waiting++] = far;
      stack[waiting++] = near;
      continue;
    }
    for (uint32_t k = node.first; k < node.first + node.count; ++k) {
      if (excluded != kNobody && owners_[k] == excluded) continue;
      const double squared = edges_[k].squared_distance(place);
      if (squared > best.squared || (squared == best.squared && sources_[k].number > earliest)) continue;
      best = {squared, k};
      earliest = sources_[k].number;
      if (any) return best;
    }
  }
  return best;
}

SkeletonIndex::Hit SkeletonIndex::search_two(Vec2 place, int32_t excluded, double& second) const {
  constexpr double kHair = 1.0 - 1e-12;
  Hit best = {kInfinity, kNone};
  second = kInfinity;
  const auto& nodes = tree_.nodes();
  if (nodes.empty()) return best;
  struct Waiting {
    double squared;
    uint32_t node;
  };
  std::array<Waiting, BoxTree::kDepth> stack;
  size_t waiting = 0;
  stack[waiting++] = {squared_distance(nodes[0], place), 0};
  while (waiting > 0) {
    const Waiting next = stack[--waiting];
    if (next.squared * kHair > second) continue;
    const BoxTree::Node& node = nodes[next.node];
    if (node.count == 0) {
      Waiting near = {squared_distance(nodes[next.node + 1], place), next.node + 1};
      Waiting far = {squared_distance(nodes[node.first], place), node.first};
      if (far.squared < near.squared) std::swap(near, far);
      stack[waiting++] = far;
      stack[waiting++] = near;
      continue;
    }
    for (uint32_t k = node.first; k < node.first + node.count; ++k) {
      if (excluded != kNobody && owners_[k] == excluded) continue;
      const double squared = edges_[k].squared_distance(place);
      if (squared > second) continue;
      const bool nearer =
          squared < best.squared || (squared == best.squared && sources_[k].number < sources_[best.edge].number);
      second = nearer ? best.squared : squared;
      if (nearer) best = {squared, k};
    }
  }
  return best;
}

/// Answers for one place after another. Where those lie close together the answer for one bounds that for the next: a
/// point stays the nearest as long as no other can have come nearer, so that most need no search.
class SkeletonIndex::Walk {
 public:
  explicit Walk(const SkeletonIndex& index) : index_(index) {}

  /// `next`: where it will be asked afterwards.
  Hit at(Vec2 place, int32_t excluded, Vec2 next) {
    Hit known = {kInfinity, kNone};
    if (last_.edge != kNone && (excluded == kNobody || index_.owners_[last_.edge] != excluded))
      known = {index_.edges_[last_.edge].squared_distance(place), last_.edge};
    if (known.edge != kNone && excluded == excluded_ && second_ > 0.0) {
      const Vec2 off = place - from_;
      const double others = second_ - std::sqrt(dot(off, off));
      if (others > 0.0 && known.squared < kSurely * others * others) return known;
    }
    const Vec2 step = next - place;
    const bool stays = index_.points_only_ && known.squared < kInfinity && dot(step, step) < 0.1 * known.squared;
    second_ = 0.0;
    if (stays) {
      last_ = index_.search_two(place, excluded, second_);
      second_ = std::sqrt(second_);
    } else {
      last_ = index_.search(place, excluded, known, false);
    }
    from_ = place;
    excluded_ = excluded;
    return last_;
  }

 private:
  static constexpr double kSurely = 1.0 - 1e-9;  ///< more than rounding can make of distances

  const SkeletonIndex& index_;
  Hit last_ = {kInfinity, kNone};
  double second_ = 0.0;  ///< at `from_`, all but the nearest are at least so far; 0: nothing is known
  Vec2 from_;
  int32_t excluded_ = kNobody;
};

NearestSkeleton SkeletonIndex::nearest(Vec2 place, int32_t excluded) const {
  return describe(place, excluded, search(place, excluded, {kInfinity, kNone}, false));
}

NearestSkeleton SkeletonIndex::describe(Vec2 place, int32_t excluded, Hit hit) const {
  NearestSkeleton result;
  if (hit.edge == kNone) return result;
  const PointEdge& edge = edges_[hit.edge];
  const Source& source = sources_[hit.edge];
  const double share = edge.share_nearest(place);
  result.distance = std::sqrt(hit.squared);
  result.at = edge.a + share * edge.along;
  result.curvature =
      (1.0 - share) * static_cast<double>(source.curvature_a) + share * static_cast<double>(source.curvature_b);
  result.owner = owners_[hit.edge];
  if (result.distance > kOnIt * (std::abs(place.x) + std::abs(place.y))) {
    const Vec2 off = place - result.at;
    const bool within = source.region >= 0 && regions_[static_cast<size_t>(source.region)].rows.contains(place);
    result.normal = ((within ? -1.0 : 1.0) / std::hypot(off.x, off.y)) * off;
  } else {
    const double scale = std::sqrt(edge.inverse);
    result.normal = {edge.along.y * scale, -edge.along.x * scale};
  }
  result.inside = inside(place, excluded);
  return result;
}

bool SkeletonIndex::inside(Vec2 place, int32_t excluded) const {
  const auto& nodes = region_tree_.nodes();
  if (nodes.empty()) return false;
  std::array<uint32_t, BoxTree::kDepth> stack;
  size_t waiting = 0;
  stack[waiting++] = 0;
  while (waiting > 0) {
    const uint32_t number = stack[--waiting];
    const BoxTree::Node& node = nodes[number];
    if (squared_distance(node, place) > 0.0) continue;
    if (node.count == 0) {
      stack[waiting++] = node.first;
      stack[waiting++] = number + 1;
      continue;
    }
    for (uint32_t k = node.first; k < node.first + node.count; ++k) {
      const Region& region = regions_[region_tree_.order()[k]];
      if ((excluded == kNobody || region.owner != excluded) && region.rows.contains(place)) return true;
    }
  }
  return false;
}

void SkeletonIndex::nearest(std::span<const Vec2> places, std::span<const int32_t> excluded,
                            std::span<NearestSkeleton> results, const RunContext& run) const {
  parallel_blocks(run, static_cast<int64_t>(places.size()), kPlacesPerBlock, [&](int64_t begin, int64_t end) {
    Walk walk(*this);
    for (int64_t i = begin; i < end; ++i) {
      const Vec2 place = places[static_cast<size_t>(i)];
      const int32_t self = excluded_at(excluded, i);
      const Hit hit = walk.at(place, self, places[static_cast<size_t>(std::min(i + 1, end - 1))]);
      results[static_cast<size_t>(i)] = describe(place, self, hit);
    }
  });
}

void SkeletonIndex::distances(std::span<const Vec2> places, std::span<const int32_t> excluded,
                              std::span<double> results, const RunContext& run) const {
  parallel_blocks(run, static_cast<int64_t>(places.size()), kPlacesPerBlock, [&](int64_t begin, int64_t end) {
    Walk walk(*this);
    for (int64_t i = begin; i < end; ++i) {
      const Vec2 place = places[static_cast<size_t>(i)];
      const int32_t self = excluded_at(excluded, i);
      const Hit hit = walk.at(place, self, places[static_cast<size_t>(std::min(i + 1, end - 1))]);
      results[static_cast<size_t>(i)] = std::sqrt(hit.squared);
    }
  });
}

void SkeletonIndex::inside(std::span<const Vec2> places, std::span<const int32_t> excluded, std::span<uint8_t> results,
                           const RunContext& run) const {
  parallel_blocks(run, static_cast<int64_t>(places.size()), kPlacesPerBlock, [&](int64_t begin, int64_t end) {
    for (int64_t i = begin; i < end; ++i) {
      results[static_cast<size_t>(i)] = inside(places[static_cast<size_t>(i)], excluded_at(excluded, i)) ? 1 : 0;
    }
  });
}

void SkeletonIndex::any_within(std::span<const Vec2> places, std::span<const int32_t> excluded, double radius_m,
                               std::span<uint8_t> results, const RunContext& run) const {
  parallel_blocks(run, static_cast<int64_t>(places.size()), kPlacesPerBlock, [&](int64_t begin, int64_t end) {
    for (int64_t i = begin; i < end; ++i) {
      const Hit hit =
          search(places[static_cast<size_t>(i)], excluded_at(excluded, i), {radius_m * radius_m, kNone}, true);
      results[static_cast<size_t>(i)] = hit.edge != kNone ? 1 : 0;
    }
  });
}

}  // namespace seamount::geom
