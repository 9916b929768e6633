#include "seamount/ops/contour/growth/sea_nodes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "seamount/geom/grid/resample.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/tin/delaunay.h"

namespace seamount::contour {
namespace {

size_t at(int32_t i) { return static_cast<size_t>(i); }

constexpr double kWidening = 1.0 / 3;   ///< of the spacing, per metre from the dense sea
constexpr double kCoarsest = 1.0 / 40;  ///< of the domain's shorter side
constexpr double kRoom = 0.7;           ///< spacings that nodes keep from denser ones
constexpr double kJitter = 0.28;        ///< of nodes about the centres of squares, in spacings
constexpr int kDistanceCells = 256;     ///< along the domain's longer side

/// How far from the land a place of the domain is; one beyond the edge counts as the nearest place in it.
class LandDistance {
 public:
  LandDistance(const RegionTree& tree, const GridFrame& domain, const RunContext& run) {
    std::vector<Polygon> areas;
    for (const GrowthRegion& region : tree.regions) {
      if (region.parent < 0) areas.push_back({region.outline, {}});
    }
    GridFrame frame = domain;
    frame.cell_m = std::max(domain.width_m(), domain.height_m()) / kDistanceCells;
    frame.width = std::max(1, static_cast<int>(std::ceil(domain.width_m() / frame.cell_m)));
    frame.height = std::max(1, static_cast<int>(std::ceil(domain.height_m() / frame.cell_m)));
    distance_ = geom::signed_distance(areas, frame, run);
  }

  double operator()(Vec2 p) const {
    const GridFrame& f = distance_.frame();
    return static_cast<double>(geom::sample_bilinear(distance_, f.column(p.x), f.row(p.y)));
  }

  bool has_sea() const {
    return std::any_of(distance_.cells().begin(), distance_.cells().end(), [](float d) { return d > 0.0F; });
  }

 private:
  ScalarField distance_;
};

/// Places by square cells, for whether any lies near a place.
class NearPlaces {
 public:
  NearPlaces(std::vector<Vec2> places, Vec2 low, double cell_m) : low_(low), cell_m_(cell_m) {
    for (const Vec2 p : places) places_.emplace_back(key(p.x - low_.x, p.y - low_.y), p);
    std::sort(places_.begin(), places_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  }

  /// REQUIRES: radius at most a cell.
  bool any(Vec2 p, double radius) const {
    for (int dy = -1; dy <= 1; ++dy) {
      const double y = p.y - low_.y + dy * cell_m_;
      const uint64_t first = key(p.x - low_.x - cell_m_, y), last = key(p.x - low_.x + cell_m_, y);
      auto place = std::lower_bound(places_.begin(), places_.end(), first,
                                    [](const auto& item, uint64_t value) { return item.first < value; });
      for (; place != places_.end() && place->first <= last; ++place) {
        const Vec2 d = place->second - p;
        if (dot(d, d) < radius * radius) return true;
      }
    }
    return false;
  }

 private:
  uint64_t key(double x, double y) const {
    const auto cell = [&](double v) {
      return static_cast<uint64_t>(static_cast<int64_t>(std::floor(v / cell_m_)) + 8);
    };
    return (cell(y) << 32) + cell(x);
  }

  Vec2 low_;
  double cell_m_;
  std::vector<std::pair<uint64_t, Vec2>> places_;
};

/// The domain with room around it, but no more than the lattice holds beside the sampling.
geom::Box sea_box(const GridFrame& domain, const geom::DiscSampling& discs, double spacing_m, double coarsest_m) {
  const double room = 2.0 * coarsest_m;
  Vec2 low = discs.lattice.origin, high = low;
  for (const geom::LatticePoint p : discs.points) {
    const Vec2 place = discs.lattice.place(p);
    high = {std::max(high.x, place.x), std::max(high.y, place.y)};
  }
  const double most = 0.98 * geom::kMostDiscsAcross * spacing_m;
  const Vec2 spare = {std::max(0.0, 0.5 * (most - (high.x - low.x))), std::max(0.0, 0.5 * (most - (high.y - low.y)))};
  return {{std::max(domain.west_m - room, low.x - spare.x), std::max(domain.south_m() - room, low.y - spare.y)},
          {std::min(domain.east_m() + room, high.x + spare.x), std::min(domain.north_m + room, high.y + spare.y)}};
}

void move_origin(geom::DiscSampling& discs, Vec2 low) {
  const double unit = discs.lattice.unit_m;
  const auto steps = [&](double from, double to) {
    return static_cast<int32_t>(std::max(0.0, std::ceil((from - to) / unit) + 1.0));
  };
  const int32_t dx = steps(discs.lattice.origin.x, low.x), dy = steps(discs.lattice.origin.y, low.y);
  for (geom::LatticePoint& p : discs.points) p = {p.x + dx, p.y + dy};
  discs.lattice.origin = discs.lattice.origin - Vec2{unit * dx, unit * dy};
}

/// Beyond which sides of the frame a place lies, a bit each.
uint8_t sides_beyond(const GridFrame& f, Vec2 p) {
  return static_cast<uint8_t>((p.x < f.west_m ? 1 : 0) + (p.x > f.east_m() ? 2 : 0) + (p.y < f.south_m() ? 4 : 0) +
                              (p.y > f.north_m ? 8 : 0));
}

/// Has the triangle a side far longer than its densest corner's neighbours are away?
bool is_long(const Tin& tin, const geom::Triangle& t, const std::vector<int32_t>& wide, double spacing_m) {
  constexpr double kLongest = 2.5;
  const size_t dense = tin.nodes.size() - wide.size();
  int32_t densest = std::numeric_limits<int32_t>::max();
  double longest = 0.0;
  for (size_t k = 0; k < 3; ++k) {
    densest = std::min(densest, at(t[k]) >= dense ? wide[at(t[k]) - dense] : 1);
    const Vec2 side = tin.nodes[at(t[(k + 1) % 3])] - tin.nodes[at(t[k])];
    longest = std::max(longest, dot(side, side));
  }
  const double most = kLongest * spacing_m * densest;
  return longest > most * most;
}

}  // namespace

std::vector<int32_t> add_sea_nodes(const RegionTree& tree, const GridFrame& domain, double spacing_m, Seed seed,
                                   geom::DiscSampling& discs, const RunContext& run) {
  const LandDistance distance(tree, domain, run);
  std::vector<int32_t> wide;
  if (!distance.has_sea()) return wide;
  const double coarsest = kCoarsest * std::min(domain.width_m(), domain.height_m());
  const auto from = [&](int32_t scale) { return (kDenseSea + (scale - 2) / kWidening) * spacing_m; };
  const auto is_last = [&](int32_t scale) { return 2 * scale * spacing_m > coarsest; };
  const double widest = std::max(coarsest, 2.0 * spacing_m);
  const geom::Box box = sea_box(domain, discs, spacing_m, widest);
  move_origin(discs, box.low);

  std::vector<Vec2> denser;
  for (const geom::LatticePoint p : discs.points) {
    const Vec2 place = discs.lattice.place(p);
    if (distance(place) > from(2) - 4.0 * spacing_m) denser.push_back(place);
  }
  for (int32_t scale = 2;; scale *= 2) {
    run.check_cancelled();
    const double step = scale * spacing_m;
    const double begin = from(scale) - step, end = is_last(scale) ? HUGE_VAL : from(2 * scale);
    const NearPlaces near(std::move(denser), box.low, step);
    denser.clear();
    Rng rng(seed.derive("sea", static_cast<uint64_t>(scale)));
    for (double y = box.low.y + 0.5 * step; y < box.high.y; y += step) {
      run.check_cancelled();
      for (double x = box.low.x + 0.5 * step; x < box.high.x; x += step) {
        const Vec2 p = {x + step * rng.uniform(-kJitter, kJitter), y + step * rng.uniform(-kJitter, kJitter)};
        const double away = distance(p);
        if (away < begin || away >= end || near.any(p, kRoom * step)) continue;
        const Vec2 at = p - discs.lattice.origin;
        denser.push_back(p);
        wide.push_back(scale);
        discs.points.push_back({static_cast<int32_t>(std::lround(at.x / discs.lattice.unit_m)),
                                static_cast<int32_t>(std::lround(at.y / discs.lattice.unit_m))});
      }
    }
    if (is_last(scale)) return wide;
  }
}

void drop_slivers(Tin& tin, const std::vector<int32_t>& wide, double spacing_m) {
  std::vector<uint8_t> beyond(tin.nodes.size());
  for (size_t node = 0; node < beyond.size(); ++node) beyond[node] = sides_beyond(tin.frame, tin.nodes[node]);
  using Side = std::pair<int32_t, int32_t>;
  const auto side = [](const geom::Triangle& t, size_t k) {
    return Side(std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3]));
  };
  std::vector<std::pair<Side, int>> sides;  // beyond the edge, and of how many triangles each is
  std::vector<size_t> slivers;
  for (size_t i = 0; i < tin.triangles.size(); ++i) {
    const geom::Triangle& t = tin.triangles[i];
    if (beyond[at(t[0])] == 0 && beyond[at(t[1])] == 0) continue;
    for (size_t k = 0; k < 3; ++k) {
      if (beyond[at(t[k])] != 0 && beyond[at(t[(k + 1) % 3])] != 0) sides.emplace_back(side(t, k), 1);
    }
    if ((beyond[at(t[0])] & beyond[at(t[1])] & beyond[at(t[2])]) == 0) continue;
    if (is_long(tin, t, wide, spacing_m)) slivers.push_back(i);
  }
  std::sort(sides.begin(), sides.end());
  for (size_t i = 1; i < sides.size(); ++i) {
    if (sides[i].first == sides[i - 1].first) sides[i].second = sides[i - 1].second = 2;
  }
  const auto triangles_of = [&](const Side& s) -> std::pair<Side, int>& {
    return *std::lower_bound(sides.begin(), sides.end(), s, [](const auto& a, const Side& b) { return a.first < b; });
  };
  std::vector<uint8_t> gone(tin.triangles.size(), 0);
  for (size_t before = slivers.size() + 1; slivers.size() < before;) {  // from the border inwards
    before = slivers.size();
    std::erase_if(slivers, [&](size_t i) {
      const geom::Triangle& t = tin.triangles[i];
      bool open = false;
      for (size_t k = 0; k < 3; ++k) open = open || triangles_of(side(t, k)).second == 1;
      for (size_t k = 0; k < 3 && open; ++k) --triangles_of(side(t, k)).second;
      gone[i] = open ? 1 : 0;
      return open;
    });
  }
  size_t kept = 0;
  for (size_t i = 0; i < gone.size(); ++i) {
    if (gone[i] == 0) tin.triangles[kept++] = tin.triangles[i];
  }
  tin.triangles.resize(kept);
}

}  // namespace seamount::contour
