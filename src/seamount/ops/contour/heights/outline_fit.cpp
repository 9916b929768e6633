// Contours through outlines (node_heights.h). Between a node at distance a inside an outline and one at b outside, the
// contour passes where the outline does if their heights above and below it are as a to b: if both lie on one plane.
#include <algorithm>
#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/geom/polygon/edge_grid.h"
#include "seamount/ops/contour/heights/node_heights.h"

namespace seamount::contour {
namespace {

size_t at(int32_t i) { return static_cast<size_t>(i); }

/// Of a node's longest side: nearer to the outline, its height says nothing of the slope.
constexpr double kMinRun = 0.25;

double longest_side(const Tin& tin, const geom::NodeGraph& graph, size_t node) {
  double longest = 0.0;
  for (const int32_t neighbour : graph.around(node)) {
    const Vec2 d = tin.nodes[at(neighbour)] - tin.nodes[node];
    longest = std::max(longest, dot(d, d));
  }
  return std::sqrt(longest);
}

/// One node beside an outline: how far it is from it, and how much it rises over how far, smoothed along the outline.
struct Beside {
  size_t node;
  double distance;
  double rise;
  double run;
};

class OutlineFit {
 public:
  OutlineFit(const Tin& tin, const geom::NodeGraph& graph, std::span<const Shore> shores, double outline_m,
             const std::vector<double>& height, const std::vector<uint8_t>& twice, std::vector<int32_t>& slot)
      : tin_(tin), graph_(graph), outline_m_(outline_m), slot_(slot) {
    for (const Shore& shore : shores) {
      const size_t node = at(shore.node);
      if (twice[node] != 0) continue;
      const bool land = tin.region[node] != Tin::kOutside;
      slot_[node] = static_cast<int32_t>(beside_.size());
      beside_.push_back({node, 0.0, land ? std::abs(height[node] - outline_m) : 0.0, land ? 1.0 : 0.0});
      inside_.push_back(shore.inside ? 1 : 0);
    }
  }

  void measure(const Ring& outline, const RunContext& run) {
    std::vector<geom::RingEdge> edges;
    geom::add_ring_edges(outline, 0, edges);
    const geom::EdgeGrid grid(edges, run);
    parallel_blocks(run, static_cast<int64_t>(beside_.size()), 64, [&](int64_t begin, int64_t end) {
      for (auto i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i) {
        Beside& b = beside_[i];
        const double side = longest_side(tin_, graph_, b.node);
        b.distance = grid.distance(tin_.nodes[b.node], side);
        b.run *= std::max(b.distance, kMinRun * side);
      }
    });
  }

  /// Sums over the neighbours beside the outline, a few times.
  void smooth(const RunContext& run) {
    for (int round = 0; round < 4; ++round) {
      run.check_cancelled();
      std::vector<Beside> next = beside_;
      for (size_t i = 0; i < beside_.size(); ++i) {
        for (const int32_t neighbour : graph_.around(beside_[i].node)) {
          const int32_t other = slot_[at(neighbour)];
          if (other < 0) continue;
          next[i].rise += beside_[at(other)].rise;
          next[i].run += beside_[at(other)].run;
        }
      }
      beside_ = std::move(next);
    }
  }

  /// The ground on either side keeps to its region's heights, however steep it is.
  void apply(bool basin, const std::vector<RegionBand>& bands, std::vector<double>& height,
             std::vector<float>& beside) const {
    for (size_t i = 0; i < beside_.size(); ++i) {
      const Beside& b = beside_[i];
      slot_[b.node] = -1;
      if (!(b.run > 0.0)) continue;
      const double sign = (inside_[i] != 0) != basin ? 1.0 : -1.0;
      double& z = height[b.node];
      z = outline_m_ + sign * b.distance * (b.rise / b.run);
      if (const int32_t region = tin_.region[b.node]; region >= 0) {
        z = std::max(bands[at(region)].from_m, std::min(z, bands[at(region)].to_m));
      }
      beside[b.node] = static_cast<float>(b.distance);
    }
  }

 private:
  const Tin& tin_;
  const geom::NodeGraph& graph_;
  double outline_m_;
  std::vector<int32_t>& slot_;  ///< of nodes in beside_; -1: none
  std::vector<Beside> beside_;
  std::vector<uint8_t> inside_;
};

}  // namespace

void follow_outlines(const Tin& tin, const geom::NodeGraph& graph, const std::vector<RegionBand>& bands,
                     const std::vector<Shore>& shores, std::vector<double>& height, std::vector<float>& beside,
                     const RunContext& run) {
  // A node between two outlines cannot follow both.
  std::vector<uint8_t> count(tin.nodes.size(), 0);
  for (const Shore& shore : shores) {
    uint8_t& times = count[at(shore.node)];
    times = static_cast<uint8_t>(std::min<int>(times + 1, 2));
  }
  for (size_t node = 0; node < tin.bed_m.size(); ++node) {
    if (tin.bed_m[node] != Tin::kNoBed) count[node] = 2;
  }
  for (uint8_t& times : count) times = times > 1 ? 1 : 0;
  std::vector<int32_t> slot(tin.nodes.size(), -1);
  for (size_t first = 0, last = 0; first < shores.size(); first = last) {
    run.check_cancelled();
    const size_t outline = at(shores[first].outline);
    while (last < shores.size() && at(shores[last].outline) == outline) ++last;
    if (tin.regions[outline].outline.empty()) continue;
    OutlineFit fit(tin, graph, std::span(shores).subspan(first, last - first), bands[outline].outline_m, height, count,
                   slot);
    fit.measure(tin.regions[outline].outline, run);
    fit.smooth(run);
    fit.apply(tin.regions[outline].basin, bands, height, beside);
  }
}

}  // namespace seamount::contour
