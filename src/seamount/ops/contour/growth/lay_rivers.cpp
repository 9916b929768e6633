// Rivers as nodes of a network (rivers.h).
#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "seamount/ops/contour/growth/rivers.h"

namespace seamount::contour {
namespace {

constexpr double kRoom = 0.6;        ///< spacings that other nodes keep from the courses
constexpr double kMinStep = 0.45;    ///< spacings between nodes of courses that meet
constexpr double kBeyond = 1.5;      ///< spacings that courses go on beyond the domain's edge
constexpr double kFloorRise = 1e-3;  ///< of the valley floor away from the course, m/m

double length(Vec2 a) { return std::sqrt(dot(a, a)); }

/// Places by square cells: who is near a place.
class Cells {
 public:
  explicit Cells(double cell_m) : cell_m_(cell_m) {}

  void add(Vec2 p, int32_t item) { items_[packed(key(p))].emplace_back(p, item); }

  template <class Visit>
  void for_each_near(Vec2 p, double radius, Visit&& visit) const {
    const auto [left, low] = key(p - Vec2{radius, radius});
    const auto [right, high] = key(p + Vec2{radius, radius});
    for (int64_t y = low; y <= high; ++y) {
      for (int64_t x = left; x <= right; ++x) {
        const auto found = items_.find(packed({x, y}));
        if (found == items_.end()) continue;
        for (const auto& [place, item] : found->second) {
          const double distance = length(place - p);
          if (distance <= radius) visit(item, distance);
        }
      }
    }
  }

 private:
  std::pair<int64_t, int64_t> key(Vec2 p) const {
    return {static_cast<int64_t>(std::floor(p.x / cell_m_)), static_cast<int64_t>(std::floor(p.y / cell_m_))};
  }

  static uint64_t packed(std::pair<int64_t, int64_t> cell) {
    return (static_cast<uint64_t>(cell.first) << 32) ^ (static_cast<uint64_t>(cell.second) & 0xffffffffU);
  }

  double cell_m_;
  std::unordered_map<uint64_t, std::vector<std::pair<Vec2, int32_t>>> items_;  // looked up, never walked
};

bool beyond(const GridFrame& frame, Vec2 p) {
  return p.x < frame.west_m || p.x > frame.east_m() || p.y < frame.south_m() || p.y > frame.north_m;
}

struct BedPoint {
  Vec2 place;
  double bed_m;
  double half_m;
};

/// Nodes of the courses in the regions, and a little beyond the domain's edge. Joined rivers come first, so that a
/// tributary begins beside the river that it flows to.
std::vector<BedPoint> bed_points(const std::vector<River>& rivers, const RegionTree& tree, const GridFrame& domain,
                                 double spacing_m, Cells& cells) {
  std::vector<BedPoint> points;
  const double least = kMinStep * spacing_m;
  for (const River& river : rivers) {
    std::vector<Vec2> places;
    places.reserve(river.points.size());
    for (const Vec2 p : river.points) {
      places.push_back(
          {std::clamp(p.x, domain.west_m, domain.east_m()), std::clamp(p.y, domain.south_m(), domain.north_m)});
    }
    const std::vector<int32_t> region = regions_at(tree, places, {});
    for (size_t i = river.points.size(); i-- > 0;) {
      bool free = region[i] >= 0 && length(river.points[i] - places[i]) <= kBeyond * spacing_m;
      cells.for_each_near(river.points[i], least, [&](int32_t, double) { free = false; });
      if (!free) continue;
      cells.add(river.points[i], static_cast<int32_t>(points.size()));
      points.push_back({river.points[i], river.bed_m[i], river.half_m[i]});
    }
  }
  return points;
}

}  // namespace

std::vector<float> lay_rivers(const std::vector<River>& rivers, const RegionTree& tree, const GridFrame& domain,
                              double spacing_m, geom::DiscSampling& discs) {
  if (rivers.empty()) return {};
  Cells cells(spacing_m);
  const std::vector<BedPoint> course = bed_points(rivers, tree, domain, spacing_m, cells);
  std::erase_if(discs.points, [&](geom::LatticePoint p) {
    bool near = false;
    cells.for_each_near(discs.lattice.place(p), kRoom * spacing_m, [&](int32_t, double) { near = true; });
    return near;
  });

  std::vector<geom::LatticePoint> points = std::move(discs.points);
  std::vector<float> beds(points.size(), Tin::kNoBed);
  const bool has_floor = std::any_of(course.begin(), course.end(), [](const BedPoint& b) { return b.half_m > 0.0; });
  if (has_floor) {
    Cells nodes(spacing_m);
    for (size_t i = 0; i < points.size(); ++i) nodes.add(discs.lattice.place(points[i]), static_cast<int32_t>(i));
    std::vector<double> nearest(points.size(), HUGE_VAL);
    for (const BedPoint& b : course) {
      nodes.for_each_near(b.place, b.half_m, [&](int32_t node, double distance) {
        const auto n = static_cast<size_t>(node);
        if (distance >= nearest[n]) return;
        nearest[n] = distance;
        beds[n] = static_cast<float>(b.bed_m + kFloorRise * distance);
      });
    }
  }
  for (const BedPoint& b : course) {
    const Vec2 at = b.place - discs.lattice.origin;
    const double x = std::round(at.x / discs.lattice.unit_m);
    const double y = std::round(at.y / discs.lattice.unit_m);
    if (!(x >= 0 && y >= 0 && x < geom::kLatticeEnd && y < geom::kLatticeEnd)) continue;
    points.push_back({static_cast<int32_t>(x), static_cast<int32_t>(y)});
    beds.push_back(static_cast<float>(b.bed_m));
  }
  std::vector<float> ordered;
  discs.points.clear();
  for (const int32_t i : geom::spatial_order(points)) {
    discs.points.push_back(points[static_cast<size_t>(i)]);
    ordered.push_back(beds[static_cast<size_t>(i)]);
  }
  return ordered;
}

RiverNodes keep_river_nodes(Tin& tin) {
  RiverNodes nodes;
  const auto bed = [&](int32_t i) { return tin.bed_m[static_cast<size_t>(i)]; };
  for (size_t i = 0; i < tin.bed_m.size(); ++i) {
    const int32_t region = tin.region[i];
    if (region < 0 || tin.regions[static_cast<size_t>(region)].basin) tin.bed_m[i] = Tin::kNoBed;
    if (tin.bed_m[i] == Tin::kNoBed) continue;
    nodes.upstream.push_back(static_cast<int32_t>(i));
    if (beyond(tin.frame, tin.nodes[i])) nodes.outlets.push_back(static_cast<int32_t>(i));
  }
  std::sort(nodes.upstream.begin(), nodes.upstream.end(),
            [&](int32_t a, int32_t b) { return std::tuple(bed(a), a) < std::tuple(bed(b), b); });
  return nodes;
}

}  // namespace seamount::contour
