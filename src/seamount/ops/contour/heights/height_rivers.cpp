// Heights along rivers (node_heights.h).
#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

#include "seamount/ops/contour/heights/node_heights.h"

namespace seamount::contour {
namespace {

constexpr int kRounds = 40;  ///< of smoothing: divides are about a dozen nodes wide

size_t at(int32_t i) { return static_cast<size_t>(i); }

bool is_river(const Tin& tin, size_t node) { return !tin.bed_m.empty() && tin.bed_m[node] != Tin::kNoBed; }

}  // namespace

void limit_rivers(const Tin& tin, const geom::NodeGraph& graph, Limits& limits) {
  for (size_t node = 0; node < tin.bed_m.size(); ++node) {
    if (!is_river(tin, node) || tin.region[node] < 0) continue;
    const auto bed = static_cast<double>(tin.bed_m[node]);
    limits.floor[node] = limits.cap[node] = bed;
    for (const int32_t neighbour : graph.around(node)) {
      const size_t beside = at(neighbour);
      if (tin.region[beside] >= 0 && !is_river(tin, beside)) limits.floor[beside] = std::max(limits.floor[beside], bed);
    }
  }
}

void stand_on_rivers(const Tin& tin, const geom::NodeGraph& graph, const std::vector<RegionBand>& bands,
                     std::vector<double>& height, const RunContext& run) {
  std::vector<uint8_t> has_river(bands.size(), 0);
  for (size_t node = 0; node < tin.bed_m.size(); ++node) {
    if (is_river(tin, node) && tin.region[node] >= 0) has_river[at(tin.region[node])] = 1;
  }
  if (std::none_of(has_river.begin(), has_river.end(), [](uint8_t has) { return has != 0; })) return;
  const auto stands = [&](size_t node) { return tin.region[node] >= 0 && has_river[at(tin.region[node])] != 0; };

  const std::vector<int32_t> drains = find_drains(tin, graph, height, run);
  std::vector<double> base(tin.nodes.size(), 0.0);
  for (const int32_t node : rank_order(tin, bands, run)) {
    const size_t n = at(node);
    const double lowest = bands[at(tin.region[n])].from_m;
    const int32_t to = drains[n];
    const bool same = to >= 0 && tin.region[at(to)] == tin.region[n];
    base[n] = is_river(tin, n) ? static_cast<double>(tin.bed_m[n]) : (same ? base[at(to)] : lowest);
  }
  std::vector<double> smooth = base;
  for (int round = 0; round < kRounds; ++round) {
    run.check_cancelled();
    for (size_t node = 0; node < tin.nodes.size(); ++node) {
      if (!stands(node) || is_river(tin, node) || drains[node] < 0) continue;
      double sum = 0.0;
      int count = 0;
      for (const int32_t neighbour : graph.around(node)) {
        if (tin.region[at(neighbour)] != tin.region[node]) continue;
        sum += base[at(neighbour)];
        ++count;
      }
      if (count > 0) smooth[node] = 0.3 * base[node] + 0.7 * sum / count;
    }
    base = smooth;
  }
  for (size_t node = 0; node < tin.nodes.size(); ++node) {
    if (!stands(node)) continue;
    const RegionBand& band = bands[at(tin.region[node])];
    if (!(band.to_m > band.from_m)) continue;
    const double share = (height[node] - band.from_m) / (band.to_m - band.from_m);
    height[node] = base[node] + share * std::max(band.to_m - base[node], 0.0);
  }
}

void fill_behind_rivers(const Tin& tin, const geom::NodeGraph& graph, const Limits& limits, std::vector<double>& height,
                        const RunContext& run) {
  if (tin.bed_m.empty()) return;
  constexpr double kRise = 1e-3;  // m/m of filled ground
  using Open = std::pair<double, int32_t>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  std::vector<uint8_t> done = edge_nodes(tin, graph);
  for (size_t node = 0; node < tin.nodes.size(); ++node) {
    const int32_t region = tin.region[node];
    if (region < 0 || tin.regions[at(region)].basin) done[node] = 1;
    if (done[node] != 0) open.emplace(height[node], static_cast<int32_t>(node));
  }
  for (size_t taken = 1; !open.empty(); ++taken) {
    if (taken % 16384 == 0) run.check_cancelled();
    const auto [z, node] = open.top();
    open.pop();
    for (const int32_t neighbour : graph.around(at(node))) {
      if (done[at(neighbour)] != 0) continue;
      done[at(neighbour)] = 1;
      const Vec2 way = tin.nodes[at(neighbour)] - tin.nodes[at(node)];
      const double least = std::min(z + kRise * std::sqrt(dot(way, way)), limits.cap[at(neighbour)]);
      height[at(neighbour)] = std::max(height[at(neighbour)], least);
      open.emplace(height[at(neighbour)], neighbour);
    }
  }
}

}  // namespace seamount::contour
