#include "seamount/ops/contour/move/move.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/ops/contour/move/local_nesting.h"
#include "seamount/ops/contour/move/places.h"

namespace seamount::contour {
namespace {

using geom::Box;

constexpr size_t kChunk = 64;   ///< edges that are asked about together
constexpr int kBisections = 8;  ///< of the strength: to a 256th

/// How often an edge of a contour is halved after it was subdivided. Only where it is not are points taken out again.
using Fineness = uint8_t;
constexpr Fineness kFinest = 6;

/// A contour that the map reaches.
struct Member {
  size_t contour = 0;
  std::vector<std::pair<size_t, size_t>> edges;  ///< runs of its edges that the map touches
  std::vector<Fineness> fineness;                ///< per edge
  Ring points;                                   ///< subdivided
  std::vector<uint32_t> origin;                  ///< per point: the edge that it lies on
  std::vector<char> made;                        ///< per point: it may go again
  std::vector<std::pair<size_t, size_t>> runs;   ///< of points, for those of edges
  Ring ring;                                     ///< moved and thinned
  std::vector<uint32_t> ring_origin;
  std::vector<std::pair<size_t, size_t>> ring_runs;
};

Box box_around(Vec2 a, Vec2 b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

void widen(Box& box, Vec2 p) {
  box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
  box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
}

bool overlap(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && a.high.x >= b.low.x && a.low.y <= b.high.y && a.high.y >= b.low.y;
}

class Mover {
 public:
  Mover(const std::vector<Contour>& contours, const PlaneMap& map, const RunContext& run)
      : contours_(contours), map_(map), run_(run) {
    for (size_t i = 0; i < contours.size(); ++i) {
      boxes_.push_back(geom::bounding_box(contours[i].ring));
      if (!overlap(boxes_[i], map.reach)) continue;
      Member member;
      member.contour = i;
      member.edges = touched_runs(contours[i].ring);
      if (member.edges.empty()) continue;
      member.fineness.assign(contours[i].ring.size(), Fineness{0});
      members_.push_back(std::move(member));
    }
    for (Member& member : members_) subdivide(member);
    most_ = 2 * total_ + 20000;
  }

  bool reaches_nothing() const { return members_.empty(); }

  /// Moves the members with this strength, as coarsely as nothing meets. What meets however finely they are followed.
  std::vector<NestingDefect> try_strength(double strength) {
    std::vector<size_t> changed;
    for (size_t i = 0; i < members_.size(); ++i) {
      Member& member = members_[i];
      changed.push_back(i);
      if (std::all_of(member.fineness.begin(), member.fineness.end(), [](Fineness f) { return f == 0; })) continue;
      std::fill(member.fineness.begin(), member.fineness.end(), Fineness{0});
      subdivide(member);
    }
    size_t fewest = std::numeric_limits<size_t>::max();
    for (int stalled = 0;;) {
      move(strength, changed);
      std::vector<NestingDefect> found = defects();
      // Where a one to one map is only followed too coarsely, each step leaves about a quarter of what meets.
      stalled = 2 * found.size() > fewest ? stalled + 1 : 0;
      fewest = std::min(fewest, found.size());
      if (found.empty() || stalled == 2) return found;
      changed = refine(found);
      if (changed.empty()) return found;
    }
  }

  /// What is wrong with the members as they were.
  std::vector<NestingDefect> defects_before() const {
    std::vector<MovedContour> all;
    for (const Member& member : members_) {
      const Ring& ring = contours_[member.contour].ring;
      all.push_back({member.contour, &ring, member.edges, false});
    }
    return find_nesting_defects(contours_, boxes_, all, run_);
  }

  std::vector<std::pair<size_t, Ring>> rings() const {
    std::vector<std::pair<size_t, Ring>> all;
    for (const Member& member : members_) all.emplace_back(member.contour, member.ring);
    return all;
  }

 private:
  std::vector<std::pair<size_t, size_t>> touched_runs(const Ring& ring) const {
    std::vector<std::pair<size_t, size_t>> runs;
    for (size_t begin = 0; begin < ring.size(); begin += kChunk) {
      const size_t end = std::min(begin + kChunk, ring.size());
      Box box{ring[begin], ring[begin]};
      for (size_t j = begin + 1; j <= end; ++j) widen(box, ring[j < ring.size() ? j : 0]);
      if (!overlap(box, map_.reach) || !map_.touches(box)) continue;
      if (!runs.empty() && runs.back().second == begin) {
        runs.back().second = end;
      } else {
        runs.emplace_back(begin, end);
      }
    }
    return runs;
  }

  void subdivide(Member& member) {
    run_.check_cancelled();
    const Ring& ring = contours_[member.contour].ring;
    total_ -= member.points.size();
    member.points.clear();
    member.origin.clear();
    member.made.clear();
    member.runs.clear();
    size_t done = 0;
    const auto add = [&](size_t edge, Vec2 p, char made) {
      member.points.push_back(p);
      member.made.push_back(made);
      member.origin.push_back(static_cast<uint32_t>(edge));
    };
    for (const auto& [begin, end] : member.edges) {
      for (; done < begin; ++done) add(done, ring[done], 0);
      const size_t from = member.points.size();
      for (; done < end; ++done) {
        const Vec2 a = ring[done];
        const Vec2 d = ring[done + 1 < ring.size() ? done + 1 : 0] - a;
        const size_t parts = parts_of(a, a + d, member.fineness[done]);
        add(done, a, 0);
        for (size_t k = 1; k < parts; ++k)
          add(done, a + (static_cast<double>(k) / static_cast<double>(parts)) * d, member.fineness[done] == 0 ? 1 : 0);
      }
      member.runs.emplace_back(from, member.points.size());
    }
    for (; done < ring.size(); ++done) add(done, ring[done], 0);
    total_ += member.points.size();
  }

  size_t parts_of(Vec2 a, Vec2 b, Fineness fineness) const {
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    size_t parts = 1;
    if (length > map_.edge_m && map_.touches(box_around(a, b)))
      parts = static_cast<size_t>(std::ceil(length / map_.edge_m));
    return parts << fineness;
  }

  void move(double strength, const std::vector<size_t>& changed) {
    run_.check_cancelled();
    std::vector<Vec2> places;
    for (const size_t i : changed) {
      const Member& member = members_[i];
      for (const auto& [begin, end] : member.runs)
        places.insert(places.end(), member.points.begin() + static_cast<std::ptrdiff_t>(begin),
                      member.points.begin() + static_cast<std::ptrdiff_t>(end));
    }
    map_.move(strength, places, run_);
    auto next = places.begin();
    for (const size_t i : changed) {
      Member& member = members_[i];
      run_.check_cancelled();
      Ring points = member.points;
      for (const auto& [begin, end] : member.runs) {
        const auto count = static_cast<std::ptrdiff_t>(end - begin);
        std::copy(next, next + count, points.begin() + static_cast<std::ptrdiff_t>(begin));
        next += count;
      }
      thin(points, member);
    }
  }

  /// Leaves out made points that lie within the tolerance of the edge that is left when they go.
  void thin(const Ring& points, Member& member) const {
    member.ring.clear();
    member.ring_origin.clear();
    member.ring_runs.clear();
    size_t kept = 0;  // of `points`, the one that stands last in the ring
    auto run = member.runs.begin();
    size_t run_from = 0;
    for (size_t i = 0; i < points.size(); ++i) {
      if (run != member.runs.end() && i == run->first) run_from = member.ring.size();
      if (member.made[i] == 0 || !droppable(points, kept, i)) {
        member.ring.push_back(points[i]);
        member.ring_origin.push_back(member.origin[i]);
        kept = i;
      }
      if (run != member.runs.end() && i + 1 == run->second) {
        member.ring_runs.emplace_back(run_from, member.ring.size());
        ++run;
      }
    }
  }

  /// Do all points after `kept` up to i lie near the edge from `kept` to the point after i?
  bool droppable(const Ring& points, size_t kept, size_t i) const {
    const Vec2 a = points[kept];
    const Vec2 d = points[i + 1 < points.size() ? i + 1 : 0] - a;
    const double squared = dot(d, d);
    constexpr size_t kMost = 16;  // bounds the work; a longer straight run keeps a point in sixteen
    if (squared == 0.0 || i - kept > kMost) return false;
    for (size_t j = kept + 1; j <= i; ++j) {
      const Vec2 p = points[j] - a;
      const double t = dot(p, d);
      if (t < 0.0 || t > squared || std::abs(cross(d, p)) > map_.tolerance_m * std::sqrt(squared)) return false;
    }
    return true;
  }

  std::vector<NestingDefect> defects() const {
    std::vector<MovedContour> all;
    for (const Member& member : members_) {
      const bool wholly =
          member.edges.size() == 1 && member.edges[0].second == member.fineness.size() && member.edges[0].first == 0;
      all.push_back({member.contour, &member.ring, member.ring_runs, wholly});
    }
    return find_nesting_defects(contours_, boxes_, all, run_);
  }

  /// Follows contours more finely where they meet. The members that this changed; none if it is not possible any more.
  std::vector<size_t> refine(const std::vector<NestingDefect>& found) {
    std::vector<std::pair<size_t, size_t>> wanted;  // member, edge
    const auto want_around = [&](size_t i, size_t ring_edge) {
      const size_t edge = members_[i].ring_origin[ring_edge];
      const size_t n = members_[i].fineness.size();
      for (const size_t near : {edge, (edge + 1) % n, (edge + n - 1) % n}) wanted.emplace_back(i, near);
    };
    for (const NestingDefect& defect : found) {
      want_around(defect.first, defect.first_edge);
      want_around(defect.second, defect.second_edge);
    }
    std::sort(wanted.begin(), wanted.end());
    wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
    std::vector<size_t> changed;
    for (const auto& [i, edge] : wanted) {
      Fineness& fineness = members_[i].fineness[edge];
      if (fineness == kFinest) return {};
      ++fineness;
      if (changed.empty() || changed.back() != i) changed.push_back(i);
    }
    for (const size_t i : changed) subdivide(members_[i]);
    return total_ < most_ ? changed : std::vector<size_t>();
  }

  const std::vector<Contour>& contours_;
  const PlaneMap& map_;
  const RunContext& run_;
  std::vector<Box> boxes_;  ///< per contour
  std::vector<Member> members_;
  size_t total_ = 0;  ///< points of the members, subdivided
  size_t most_ = 0;   ///< that are worth trying
};

/// The strongest that leaves nothing crossing, and its rings.
std::pair<double, std::vector<std::pair<size_t, Ring>>> weakened(Mover& mover, double strength) {
  double good = 0.0;
  double bad = strength;
  std::vector<std::pair<size_t, Ring>> rings;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (good + bad);
    if (mover.try_strength(middle).empty()) {
      good = middle;
      rings = mover.rings();
    } else {
      bad = middle;
    }
  }
  return {good, std::move(rings)};
}

}  // namespace

Moved move_contours(std::vector<Contour>& contours, const PlaneMap& map, double strength, const RunContext& run) {
  Mover mover(contours, map, run);
  if (mover.reaches_nothing() || strength == 0.0) return {strength, std::nullopt};
  Moved result{strength, std::nullopt};
  std::vector<std::pair<size_t, Ring>> rings;
  if (const std::vector<NestingDefect> defects = mover.try_strength(strength); defects.empty()) {
    rings = mover.rings();
  } else {
    if (const auto before = mover.defects_before(); !before.empty())
      throw IncompatibleInputs("contours cross already before the edit, at " + place_text(before[0].at));
    result.crossing = defects[0].at;
    std::tie(result.strength, rings) = weakened(mover, strength);
  }
  for (auto& [contour, ring] : rings) contours[contour].ring = std::move(ring);
  return result;
}

}  // namespace seamount::contour
