// The ground outside the regions (node_heights.h): how it falls, and that water runs off it.
//
// From the coast it goes on as steep as the land behind it and within a few hundred metres comes to the slope of a
// submarine flank, which lessens with depth (of real islands 10 to 20 degrees above 2 km and 3 to 8 below). Contours
// are offsets of the coast drawn out and in by noise, the more the further away. Nothing is lower than its way to the
// network's edge: hollows between islands are filled to a plain that falls gently.
#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <queue>

#include "seamount/base/rng.h"
#include "seamount/geom/scalar/noise_places.h"
#include "seamount/ops/contour/heights/node_heights.h"

namespace seamount::contour {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr double kUpperDepth = 1200.0;  ///< m, down to which flanks keep their slope
constexpr double kDeepest = 5500.0;     ///< m, which they come near to but never reach
constexpr double kOnLand = 0.0875;      ///< m/m, of ground outside an outline that lies above the sea
constexpr double kNoCoast = 50.0;       ///< m, of an outline that is surely none
constexpr double kSteepestCoast = 3.0;  ///< m/m that the sea floor takes over from the land
constexpr double kGentlestCoast = 0.02;
constexpr double kRelaxation = 0.05;  ///< of the land's width, over which the coast's slope ends; of cliffs sooner
constexpr double kWave = 0.4;         ///< of the land's width: length of the noise's waves
constexpr double kSway = 0.15;        ///< of the distance from the coast, near it
constexpr double kMostSway = 0.05;    ///< of the land's width, far out
constexpr double kPlain = 2e-3;       ///< m/m of filled ground
constexpr double kBelowCap = 1e-3;    ///< m

size_t at(int32_t i) { return static_cast<size_t>(i); }

double length(Vec2 v) { return std::sqrt(dot(v, v)); }

/// How far below 0 ground lies that would lie `depth` below it if flanks never grew gentler.
double flattened(double depth) {
  constexpr double kSpan = kDeepest - kUpperDepth;
  return depth <= kUpperDepth ? depth : kUpperDepth + kSpan * (1.0 - std::exp((kUpperDepth - depth) / kSpan));
}

/// A node outside the regions: the coast nearest to it.
struct Offshore {
  Vec2 coast;           ///< the node that lies there
  double behind = 0.0;  ///< how far that is from the outline
  double away = kFar;   ///< of this node from the outline
  double outline_m = 0.0;
  double slope = 0.0;  ///< m/m at the outline
};

class SeaFloor {
 public:
  SeaFloor(const Tin& tin, const geom::NodeGraph& graph, const std::vector<float>& beside, double flank, double width_m,
           std::vector<double>& height, const RunContext& run)
      : tin_(tin), graph_(graph), beside_(beside), flank_(flank), width_(width_m), height_(height), run_(run) {
    for (size_t node = 0; node < tin.nodes.size(); ++node) {
      if (tin.region[node] == Tin::kOutside) sea_.push_back(static_cast<int32_t>(node));
    }
    offshore_.resize(tin.nodes.size());
    cap_.assign(tin.nodes.size(), kFar);
  }

  void enter_coast(const std::vector<RegionBand>& bands, const std::vector<Shore>& shores) {
    for (const Shore& shore : shores) {
      const size_t node = at(shore.node);
      if (tin_.region[node] != Tin::kOutside) continue;
      const double outline = bands[at(shore.outline)].outline_m;
      if (outline - kBelowCap >= cap_[node]) continue;
      cap_[node] = outline - kBelowCap;
      Offshore& o = offshore_[node];
      o = {tin_.nodes[node], static_cast<double>(beside_[node]), 0.0, outline, flank_};
      if (beside_[node] < 0.0F) {  // half a side, in the middle
        o.behind = 0.5 * longest_side(node);
        height_[node] = outline - flank_ * o.behind;
      } else if (beside_[node] > 0.0F) {
        o.slope = (outline - height_[node]) / o.behind;
      }
      o.away = o.behind;
      height_[node] = std::min(height_[node], cap_[node]);
    }
  }

  /// The nearest coast of every node, from neighbour to neighbour.
  void find_coasts() {
    using Open = std::pair<double, int32_t>;
    std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
    for (const int32_t node : sea_) {
      if (offshore_[at(node)].away < kFar) open.emplace(offshore_[at(node)].away, node);
    }
    while (!open.empty()) {
      const auto [away, node] = open.top();
      open.pop();
      if (away > offshore_[at(node)].away) continue;
      if (order_.size() % 4096 == 0) run_.check_cancelled();
      order_.push_back(node);
      const Offshore& here = offshore_[at(node)];
      for (const int32_t neighbour : graph_.around(at(node))) {
        if (tin_.region[at(neighbour)] != Tin::kOutside) continue;
        Offshore& there = offshore_[at(neighbour)];
        const double further = here.behind + length(tin_.nodes[at(neighbour)] - here.coast);
        if (further >= there.away) continue;
        there = here;
        there.away = further;
        open.emplace(further, neighbour);
      }
    }
  }

  void lay() {
    average_coasts();
    const Seed seed{mix_bits(std::bit_cast<uint64_t>(tin_.nodes[0].x)) ^ std::bit_cast<uint64_t>(tin_.nodes[0].y)};
    geom::Fbm waves;
    waves.wavelength_m = std::max(kWave * width_, 1e-3);
    waves.octaves = 3;
    waves.gain = 0.45;
    std::vector<Vec2> places;
    for (const int32_t node : order_) places.push_back(tin_.nodes[at(node)]);
    std::vector<double> noise(places.size());
    geom::fbm_places(seed, waves, places, noise);
    double lowest = 0.0;
    for (size_t i = 0; i < order_.size(); ++i) {
      const int32_t node = order_[i];
      const Offshore& o = offshore_[at(node)];
      if (cap_[at(node)] == kFar) {
        const double sway = kSway * o.away / (1.0 + o.away * kSway / (kMostSway * width_));
        height_[at(node)] = fallen(o.outline_m, o.slope, o.away + sway * std::clamp(noise[i], -1.0, 1.0));
      }
      lowest = std::min(lowest, height_[at(node)]);
    }
    for (const int32_t node : sea_) {  // no coast in sight: no network of ours has such nodes
      if (offshore_[at(node)].away == kFar) height_[at(node)] = lowest;
    }
  }

  /// From the network's edge inwards, each node higher than one before it.
  void drain() {
    std::vector<uint8_t> seen(tin_.nodes.size(), 0);
    std::vector<int32_t> below(tin_.nodes.size(), -1), order;
    const auto flow_to = [&](const std::vector<int32_t>& outlets) {
      using Open = std::pair<double, int32_t>;
      std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
      for (const int32_t node : outlets) open.emplace(height_[at(node)], node), seen[at(node)] = 1;
      while (!open.empty()) {
        const int32_t node = open.top().second;
        open.pop();
        if (order.size() % 4096 == 0) run_.check_cancelled();
        order.push_back(node);
        for (const int32_t neighbour : graph_.around(at(node))) {
          if (tin_.region[at(neighbour)] != Tin::kOutside || seen[at(neighbour)] != 0) continue;
          seen[at(neighbour)] = 1;
          below[at(neighbour)] = node;
          lift(neighbour, below);
          open.emplace(height_[at(neighbour)], neighbour);
        }
      }
    };
    const std::vector<uint8_t> edge = edge_nodes(tin_, graph_);
    std::vector<int32_t> outlets;
    std::copy_if(sea_.begin(), sea_.end(), std::back_inserter(outlets),
                 [&](int32_t node) { return edge[at(node)] != 0; });
    flow_to(outlets);
    for (const int32_t node : sea_) {  // a part that the network's edge does not reach
      if (seen[at(node)] == 0) flow_to({lowest_of_part(node, seen)});
    }
    round(order, below);
  }

 private:
  double longest_side(size_t node) const {
    double longest = 0.0;
    for (const int32_t n : graph_.around(node))
      longest = std::max(longest, length(tin_.nodes[at(n)] - tin_.nodes[node]));
    return longest;
  }

  /// Coasts of neighbours that are nearer to them count as much as the own: no creases where the nearest coast changes.
  void average_coasts() {
    smooth_coast();
    for (const int32_t node : order_) {
      Offshore& o = offshore_[at(node)];
      if (cap_[at(node)] != kFar) continue;
      double slope = 0.0, outline = 0.0, count = 0.0;
      for (const int32_t neighbour : graph_.around(at(node))) {
        const Offshore& near = offshore_[at(neighbour)];
        if (tin_.region[at(neighbour)] != Tin::kOutside || !(near.away < o.away)) continue;
        slope += near.slope;
        outline += near.outline_m;
        count += 1.0;
      }
      if (count == 0.0) continue;
      o.slope = slope / count;
      o.outline_m = outline / count;
    }
  }

  /// Slopes at the coast, averaged along it: a cove's wall does not make a canyon.
  void smooth_coast() {
    constexpr int kRounds = 20;
    std::vector<int32_t> coast;
    for (const int32_t node : order_) {
      if (cap_[at(node)] == kFar) continue;
      coast.push_back(node);
      offshore_[at(node)].slope = std::clamp(offshore_[at(node)].slope, kGentlestCoast, kSteepestCoast);
    }
    std::vector<double> next(coast.size());
    for (int round = 0; round < kRounds; ++round) {
      run_.check_cancelled();
      for (size_t i = 0; i < coast.size(); ++i) {
        double sum = offshore_[at(coast[i])].slope, count = 1.0;
        for (const int32_t neighbour : graph_.around(at(coast[i]))) {
          if (cap_[at(neighbour)] == kFar) continue;
          sum += offshore_[at(neighbour)].slope;
          count += 1.0;
        }
        next[i] = sum / count;
      }
      for (size_t i = 0; i < coast.size(); ++i) offshore_[at(coast[i])].slope = next[i];
    }
  }

  /// The height at a distance from an outline.
  double fallen(double outline_m, double coast, double away) const {
    const double dry = std::clamp(outline_m / kNoCoast, 0.0, 1.0);
    const double flank = flank_ + dry * (std::min(flank_, kOnLand) - flank_);
    const double relaxation = std::max(kRelaxation * width_ / std::max(coast, 1.0), 1e-3);
    const double fall = flank * away + (coast - flank) * relaxation * (1.0 - std::exp(-away / relaxation));
    const double z = outline_m - fall;
    if (z >= 0.0) return z;
    const double start = std::max(-outline_m, 0.0);  // what lies below the sea already keeps its depth
    return -(flattened(-z) - flattened(start) + start);
  }

  void lift(int32_t node, const std::vector<int32_t>& below) {
    const int32_t to = below[at(node)];
    const double least = height_[at(to)] + kPlain * length(tin_.nodes[at(node)] - tin_.nodes[at(to)]);
    if (height_[at(node)] >= least) return;
    height_[at(node)] = std::min(least, cap_[at(node)]);
    double above = height_[at(node)];  // between outlines of different heights the way down is cut instead
    for (int32_t next = to; next >= 0 && height_[at(next)] >= above; next = below[at(next)]) {
      height_[at(next)] = above - kBelowCap;
      above = height_[at(next)];
    }
  }

  int32_t lowest_of_part(int32_t first, const std::vector<uint8_t>& seen) const {
    std::vector<uint8_t> reached(seen);
    std::vector<int32_t> part = {first};
    reached[at(first)] = 1;
    int32_t lowest = first;
    for (size_t i = 0; i < part.size(); ++i) {
      if (height_[at(part[i])] < height_[at(lowest)]) lowest = part[i];
      for (const int32_t neighbour : graph_.around(at(part[i]))) {
        if (tin_.region[at(neighbour)] != Tin::kOutside || reached[at(neighbour)] != 0) continue;
        reached[at(neighbour)] = 1;
        part.push_back(neighbour);
      }
    }
    return lowest;
  }

  /// To floats that differ.
  void round(const std::vector<int32_t>& order, const std::vector<int32_t>& below) {
    for (const int32_t node : order) {
      auto z = static_cast<float>(height_[at(node)]);
      if (below[at(node)] >= 0) {
        const auto under = static_cast<float>(height_[at(below[at(node)])]);
        if (z <= under) z = std::nextafter(under, std::numeric_limits<float>::max());
      }
      height_[at(node)] = static_cast<double>(z);
    }
  }

  const Tin& tin_;
  const geom::NodeGraph& graph_;
  const std::vector<float>& beside_;
  double flank_, width_;
  std::vector<double>& height_;
  const RunContext& run_;
  std::vector<int32_t> sea_, order_;  ///< nodes outside; the same from the coast outwards
  std::vector<Offshore> offshore_;    ///< by node
  std::vector<double> cap_;           ///< of nodes beside an outline
};

}  // namespace

void fall_outside(const Tin& tin, const geom::NodeGraph& graph, const std::vector<RegionBand>& bands,
                  const std::vector<Shore>& shores, const std::vector<float>& beside, double slope, double width_m,
                  std::vector<double>& height, const RunContext& run) {
  if (std::find(tin.region.begin(), tin.region.end(), Tin::kOutside) == tin.region.end()) return;
  SeaFloor floor(tin, graph, beside, slope, width_m, height, run);
  floor.enter_coast(bands, shores);
  floor.find_coasts();
  floor.lay();
  floor.drain();
}

}  // namespace seamount::contour
