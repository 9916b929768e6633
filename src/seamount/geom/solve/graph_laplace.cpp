#include "seamount/geom/solve/graph_laplace.h"

#include <algorithm>
#include <cmath>

namespace seamount::geom {
namespace {

constexpr size_t kCoarsest = 64;  ///< nodes
constexpr int kSteps = 16;        ///< on the finest level; twice as many on each coarser one, up to four times

struct Edge {
  int32_t to;
  float weight;
};

/// What is free, with its sides among each other; sides to fixed nodes are summed up as anchors.
struct Level {
  std::vector<uint32_t> starts;
  std::vector<Edge> edges;
  std::vector<double> anchor;       ///< weight of the sides to fixed nodes
  std::vector<double> anchor_pull;  ///< the same times their values
  std::vector<double> value;

  size_t size() const { return value.size(); }
};

Level finest(std::span<const uint32_t> starts, std::span<const int32_t> neighbours, std::span<const uint8_t> fixed,
             std::span<const double> value) {
  Level level;
  const size_t n = value.size();
  level.starts.assign(1, 0);
  level.edges.reserve(neighbours.size());
  level.anchor.assign(n, 0.0);
  level.anchor_pull.assign(n, 0.0);
  level.value.assign(value.begin(), value.end());
  for (size_t i = 0; i < n; ++i) {
    for (uint32_t e = starts[i]; e < starts[i + 1] && fixed[i] == 0; ++e) {
      const auto to = static_cast<size_t>(neighbours[e]);
      if (fixed[to] == 0) {
        level.edges.push_back({neighbours[e], 1.0F});
      } else {
        level.anchor[i] += 1.0;
        level.anchor_pull[i] += value[to];
      }
    }
    level.starts.push_back(static_cast<uint32_t>(level.edges.size()));
  }
  return level;
}

/// Groups of four. Sides between two groups add up.
Level coarsen(const Level& fine) {
  const size_t groups = (fine.size() + 3) / 4;
  Level coarse;
  coarse.starts.assign(1, 0);
  coarse.anchor.assign(groups, 0.0);
  coarse.anchor_pull.assign(groups, 0.0);
  coarse.value.assign(groups, 0.0);
  std::vector<Edge> around;
  for (size_t g = 0; g < groups; ++g) {
    const size_t last = std::min(4 * g + 4, fine.size());
    around.clear();
    for (size_t i = 4 * g; i < last; ++i) {
      coarse.anchor[g] += fine.anchor[i];
      coarse.anchor_pull[g] += fine.anchor_pull[i];
      coarse.value[g] += fine.value[i] / static_cast<double>(last - 4 * g);
      for (uint32_t e = fine.starts[i]; e < fine.starts[i + 1]; ++e) {
        const int32_t to = fine.edges[e].to / 4;
        if (static_cast<size_t>(to) != g) around.push_back({to, fine.edges[e].weight});
      }
    }
    std::stable_sort(around.begin(), around.end(), [](const Edge& a, const Edge& b) { return a.to < b.to; });
    for (const Edge& edge : around) {
      const bool same = coarse.edges.size() > coarse.starts.back() && coarse.edges.back().to == edge.to;
      if (same) {
        coarse.edges.back().weight += edge.weight;
      } else {
        coarse.edges.push_back(edge);
      }
    }
    coarse.starts.push_back(static_cast<uint32_t>(coarse.edges.size()));
  }
  return coarse;
}

/// Conjugate gradients with the diagonal as preconditioner, from the values as they are. `pull`: how much nearer
/// anchors are than neighbours: a group's middle lies half as far from its edge as from the next one's middle.
class Relaxation {
 public:
  Relaxation(Level& level, double pull) : level_(level), pull_(pull), diagonal_(level.size(), 0.0) {
    for (size_t i = 0; i < level.size(); ++i) {
      double weights = pull * level.anchor[i];
      for (uint32_t e = level.starts[i]; e < level.starts[i + 1]; ++e) {
        weights += static_cast<double>(level.edges[e].weight);
      }
      diagonal_[i] = weights;
    }
  }

  void run(int steps, const RunContext& run) {
    const size_t n = level_.size();
    std::vector<double> residual(n, 0.0);
    std::vector<double> direction(n, 0.0);
    std::vector<double> image(n, 0.0);
    apply(level_.value, image);
    for (size_t i = 0; i < n; ++i) {
      residual[i] = pull_ * level_.anchor_pull[i] - image[i];
      direction[i] = scaled(residual, i);
    }
    double energy = energy_of(residual);
    const double enough = 1e-12 * energy;
    for (int step = 0; step < steps && energy > enough; ++step) {
      run.check_cancelled();
      apply(direction, image);
      double curvature = 0.0;
      for (size_t i = 0; i < n; ++i) curvature += direction[i] * image[i];
      if (!(curvature > 0.0)) return;
      const double along = energy / curvature;
      for (size_t i = 0; i < n; ++i) {
        level_.value[i] += along * direction[i];
        residual[i] -= along * image[i];
      }
      const double before = energy;
      energy = energy_of(residual);
      for (size_t i = 0; i < n; ++i) direction[i] = scaled(residual, i) + energy / before * direction[i];
    }
  }

 private:
  double scaled(const std::vector<double>& v, size_t i) const { return diagonal_[i] > 0.0 ? v[i] / diagonal_[i] : 0.0; }

  double energy_of(const std::vector<double>& residual) const {
    double sum = 0.0;
    for (size_t i = 0; i < residual.size(); ++i) sum += residual[i] * scaled(residual, i);
    return sum;
  }

  void apply(const std::vector<double>& v, std::vector<double>& image) const {
    for (size_t i = 0; i < v.size(); ++i) {
      double sum = diagonal_[i] * v[i];
      for (uint32_t e = level_.starts[i]; e < level_.starts[i + 1]; ++e) {
        sum -= static_cast<double>(level_.edges[e].weight) * v[static_cast<size_t>(level_.edges[e].to)];
      }
      image[i] = sum;
    }
  }

  Level& level_;
  double pull_;
  std::vector<double> diagonal_;
};

/// Nodes that no way leads from to a fixed one keep their values.
std::vector<uint8_t> reached_from_fixed(std::span<const uint32_t> starts, std::span<const int32_t> neighbours,
                                        std::span<const uint8_t> fixed) {
  std::vector<uint8_t> reached(fixed.begin(), fixed.end());
  std::vector<int32_t> open;
  for (size_t i = 0; i < fixed.size(); ++i) {
    if (fixed[i] != 0) open.push_back(static_cast<int32_t>(i));
  }
  while (!open.empty()) {
    const auto node = static_cast<size_t>(open.back());
    open.pop_back();
    for (uint32_t e = starts[node]; e < starts[node + 1]; ++e) {
      uint8_t& there = reached[static_cast<size_t>(neighbours[e])];
      if (there == 0) open.push_back(neighbours[e]);
      there = 1;
    }
  }
  return reached;
}

}  // namespace

void solve_graph_laplace(std::span<const uint32_t> starts, std::span<const int32_t> neighbours,
                         std::span<const uint8_t> fixed, std::span<double> value, const RunContext& run) {
  std::vector<Level> levels;
  levels.push_back(finest(starts, neighbours, fixed, value));
  while (levels.back().size() > kCoarsest) {
    run.check_cancelled();
    levels.push_back(coarsen(levels.back()));
  }
  for (size_t l = levels.size(); l-- > 0;) {
    if (l + 1 < levels.size()) {
      for (size_t i = 0; i < levels[l].size(); ++i) levels[l].value[i] = levels[l + 1].value[i / 4];
    }
    Relaxation(levels[l], l == 0 ? 1.0 : 2.0).run(kSteps << std::min<size_t>(l, 4), run);
  }
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (size_t i = 0; i < value.size(); ++i) {
    if (fixed[i] == 0) continue;
    low = std::min(low, value[i]);
    high = std::max(high, value[i]);
  }
  const std::vector<uint8_t> reached = reached_from_fixed(starts, neighbours, fixed);
  for (size_t i = 0; i < value.size(); ++i) {
    if (fixed[i] == 0 && reached[i] != 0) value[i] = std::clamp(levels[0].value[i], low, high);
  }
}

}  // namespace seamount::geom
