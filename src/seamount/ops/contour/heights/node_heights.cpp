#include "seamount/ops/contour/heights/node_heights.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <tuple>

#include "seamount/geom/scalar/bucket_sort.h"
#include "seamount/ops/contour/growth/region_graph.h"

namespace seamount::contour {
namespace {

size_t at(int32_t i) { return static_cast<size_t>(i); }

bool is_river(const Tin& tin, size_t node) { return !tin.bed_m.empty() && tin.bed_m[node] != Tin::kNoBed; }

/// A place of a region's ranks whose height is known.
struct RankKnot {
  double share = 0.0;  ///< of the region's nodes that are lower
  double height = 0.0;
};

double knot_height(const std::vector<RankKnot>& knots, double share, const HeightDistribution& distribution) {
  size_t k = 1;
  while (k + 1 < knots.size() && share > knots[k].share) ++k;
  const RankKnot& low = knots[k - 1];
  const RankKnot& high = knots[k];
  return distribution.quantile(low.height, high.height, (share - low.share) / (high.share - low.share));
}

/// The knots of a region whose inner outlines have heights of their own: the share that most nodes beside an outline
/// keep below (a hill's) or above (a basin's) has its height.
std::vector<RankKnot> inner_knots(const Tin& tin, const std::vector<RegionBand>& bands,
                                  const std::vector<Shore>& shores, const std::vector<double>& share, int32_t region) {
  const RegionBand& band = bands[at(region)];
  std::map<int32_t, std::vector<double>> shares;
  for (const Shore& shore : shores) {
    if (!shore.inside && tin.region[at(shore.node)] == region && !is_river(tin, at(shore.node))) {
      shares[shore.outline].push_back(share[at(shore.node)]);
    }
  }
  std::vector<RankKnot> inner;
  for (auto& [outline, of_nodes] : shares) {
    const double height = bands[at(outline)].outline_m;
    if (height <= band.from_m || height >= band.to_m) continue;
    std::sort(of_nodes.begin(), of_nodes.end());
    const size_t n = of_nodes.size();
    const size_t most = tin.regions[at(outline)].basin ? n / 5 : n - 1 - n / 5;
    inner.push_back({of_nodes[most], height});
  }
  std::sort(inner.begin(), inner.end(), [](const RankKnot& a, const RankKnot& b) {
    return std::tie(a.height, a.share) < std::tie(b.height, b.share);
  });
  constexpr double kApart = 0.02;
  std::vector<RankKnot> knots = {{0.0, band.from_m}};
  for (const RankKnot& knot : inner) {
    const bool ascends = knot.share > knots.back().share + kApart && knot.share < 1.0 - kApart;
    if (ascends && knot.height > knots.back().height) knots.push_back(knot);
  }
  knots.push_back({1.0, band.to_m});
  return knots;
}

/// Nodes of the regions that rise together, in the order in which they do.
struct Rising {
  double place;
  int32_t node;
  auto operator<=>(const Rising&) const = default;
};

/// For each node which share of the nodes that rise together is lower: those of one group and level, or of a region
/// whose outlines have heights of their own. River nodes have their beds instead.
std::vector<double> rising_shares(const Tin& tin, const std::vector<RegionBand>& bands, const HeightsParams& params,
                                  const RunContext& run) {
  using Place = std::tuple<int, int, int32_t>;  // group, level, region that rises alone
  const auto place = [&](size_t r) {
    return Place{bands[r].group, bands[r].level, bands[r].alone ? static_cast<int32_t>(r) : -1};
  };
  std::vector<int64_t> nodes(bands.size(), 0);
  for (const int32_t r : tin.region) {
    if (r >= 0) ++nodes[at(r)];
  }
  std::map<Place, int64_t> widest;  // nodes of its widest summit
  for (size_t r = 0; r < bands.size(); ++r) {
    int64_t& most = widest[place(r)];
    if (bands[r].summit) most = std::max(most, nodes[r]);
  }
  std::vector<double> reach(bands.size(), 1.0);
  std::map<Place, std::vector<Rising>> rising;
  std::vector<std::vector<Rising>*> order(bands.size());
  for (size_t r = 0; r < bands.size(); ++r) {
    order[r] = &rising[place(r)];
    if (!bands[r].summit || tin.regions[r].basin || params.summits == Summits::equal) continue;
    reach[r] = std::sqrt(static_cast<double>(nodes[r]) / static_cast<double>(std::max<int64_t>(widest[place(r)], 1)));
  }
  for (size_t node = 0; node < tin.nodes.size(); ++node) {
    if (node % 65536 == 0) run.check_cancelled();
    if (tin.region[node] < 0 || is_river(tin, node)) continue;
    const size_t r = at(tin.region[node]);
    order[r]->push_back({reach[r] * static_cast<double>(tin.rank[node]), static_cast<int32_t>(node)});
  }
  std::vector<double> share(tin.nodes.size(), 0.0);
  for (auto& [where, together] : rising) {
    run.check_cancelled();
    geom::bucket_sort(
        together, [](const Rising& r) { return r.place; }, std::less<>());
    for (size_t i = 0; i < together.size(); ++i) {
      share[at(together[i].node)] = (static_cast<double>(i) + 0.5) / static_cast<double>(together.size());
    }
  }
  return share;
}

}  // namespace

std::vector<Shore> find_shores(const Tin& tin, const geom::NodeGraph& graph, const RunContext& run) {
  std::vector<Shore> shores;
  std::vector<int32_t> seen;
  for (size_t node = 0; node < tin.nodes.size(); ++node) {
    if (node % 65536 == 0) run.check_cancelled();
    const int32_t here = tin.region[node];
    seen.clear();
    for (const int32_t neighbour : graph.around(node)) {
      const int32_t there = tin.region[at(neighbour)];
      if (there == here) continue;
      int32_t outline = -1;
      bool inside = false;
      if (here == Tin::kOutside) {  // over the outermost outline
        outline = there;
        while (tin.regions[at(outline)].parent >= 0) outline = tin.regions[at(outline)].parent;
      } else {
        outline = border_of(tin.regions, here, there).beyond;
        inside = outline < 0;
        if (inside) outline = here;
      }
      if (std::find(seen.begin(), seen.end(), outline) != seen.end()) continue;
      seen.push_back(outline);
      shores.push_back({static_cast<int32_t>(node), outline, inside});
    }
  }
  std::stable_sort(shores.begin(), shores.end(), [](const Shore& a, const Shore& b) { return a.outline < b.outline; });
  return shores;
}

Limits find_limits(const Tin& tin, const std::vector<RegionBand>& bands, const std::vector<Shore>& shores) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Limits limits{std::vector<double>(tin.nodes.size(), -kFar), std::vector<double>(tin.nodes.size(), kFar)};
  for (const Shore& shore : shores) {
    const size_t node = at(shore.node);
    const double height = bands[at(shore.outline)].outline_m;
    if (shore.inside != tin.regions[at(shore.outline)].basin) {
      limits.floor[node] = std::max(limits.floor[node], height);
    } else {
      limits.cap[node] = std::min(limits.cap[node], height);
    }
  }
  return limits;
}

std::vector<double> band_heights(const Tin& tin, const std::vector<RegionBand>& bands, const std::vector<Shore>& shores,
                                 const HeightDistribution& distribution, const HeightsParams& params,
                                 const RunContext& run) {
  std::vector<double> share = rising_shares(tin, bands, params, run);
  std::vector<std::vector<RankKnot>> knots(bands.size());
  for (size_t r = 0; r < bands.size(); ++r) {
    run.check_cancelled();
    knots[r] = {{0.0, bands[r].from_m}, {1.0, bands[r].to_m}};
    if (bands[r].alone) knots[r] = inner_knots(tin, bands, shores, share, static_cast<int32_t>(r));
  }
  for (size_t node = 0; node < tin.nodes.size(); ++node) {
    if (node % 16384 == 0) run.check_cancelled();
    const int32_t region = tin.region[node];
    if (region < 0) continue;
    share[node] = is_river(tin, node) ? static_cast<double>(tin.bed_m[node])
                                      : knot_height(knots[at(region)], share[node], distribution);
  }
  return share;
}

}  // namespace seamount::contour
