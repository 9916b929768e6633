#include "seamount/ops/contour/growth/growth.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <queue>
#include <tuple>

#include "seamount/base/parallel.h"
#include "seamount/geom/solve/graph_laplace.h"

namespace seamount::contour {
namespace {

constexpr double kLeastRise = 0.35;  ///< of the mean rise of ranks across a region
constexpr double kEven = 0.4;        ///< share of steps to the borders in the ranks between two fronts

size_t at(int32_t i) { return static_cast<size_t>(i); }

/// At which share of its region's range a front starts that comes over the outline of `child` (-1: the region's own).
/// Heights that are not known leave the paper's 0 for lower and 1 for upper ground.
class Levels {
 public:
  Levels(const std::vector<TinRegion>& regions, int32_t region) : regions_(regions) {
    const TinRegion& own = regions[at(region)];
    if (!own.height_m) return;
    // The other end of the range: the highest hill inside, or the deepest basin in a basin.
    for (const TinRegion& child : regions) {
      if (child.parent != region || child.basin != own.basin || !child.height_m) continue;
      if (!far_ || (own.basin ? *child.height_m < *far_ : *child.height_m > *far_)) far_ = child.height_m;
    }
    if (far_ && *far_ == *own.height_m) far_.reset();
    low_ = own.basin ? far_ : own.height_m;
    high_ = own.basin ? own.height_m : far_;
  }

  double of(int32_t child, Side side) const {
    const double plain = side == Side::upper ? 1.0 : 0.0;
    if (child < 0 || !far_ || !regions_[at(child)].height_m) return plain;
    const double share = (*regions_[at(child)].height_m - *low_) / (*high_ - *low_);
    return side == Side::upper ? std::clamp(share, 0.02, 1.0) : std::clamp(share, 0.0, 0.98);
  }

 private:
  const std::vector<TinRegion>& regions_;
  std::optional<double> far_, low_, high_;
};

/// Per node of the network; each region's growth touches its own nodes.
struct Work {
  std::vector<uint32_t> weight;
  std::vector<uint32_t> up, down;             ///< steps of the two fronts, 0: not reached
  std::vector<uint32_t> from_low, from_high;  ///< steps from the borders by the shortest way; empty with one front
  std::vector<float> low, high;               ///< shares of the range at the fronts' starts; empty unless they differ
  std::vector<int32_t> slot;                  ///< of a node among its region's members; empty as above
  std::vector<uint32_t> river;                ///< 1, 2, ... from the mouths up, 0: none; empty without rivers
  std::vector<uint32_t> score;                ///< n(p) of P2 sec. 4.5 as a 32-bit fraction
  std::vector<uint8_t> seen;
};

class RegionGrowth {
 public:
  RegionGrowth(const RegionGraph& graph, const std::vector<TinRegion>& regions, int32_t region,
               const std::vector<int32_t>& outlets, Seed seed)
      : graph_(graph), levels_(regions, region), members_(graph.members(at(region))), seed_(seed) {
    const auto is_member = [&](int32_t node) { return std::binary_search(members_.begin(), members_.end(), node); };
    bool drains = false;
    for (const BorderNode& border : graph.borders[at(region)]) {
      add(border);
      drains |= border.beyond < 0;
    }
    for (const int32_t node : outlets) {
      if (!is_member(node)) continue;
      add({node, -1, Side::lower});
      drains = true;
    }
    for (const int32_t node : graph.rim) {  // land without coast or rivers ends at the edge of the network
      if (drains) break;
      if (is_member(node)) add({node, -1, regions[at(region)].basin ? Side::upper : Side::lower});
    }
    const auto between = [&](const BorderNode& b) {
      const double level = levels_.of(b.beyond, b.side);
      return level != 0.0 && level != 1.0;
    };
    has_levels_ =
        std::any_of(lower_.begin(), lower_.end(), between) || std::any_of(upper_.begin(), upper_.end(), between);
  }

  bool has_levels() const { return has_levels_; }
  bool has_two_fronts() const { return !upper_.empty() && !lower_.empty(); }

  /// The ascending or the descending front. The two may run side by side.
  void run_front(bool descending, Work& work, const RunContext& run) {
    std::vector<BorderNode>& border = descending ? upper_ : lower_;
    std::vector<uint32_t>& step = descending ? work.down : work.up;
    Rng rng(seed_.derive(descending ? "descending" : "ascending"));
    for (size_t i = border.size(); i > 1; --i) std::swap(border[i - 1], border[((rng.bits() >> 32) * i) >> 32]);
    std::vector<int32_t> seeds;
    if (!descending) seeds = river_nodes(work);
    seeds.reserve(seeds.size() + border.size());
    for (const BorderNode& b : border) seeds.push_back(b.node);
    eden_growth(graph_, seeds, work.weight, descending, rng, step, run);
  }

  /// Ranks from the steps of both fronts.
  void rank(Work& work, std::span<float> ranks, const RunContext& run) {
    std::vector<int32_t> order;
    const bool plain = upper_.empty() && all_drain_ && river_nodes(work).empty() &&
                       std::all_of(members_.begin(), members_.end(), [&](int32_t n) { return work.up[at(n)] != 0; });
    if (plain) {
      order.resize(members_.size());
      for (const int32_t node : members_) order[work.up[at(node)] - 1] = node;
    } else {
      if (has_levels_) blend_levels(work, run);
      run.check_cancelled();
      score(work);
      order = flood(work, run);
    }
    for (size_t i = 0; i < order.size(); ++i) {
      ranks[at(order[i])] = static_cast<float>((static_cast<double>(i) + 0.5) / static_cast<double>(order.size()));
    }
  }

 private:
  void add(const BorderNode& border) {
    (border.side == Side::upper ? upper_ : lower_).push_back(border);
    if (border.side == Side::lower) drains_.push_back(border.node);
    if (border.side == Side::across) all_drain_ = false;
  }

  std::vector<int32_t> river_nodes(const Work& work) const {
    std::vector<int32_t> nodes;
    if (work.river.empty()) return nodes;
    std::copy_if(members_.begin(), members_.end(), std::back_inserter(nodes),
                 [&](int32_t node) { return work.river[at(node)] != 0; });
    std::sort(nodes.begin(), nodes.end(), [&](int32_t a, int32_t b) { return work.river[at(a)] < work.river[at(b)]; });
    return nodes;
  }

  /// Levels between the outlines at which the fronts start, without a step where two fronts meet.
  void blend_levels(Work& work, const RunContext& run) const {
    for (size_t i = 0; i < members_.size(); ++i) work.slot[at(members_[i])] = static_cast<int32_t>(i);
    std::vector<uint32_t> starts = {0};
    std::vector<int32_t> neighbours;
    for (const int32_t node : members_) {
      for (const int32_t neighbour : graph_.around(node)) neighbours.push_back(work.slot[at(neighbour)]);
      starts.push_back(static_cast<uint32_t>(neighbours.size()));
    }
    for (const bool upper : {false, true}) {
      std::vector<uint8_t> fixed(members_.size(), 0);
      std::vector<double> level(members_.size(), upper ? 1.0 : 0.0);
      for (const BorderNode& border : upper ? upper_ : lower_) {
        const auto slot = at(work.slot[at(border.node)]);
        const double share = levels_.of(border.beyond, border.side);
        level[slot] = fixed[slot] == 0 ? share : std::min(level[slot], share);
        fixed[slot] = 1;
      }
      geom::solve_graph_laplace(starts, neighbours, fixed, level, run);
      for (size_t i = 0; i < members_.size(); ++i) {
        (upper ? work.high : work.low)[at(members_[i])] = static_cast<float>(level[i]);
      }
    }
  }

  /// In how many steps each node is reached from a border, from 1; 0 where it is not. Returns the most.
  uint32_t count_steps(const std::vector<BorderNode>& border, std::vector<uint32_t>& steps) const {
    std::vector<int32_t> reached;
    reached.reserve(members_.size());
    const auto reach = [&](int32_t node, uint32_t step) {
      if (steps[at(node)] != 0) return;
      steps[at(node)] = step;
      reached.push_back(node);
    };
    for (const BorderNode& b : border) reach(b.node, 1);
    for (size_t i = 0; i < reached.size(); ++i) {
      for (const int32_t neighbour : graph_.around(reached[i])) reach(neighbour, steps[at(reached[i])] + 1);
    }
    return reached.empty() ? 1 : steps[at(reached.back())];
  }

  /// n(p) = n- / (n- + n+), with the paper's forms for nodes that one front alone reaches; in part the same of steps to
  /// the borders, without which growth leaves hollows near the upper border where its front comes last.
  void score(Work& work) {
    const auto all = static_cast<double>(members_.size());
    if (has_two_fronts()) {
      across_ = count_steps(lower_, work.from_low);
      count_steps(upper_, work.from_high);
    }
    for (const int32_t member : members_) {
      const size_t node = at(member);
      const double up = work.up[node], down = work.down[node];
      if (!work.river.empty() && work.river[node] != 0) {  // the water's way, from the mouth up
        work.score[node] = work.river[node];
        continue;
      }
      const double low = has_levels_ && up > 0.0 ? static_cast<double>(work.low[node]) : 0.0;
      const double high = has_levels_ && down > 0.0 ? static_cast<double>(work.high[node]) : 1.0;
      double share = 1.0;
      if (up > 0.0) share = down > 0.0 ? up / (up + down) : up / all;
      if (up == 0.0 && down > 0.0) share = (all - down) / all;
      if (has_two_fronts() && work.from_low[node] > 0 && work.from_high[node] > 0) {
        const double from_low = work.from_low[node], from_high = work.from_high[node];
        share += kEven * (from_low / (from_low + from_high) - share);
      }
      work.score[node] = static_cast<uint32_t>((low + (high - low) * share) * (1.0 - kLeastRise) * 0xffffffffU);
    }
  }

  /// The last pass: always on to the border node with the lowest score, from where the region drains to. Hollows of the
  /// score, which the paper's pass fills level, rise from their outlet.
  std::vector<int32_t> flood(Work& work, const RunContext& run) const {
    constexpr uint64_t kMost = 0xffffffffU;
    std::priority_queue<uint64_t, std::vector<uint64_t>, std::greater<>> border;
    const auto push = [&](int32_t node, uint64_t least) {
      const uint64_t score = std::min(std::max<uint64_t>(work.score[at(node)], least), kMost);
      border.push((score << 32) | static_cast<uint32_t>(node));
    };
    std::vector<int32_t> sources = closed_parts(work);
    sources.insert(sources.end(), drains_.begin(), drains_.end());
    // A share of the mean rise across the region, so that the farthest nodes keep to its range. One front alone leaves
    // no hollows.
    const uint64_t rise = has_two_fronts() ? static_cast<uint64_t>(kLeastRise * kMost) / across_ : 0;
    for (const int32_t node : members_) work.seen[at(node)] = 0;
    const auto push_new = [&](int32_t node, uint64_t least) {
      if (work.seen[at(node)] == 0) push(node, least);
      work.seen[at(node)] = 1;
    };
    for (const int32_t node : sources) push_new(node, 0);
    std::vector<int32_t> order;
    order.reserve(members_.size());
    while (!border.empty()) {
      if (order.size() % 16384 == 0) run.check_cancelled();
      const auto node = static_cast<int32_t>(border.top() & 0xffffffffU);
      const uint64_t score = border.top() >> 32;
      border.pop();
      order.push_back(node);
      for (const int32_t neighbour : graph_.around(node)) push_new(neighbour, score + rise);
    }
    return order;
  }

  bool on_rim(int32_t node) const { return std::binary_search(graph_.rim.begin(), graph_.rim.end(), node); }

  /// Where each connected part drains to that has no lower ground beside it: over the edge of the network if it reaches
  /// that, else to its own lowest node.
  std::vector<int32_t> closed_parts(Work& work) const {
    std::vector<int32_t> part(drains_);
    for (const int32_t node : part) work.seen[at(node)] = 1;
    const auto spread = [&] {
      for (size_t i = 0; i < part.size(); ++i) {
        for (const int32_t neighbour : graph_.around(part[i])) {
          if (work.seen[at(neighbour)] == 0) part.push_back(neighbour);
          work.seen[at(neighbour)] = 1;
        }
      }
    };
    spread();
    std::vector<int32_t> lowest;
    for (const int32_t node : members_) {
      if (work.seen[at(node)] != 0) continue;
      work.seen[at(node)] = 1;
      part.assign(1, node);
      spread();
      lowest.push_back(*std::min_element(part.begin(), part.end(), [&](int32_t m, int32_t n) {
        return std::tuple(!on_rim(m), work.score[at(m)], m) < std::tuple(!on_rim(n), work.score[at(n)], n);
      }));
    }
    return lowest;
  }

  const RegionGraph& graph_;
  Levels levels_;
  std::span<const int32_t> members_;
  Seed seed_;
  std::vector<BorderNode> lower_, upper_;
  std::vector<int32_t> drains_;  ///< border nodes beside lower ground
  bool all_drain_ = true;        ///< no border node is beside another branch of the tree
  bool has_levels_ = false;
  uint32_t across_ = 1;  ///< steps from the lower border to the farthest node
};

Work make_work(std::span<const float> probability, const RiverNodes& rivers, const std::vector<RegionGrowth>& growths) {
  const size_t nodes = probability.size();
  Work work;
  work.weight.reserve(nodes);
  for (const float p : probability) work.weight.push_back(growth_weight(static_cast<double>(p)));
  work.up.assign(nodes, 0);
  work.down.assign(nodes, 0);
  work.score.assign(nodes, 0);
  work.seen.assign(nodes, 0);
  if (std::any_of(growths.begin(), growths.end(), [](const RegionGrowth& g) { return g.has_two_fronts(); })) {
    work.from_low.assign(nodes, 0);
    work.from_high.assign(nodes, 0);
  }
  if (std::any_of(growths.begin(), growths.end(), [](const RegionGrowth& g) { return g.has_levels(); })) {
    work.low.assign(nodes, 0.0F);
    work.high.assign(nodes, 1.0F);
    work.slot.assign(nodes, -1);
  }
  if (!rivers.upstream.empty()) work.river.assign(nodes, 0);
  for (size_t i = 0; i < rivers.upstream.size(); ++i) work.river[at(rivers.upstream[i])] = static_cast<uint32_t>(i) + 1;
  return work;
}

}  // namespace

std::vector<float> grow_ranks(std::span<const std::array<int32_t, 3>> triangles, std::span<const int32_t> region,
                              const std::vector<TinRegion>& regions, std::span<const float> probability,
                              const RiverNodes& rivers, Seed seed, const RunContext& run) {
  const RegionGraph graph = make_region_graph(triangles, region, regions, run);
  run.report(0.2);
  std::vector<RegionGrowth> growths;
  for (size_t i = 0; i < regions.size(); ++i) {
    run.check_cancelled();
    growths.emplace_back(graph, regions, static_cast<int32_t>(i), rivers.outlets, seed.derive("region", i));
  }
  Work work = make_work(probability, rivers, growths);
  run.check_cancelled();
  const auto count = static_cast<int64_t>(growths.size());
  parallel_blocks(run.part(0.2, 0.8), 2 * count, 1, [&](int64_t task, int64_t) {
    growths[static_cast<size_t>(task / 2)].run_front(task % 2 != 0, work, run);
  });
  std::vector<float> ranks(region.size(), 0.0F);
  parallel_blocks(run.part(0.8, 1.0), count, 1,
                  [&](int64_t i, int64_t) { growths[static_cast<size_t>(i)].rank(work, ranks, run); });
  return ranks;
}

}  // namespace seamount::contour
