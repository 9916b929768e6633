// A contour with higher ground on its left enters a triangle through the edge that, counter-clockwise, leads from high
// to low, and leaves through the one that leads from low to high, which is a falling edge of the triangle beyond. So
// falling edges stand for all crossings: they are listed by their high node, and a crossing's number is its edge's
// first number plus its level's place on the edge.
#include "seamount/geom/contour/marching_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/geom/contour/chains.h"
#include "seamount/geom/tin/tin_border.h"

namespace seamount::geom {
namespace {

constexpr int64_t kGrain = 1 << 14;

/// The network with its apron: nodes and triangles are numbered on.
struct Apron {
  std::vector<Vec2> nodes;
  std::vector<std::array<int32_t, 3>> triangles;
};

/// Where the apron ends beside node b of a border ring that runs a, b, c with the network on its left.
Vec2 apron_node(Vec2 a, Vec2 b, Vec2 c) {
  const Vec2 in = b - a;
  const Vec2 out = c - b;
  const double in_length = std::hypot(in.x, in.y);
  const double out_length = std::hypot(out.x, out.y);
  const Vec2 in_way = (1.0 / in_length) * in;
  const Vec2 sum = in_way + (1.0 / out_length) * out;
  const Vec2 side{sum.y, -sum.x};
  const double squared = dot(side, side);
  // At a spike the ring turns back: the apron goes on ahead of it.
  const Vec2 way = squared > 1e-12 ? (1.0 / std::max(0.5 * squared, 0.5)) * side : in_way;
  return b + 0.25 * std::min(in_length, out_length) * way;
}

Apron make_apron(const Tin& tin, const std::vector<uint32_t>& ranks, const RunContext& run) {
  Apron apron;
  const auto first = static_cast<int32_t>(tin.nodes.size());
  for (const std::vector<int32_t>& ring : border_rings(tin, run)) {
    const size_t n = ring.size();
    const auto node = [&](size_t i) { return static_cast<size_t>(ring[i % n]); };
    const auto begin = first + static_cast<int32_t>(apron.nodes.size());
    for (size_t i = 0; i < n; ++i) {
      apron.nodes.push_back(apron_node(tin.nodes[node(i + n - 1)], tin.nodes[node(i)], tin.nodes[node(i + 1)]));
      if (ranks[node(i)] == 0 && ranks[node(i + 1)] == 0) continue;
      const int32_t here = begin + static_cast<int32_t>(i);
      const int32_t next = begin + static_cast<int32_t>((i + 1) % n);
      apron.triangles.push_back({ring[(i + 1) % n], ring[i], here});
      apron.triangles.push_back({ring[(i + 1) % n], here, next});
    }
  }
  return apron;
}

class TriangleMarch {
 public:
  TriangleMarch(const Tin& tin, std::span<const double> levels, const RunContext& run)
      : tin_(tin), levels_(levels), run_(run), ranks_(tin.nodes.size()) {
    parallel_blocks(run, static_cast<int64_t>(ranks_.size()), kGrain, [&](int64_t begin, int64_t end) {
      for (auto i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i)
        ranks_[i] = level_rank(levels_, tin_.height_m[i]);
    });
    apron_ = make_apron(tin, ranks_, run);
    ranks_.resize(ranks_.size() + apron_.nodes.size(), 0);
    outside_ = height_below(levels);
  }

  std::vector<ContourChain> trace() {
    list_falling_edges();
    run_.check_cancelled();
    place_crossings();
    link_triangles();
    run_.check_cancelled();
    std::vector<ContourChain> chains = join_segments(crossings_, segments_, run_);
    size_t points = 0;
    for (const ContourChain& chain : chains) points += chain.closed ? chain.points.size() : 0;
    if (points != crossings_.size()) throw InvalidArgument("tin", "more than two triangles meet at an edge");
    return chains;
  }

 private:
  const std::array<int32_t, 3>& triangle(size_t i) const {
    const size_t inner = tin_.triangles.size();
    return i < inner ? tin_.triangles[i] : apron_.triangles[i - inner];
  }
  Vec2 node(size_t i) const { return i < tin_.nodes.size() ? tin_.nodes[i] : apron_.nodes[i - tin_.nodes.size()]; }
  double height(size_t i) const { return i < tin_.nodes.size() ? tin_.height_m[i] : outside_; }
  uint32_t rank(int32_t i) const { return ranks_[static_cast<size_t>(i)]; }

  /// Fills starts_ and lows_, and crossed_ with the triangles that any contour crosses.
  void list_falling_edges() {
    starts_.assign(ranks_.size() + 1, 0);
    const size_t count = tin_.triangles.size() + apron_.triangles.size();
    for (size_t i = 0; i < count; ++i) {
      if (i % 65536 == 0) run_.check_cancelled();
      const std::array<int32_t, 3>& t = triangle(i);
      const std::array<uint32_t, 3> r = {rank(t[0]), rank(t[1]), rank(t[2])};
      if (r[0] == r[1] && r[1] == r[2]) continue;
      crossed_.push_back(static_cast<uint32_t>(i));
      for (size_t k = 0; k < 3; ++k)
        if (r[k] > r[(k + 1) % 3]) ++starts_[static_cast<size_t>(t[k]) + 1];
    }
    for (size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    lows_.resize(starts_.back());
    std::vector<uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (const uint32_t i : crossed_) {
      run_.check_cancelled();
      const std::array<int32_t, 3>& t = triangle(i);
      for (size_t k = 0; k < 3; ++k) {
        const int32_t to = t[(k + 1) % 3];
        if (rank(t[k]) > rank(to)) lows_[next[static_cast<size_t>(t[k])]++] = to;
      }
    }
  }

  void place_crossings() {
    firsts_.resize(lows_.size());
    uint64_t total = 0;
    for (size_t high = 0; high + 1 < starts_.size(); ++high) {
      for (uint32_t e = starts_[high]; e < starts_[high + 1]; ++e) {
        firsts_[e] = static_cast<uint32_t>(total);
        total += ranks_[high] - rank(lows_[e]);
      }
    }
    if (total >= UINT32_MAX) throw InvalidArgument("levels_m", "make more points than can be held; ask for fewer");
    crossings_.resize(total);
    parallel_blocks(run_, static_cast<int64_t>(ranks_.size()), kGrain, [&](int64_t begin, int64_t end) {
      for (auto high = static_cast<size_t>(begin); high < static_cast<size_t>(end); ++high) {
        for (uint32_t e = starts_[high]; e < starts_[high + 1]; ++e) place_on_edge(high, e);
      }
    });
  }

  void place_on_edge(size_t high, uint32_t e) {
    const auto low = static_cast<size_t>(lows_[e]);
    const uint32_t count = ranks_[high] - ranks_[low];
    const double foot = height(low);
    const double inverse = 1.0 / (height(high) - foot);
    const Vec2 from = node(low);
    const Vec2 along = node(high) - from;
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t level = ranks_[low] + i;
      const double t = spread_share((levels_[level] - foot) * inverse, i, count);
      crossings_[firsts_[e] + i] = {from + t * along, level};
    }
  }

  /// The falling edge from high to low.
  uint32_t find_edge(int32_t high, int32_t low) const {
    const auto at = static_cast<size_t>(high);
    for (uint32_t e = starts_[at]; e < starts_[at + 1]; ++e)
      if (lows_[e] == low) return e;
    throw InvalidArgument("tin", "its triangles do not fit together");
  }

  void link_triangles() {
    segments_.reserve(crossings_.size());
    for (const uint32_t i : crossed_) {
      run_.check_cancelled();
      const std::array<int32_t, 3>& t = triangle(i);
      for (size_t out = 0; out < 3; ++out) {
        const int32_t foot = t[out];
        const int32_t head = t[(out + 1) % 3];
        if (rank(foot) >= rank(head)) continue;
        const uint32_t leave = firsts_[find_edge(head, foot)] - rank(foot);
        for (size_t in = 0; in < 3; ++in) {
          const int32_t high = t[in];
          const int32_t low = t[(in + 1) % 3];
          if (rank(high) <= rank(low)) continue;
          const uint32_t enter = firsts_[find_edge(high, low)] - rank(low);
          const uint32_t end = std::min(rank(head), rank(high));
          for (uint32_t level = std::max(rank(foot), rank(low)); level < end; ++level)
            segments_.push_back({enter + level, leave + level});
        }
      }
    }
  }

  const Tin& tin_;
  std::span<const double> levels_;
  const RunContext& run_;
  std::vector<uint32_t> ranks_;  ///< per node, apron included
  Apron apron_;
  double outside_ = 0.0;  ///< height of the apron's nodes
  std::vector<uint32_t> crossed_;
  std::vector<uint32_t> starts_;  ///< per node: where its falling edges start
  std::vector<int32_t> lows_;     ///< per falling edge: its low node
  std::vector<uint32_t> firsts_;  ///< per falling edge: the number of its first crossing
  std::vector<Crossing> crossings_;
  std::vector<ContourSegment> segments_;
};

}  // namespace

std::vector<Contour> march_triangles(const Tin& tin, std::span<const double> levels, const RunContext& run) {
  run.check_cancelled();
  std::vector<Contour> contours;
  if (levels.empty() || tin.triangles.empty()) return contours;
  for (ContourChain& chain : TriangleMarch(tin, levels, run).trace())
    contours.push_back({levels[chain.level], std::move(chain.points), -1});
  return contours;
}

}  // namespace seamount::geom
