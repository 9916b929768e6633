#include "seamount/ops/contour/move/smooth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/geom/contour/nesting.h"
#include "seamount/geom/polygon/edge_grid.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/ops/contour/move/places.h"

namespace seamount::contour {
namespace {

using geom::RingEdge;

constexpr double kShareOfLoop = 0.125;
constexpr int kHalvings = 6;      ///< rounds that take back by halves; later ones take back all
constexpr int kLocalRounds = 16;  ///< later ones take back whole contours

double norm(Vec2 a) { return std::hypot(a.x, a.y); }

/// A ring by arc length and the integral of its places along it. Relative to its first point.
class Arc {
 public:
  explicit Arc(const Ring& ring) : n_(ring.size()), points_(n_ + 1), at_(n_ + 1), integral_(n_ + 1) {
    for (size_t i = 0; i <= n_; ++i) points_[i] = ring[i % n_] - ring[0];
    for (size_t i = 0; i < n_; ++i) {
      const double length = norm(points_[i + 1] - points_[i]);
      at_[i + 1] = at_[i] + length;
      integral_[i + 1] = integral_[i] + (0.5 * length) * (points_[i] + points_[i + 1]);
    }
  }
  double at(size_t i) const { return at_[i]; }
  double length() const { return at_[n_]; }

  /// Mean place over [s - radius, s + radius]. REQUIRES: 0 < radius <= length.
  Vec2 mean(double s, double radius) const {
    return (1.0 / (2.0 * radius)) * (integral(s + radius) - integral(s - radius));
  }

 private:
  Vec2 integral(double s) const {
    const double turns = std::floor(s / length());
    s = std::clamp(s - turns * length(), 0.0, length());
    const auto after = std::upper_bound(at_.begin(), at_.end(), s);
    const size_t i = std::clamp<size_t>(static_cast<size_t>(after - at_.begin()), 1, n_) - 1;
    const double step = at_[i + 1] - at_[i];
    const double t = s - at_[i];
    const Vec2 slope = step > 0.0 ? (1.0 / step) * (points_[i + 1] - points_[i]) : Vec2{};
    return turns * integral_[n_] + integral_[i] + t * points_[i] + (0.5 * t * t) * slope;
  }

  size_t n_;
  Polyline points_;
  std::vector<double> at_;
  Polyline integral_;
};

/// Distance along the ring from each point to the nearest pinned one, both ways; infinite if none is.
std::vector<double> distance_to_pin(const Arc& arc, const std::vector<char>& pinned) {
  const size_t n = pinned.size();
  std::vector<double> distance(n, std::numeric_limits<double>::infinity());
  double last = -std::numeric_limits<double>::infinity();
  for (size_t j = 0; j < 2 * n; ++j) {
    const double s = arc.at(j % n) + (j >= n ? arc.length() : 0.0);
    if (pinned[j % n] != 0) last = s;
    distance[j % n] = std::min(distance[j % n], s - last);
  }
  double next = std::numeric_limits<double>::infinity();
  for (size_t j = 2 * n; j-- > 0;) {
    const double s = arc.at(j % n) + (j >= n ? arc.length() : 0.0);
    if (pinned[j % n] != 0) next = s;
    distance[j % n] = std::min(distance[j % n], next - s);
  }
  return distance;
}

Ring averaged(const Ring& ring, const std::vector<char>& pinned, const Smoothing& smoothing) {
  const Arc arc(ring);
  if (!(arc.length() > 0.0)) return ring;
  const double most = std::min(smoothing.radius_m, kShareOfLoop * arc.length());
  const std::vector<double> room = distance_to_pin(arc, pinned);
  Ring result(ring.size());
  for (size_t i = 0; i < ring.size(); ++i) {
    const double radius = std::min(most, room[i]);
    const bool moves = radius > 1e-9 * arc.length();
    result[i] =
        moves ? (1.0 - smoothing.strength) * ring[i] + smoothing.strength * (ring[0] + arc.mean(arc.at(i), radius))
              : ring[i];
  }
  return result;
}

/// Moves points along their normals, by one distance times their weight, so that the ring has the wanted area: a
/// quadratic equation in that distance. As it is where no distance does it.
void restore_area(Ring& ring, const std::vector<double>& weight, double wanted) {
  const size_t n = ring.size();
  Polyline normal(n);
  for (size_t i = 0; i < n; ++i) {
    const Vec2 along = ring[(i + 1) % n] - ring[(i + n - 1) % n];
    const double length = norm(along);
    if (length > 0.0) normal[i] = (weight[i] / length) * Vec2{along.y, -along.x};
  }
  double linear = 0.0;
  double quadratic = 0.0;
  for (size_t i = 0; i < n; ++i) {
    const size_t j = (i + 1) % n;
    const Vec2 p = ring[i] - ring[0];
    const Vec2 q = ring[j] - ring[0];
    linear += 0.5 * (cross(p, normal[j]) + cross(normal[i], q));
    quadratic += 0.5 * cross(normal[i], normal[j]);
  }
  const double missing = geom::signed_area(ring) - wanted;
  const double root = linear * linear - 4.0 * quadratic * missing;
  if (linear == 0.0 || root < 0.0) return;
  // The root near 0, without cancellation.
  const double distance = -2.0 * missing / (linear + std::copysign(std::sqrt(root), linear));
  for (size_t i = 0; i < n; ++i) ring[i] = ring[i] + distance * normal[i];
}

bool beyond(const GridFrame& frame, Vec2 p) {
  return p.x <= frame.west_m || p.x >= frame.east_m() || p.y <= frame.south_m() || p.y >= frame.north_m;
}

/// A contour that is being smoothed: each point goes `share` of the way.
struct Working {
  size_t contour;
  Ring target;
  std::vector<double> share;
  std::vector<double> factor;  ///< on the shares, found in this round
};

Ring blended(const Ring& from, const Working& working) {
  Ring ring(from.size());
  for (size_t i = 0; i < from.size(); ++i)
    ring[i] = (1.0 - working.share[i]) * from[i] + working.share[i] * working.target[i];
  restore_area(ring, working.share, geom::signed_area(from));
  return ring;
}

/// Takes back around an edge: by `least` at it, by nothing from `reach` metres of arc on.
void take_back(const Ring& ring, size_t edge, double reach, double least, Working& working) {
  const size_t n = ring.size();
  const auto walk = [&](size_t start, size_t step) {
    double distance = 0.0;
    for (size_t i = start, count = 0; distance < reach && count < n; ++count) {
      working.factor[i] = std::min(working.factor[i], least + (1.0 - least) * distance / reach);
      const size_t next = (i + step) % n;
      distance += norm(ring[next] - ring[i]);
      i = next;
    }
  };
  walk((edge + 1) % n, 1);
  walk(edge, n - 1);
}

}  // namespace

Ring smoothed_ring(const Ring& ring, const std::vector<char>& pinned, const Smoothing& smoothing) {
  if (ring.size() < 4) return ring;
  Ring result = ring;
  for (int round = 0; round < smoothing.rounds; ++round) result = averaged(result, pinned, smoothing);
  std::vector<double> weight(ring.size());
  for (size_t i = 0; i < ring.size(); ++i) weight[i] = pinned[i] != 0 ? 0.0 : 1.0;
  restore_area(result, weight, geom::signed_area(ring));
  return result;
}

namespace {

class Smoother {
 public:
  Smoother(ContourSet& set, const std::vector<size_t>& chosen, const Smoothing& smoothing, const RunContext& run)
      : set_(set),
        smoothing_(smoothing),
        run_(run),
        working_(chosen.size()),
        place_(set.contours.size(), -1),
        now_(set.contours) {
    for (size_t w = 0; w < chosen.size(); ++w) place_[chosen[w]] = static_cast<int>(w);
    constexpr int64_t kRings = 8;
    parallel_blocks(run, static_cast<int64_t>(chosen.size()), kRings, [&](int64_t begin, int64_t end) {
      for (int64_t w = begin; w < end; ++w) start(working_[static_cast<size_t>(w)], chosen[static_cast<size_t>(w)]);
    });
  }

  /// Takes smoothing back until nothing crosses.
  Smoothed settle() {
    Smoothed report;
    for (int round = 0;; ++round) {
      run_.check_cancelled();
      const std::optional<Vec2> defect = take_back_round(round);
      if (!defect) break;
      report.where = defect;
      apply_factors();
    }
    for (const Working& working : working_) {
      const Ring& ring = set_.contours[working.contour].ring;
      for (size_t i = 0; i < ring.size(); ++i) {
        if (working.share[i] < 1.0 && !beyond(set_.frame, ring[i])) ++report.limited;
      }
    }
    set_.contours = std::move(now_);
    return report;
  }

 private:
  void start(Working& working, size_t contour) {
    working.contour = contour;
    const Ring& ring = set_.contours[contour].ring;
    std::vector<char> pinned(ring.size());
    for (size_t i = 0; i < ring.size(); ++i) pinned[i] = beyond(set_.frame, ring[i]) ? 1 : 0;
    working.target = smoothed_ring(ring, pinned, smoothing_);
    for (const char pin : pinned) working.share.push_back(pin != 0 ? 0.0 : 1.0);
    working.factor.assign(ring.size(), 1.0);
    now_[contour].ring = working.target;
  }

  void take_back_at(size_t contour, size_t edge, int round) {
    if (place_[contour] < 0) return;
    Working& working = working_[static_cast<size_t>(place_[contour])];
    if (round >= kLocalRounds) {
      std::fill(working.factor.begin(), working.factor.end(), 0.0);
    } else {
      take_back(set_.contours[contour].ring, edge, 4.0 * smoothing_.radius_m, round < kHalvings ? 0.5 : 0.0, working);
    }
  }

  /// Finds all that crosses, or lies in another than its parent; a place of it.
  std::optional<Vec2> take_back_round(int round) {
    std::optional<Vec2> where;
    std::vector<RingEdge> edges;
    for (size_t i = 0; i < now_.size(); ++i) geom::add_ring_edges(now_[i].ring, i, edges);
    const geom::EdgeGrid grid(edges, run_);
    const auto any = [this](const RingEdge&, const RingEdge&) {
      run_.check_cancelled();
      return true;
    };
    grid.for_each_meeting(any, [&](const geom::EdgeGrid::Meeting& meeting) {
      const RingEdge& e = edges[meeting.first];
      const RingEdge& f = edges[meeting.second];
      if (place_[e.ring] < 0 && place_[f.ring] < 0) throw_crossing(meeting.at);
      if (round > kLocalRounds + static_cast<int>(now_.size())) throw_crossing(meeting.at);
      where = meeting.at;
      take_back_at(e.ring, e.index, round);
      take_back_at(f.ring, f.index, round);
      return true;
    });
    if (where) return where;
    const std::vector<int> parents = geom::find_contour_parents(now_, run_);
    for (size_t i = 0; i < parents.size(); ++i) {
      if (parents[i] == set_.contours[i].parent) continue;
      where = now_[i].ring[0];
      for (const int ring : {static_cast<int>(i), parents[i], set_.contours[i].parent}) {
        if (ring >= 0) take_back_at(static_cast<size_t>(ring), 0, kLocalRounds);
      }
    }
    return where;
  }

  [[noreturn]] static void throw_crossing(Vec2 at) {
    throw IncompatibleInputs("contours cross already before the edit, at " + place_text(at));
  }

  void apply_factors() {
    for (Working& working : working_) {
      run_.check_cancelled();
      bool changed = false;
      for (size_t i = 0; i < working.share.size(); ++i) {
        changed = changed || working.factor[i] < 1.0;
        working.share[i] *= working.factor[i];
        working.factor[i] = 1.0;
      }
      if (changed) now_[working.contour].ring = blended(set_.contours[working.contour].ring, working);
    }
  }

  ContourSet& set_;
  const Smoothing& smoothing_;
  const RunContext& run_;
  std::vector<Working> working_;
  std::vector<int> place_;  ///< per contour: in working_, or -1
  std::vector<Contour> now_;
};

}  // namespace

Smoothed smooth_contours(ContourSet& set, const std::vector<size_t>& chosen, const Smoothing& smoothing,
                         const RunContext& run) {
  if (chosen.empty()) return {};
  return Smoother(set, chosen, smoothing, run).settle();
}

}  // namespace seamount::contour
