#include "seamount/ops/hydrology/flow_spread.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <vector>

#include "seamount/base/parallel.h"

namespace seamount::hydrology {
namespace {

using geom::FlowDirections;
using geom::kFlowDx;
using geom::kFlowDy;
using geom::kFlowLength;

constexpr uint8_t opposite(uint8_t k) { return static_cast<uint8_t>((k + 4) % 8); }

/// The share of a cell's water that neighbour k gets, of a D-infinity direction.
struct DinfShare {
  const ScalarField& directions;
  float operator()(int x, int y, uint8_t k) const {
    const float direction = directions(x, y);
    if (direction < 0.0F) return 0.0F;
    const auto whole = static_cast<int>(direction);
    const float part = direction - static_cast<float>(whole);
    if (whole % 8 == k) return 1.0F - part;
    return (whole + 1) % 8 == k ? part : 0.0F;
  }
};

/// The same over all lower neighbours; `norm` is 1 / sum of slope^exponent, 0 where `d8` takes all.
struct MfdShare {
  const HeightField& filled;
  const FlowDirections& d8;
  const ScalarField& norm;
  float sea;
  double exponent;
  float weight(int x, int y, uint8_t k) const {
    const float fall = filled(x, y) - std::max(sea, filled(x + kFlowDx[k], y + kFlowDy[k]));
    if (!(fall > 0.0F)) return 0.0F;
    const float slope = fall / kFlowLength[k];
    return exponent == 1.0 ? slope : static_cast<float>(std::pow(slope, exponent));
  }
  float operator()(int x, int y, uint8_t k) const {
    const uint8_t code = d8(x, y);
    if (code >= 8) return 0.0F;
    return norm(x, y) > 0.0F ? weight(x, y, k) * norm(x, y) : code == k ? 1.0F : 0.0F;
  }
};

/// Sums downstream in parallel: a cell is summed by whoever brings the last of its donors, in the order of directions.
template <class Share>
class Spread {
 public:
  Spread(const FlowDirections& d8, const Share& share, const RunContext& run)
      : d8_(d8), share_(share), waiting_(d8.frame()), sums_(d8.frame()) {
    parallel_rows(run.part(0.0, 0.4), d8.width(), d8.height(), [&](int begin, int end) {
      for (int y = begin; y < end; ++y) {
        for (int x = 0; x < d8.width(); ++x) {
          uint8_t donors = 0;
          for_each_donor(x, y, [&](int, int, float) { ++donors; });
          waiting_(x, y) = donors;
        }
      }
    });
    // A source is known by the copy: waiting_ changes while others run.
    const Grid<uint8_t> donors = waiting_;
    parallel_rows(run.part(0.4, 1.0), d8.width(), d8.height(), [&](int begin, int end) {
      std::vector<std::pair<int, int>> ready;
      for (int y = begin; y < end; ++y) {
        for (int x = 0; x < d8.width(); ++x) {
          if (donors(x, y) == 0) ready.emplace_back(x, y);
          while (!ready.empty()) finish(ready);
        }
      }
    });
  }

  ScalarField take() { return std::move(sums_); }

 private:
  template <class Visit>
  void for_each_donor(int x, int y, const Visit& visit) const {
    for (uint8_t k = 0; k < 8; ++k) {
      const int from_x = x + kFlowDx[k], from_y = y + kFlowDy[k];
      if (!d8_.contains(from_x, from_y) || d8_(from_x, from_y) >= 8) continue;
      const float part = share_(from_x, from_y, opposite(k));
      if (part > 0.0F) visit(from_x, from_y, part);
    }
  }

  void finish(std::vector<std::pair<int, int>>& ready) {
    const auto [x, y] = ready.back();
    ready.pop_back();
    double total = 1.0;
    for_each_donor(
        x, y, [&](int from_x, int from_y, float part) { total += static_cast<double>(part) * sums_(from_x, from_y); });
    sums_(x, y) = static_cast<float>(total);
    if (d8_(x, y) >= 8) return;
    for (uint8_t k = 0; k < 8; ++k) {
      if (!(share_(x, y, k) > 0.0F)) continue;
      const int to_x = x + kFlowDx[k], to_y = y + kFlowDy[k];
      if (std::atomic_ref(waiting_(to_x, to_y)).fetch_sub(1, std::memory_order_acq_rel) == 1)
        ready.emplace_back(to_x, to_y);
    }
  }

  const FlowDirections& d8_;
  const Share& share_;
  Grid<uint8_t> waiting_;
  ScalarField sums_;
};

/// Steepest of the eight facets; below 0 if none falls.
float steepest_facet(const HeightField& filled, int x, int y, float sea) {
  const auto height = [&](uint8_t k) -> double {
    return std::max(sea, filled(x + kFlowDx[k % 8], y + kFlowDy[k % 8]));
  };
  const double here = filled(x, y);
  double best = 0.0, direction = -1.0;
  for (uint8_t facet = 0; facet < 8; ++facet) {
    const auto next = static_cast<uint8_t>(facet + 1);
    const bool odd = facet % 2 == 1;  // then the straight neighbour comes second
    const double straight = height(odd ? next : facet), slanted = height(odd ? facet : next);
    const double s1 = here - straight, s2 = straight - slanted;
    double turn = 0.0, slope = s1;
    if (s2 > 0.0 && s1 > s2) {
      turn = std::atan2(s2, s1) / (0.25 * std::numbers::pi);
      slope = std::sqrt(s1 * s1 + s2 * s2);
    } else if (s2 > 0.0) {
      turn = 1.0;
      slope = (here - slanted) / std::numbers::sqrt2;
    }
    if (slope <= best) continue;
    best = slope;
    direction = odd ? next - turn : facet + turn;
  }
  return static_cast<float>(direction);
}

}  // namespace

ScalarField dinf_directions(const HeightField& filled, const FlowDirections& d8, float sea_level_m,
                            const RunContext& run) {
  ScalarField directions(filled.frame());
  parallel_rows(run, filled.width(), filled.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < filled.width(); ++x) {
        const uint8_t code = d8(x, y);
        float direction = -1.0F;
        if (code < 8) {
          direction = steepest_facet(filled, x, y, sea_level_m);
          if (direction < 0.0F) direction = code;
        }
        directions(x, y) = direction;
      }
    }
  });
  return directions;
}

ScalarField dinf_accumulation(const ScalarField& directions, const FlowDirections& d8, const RunContext& run) {
  const DinfShare share{directions};
  return Spread<DinfShare>(d8, share, run).take();
}

ScalarField mfd_accumulation(const HeightField& filled, const FlowDirections& d8, float sea_level_m, double exponent,
                             const RunContext& run) {
  ScalarField norm(filled.frame(), 0.0F);
  const MfdShare share{filled, d8, norm, sea_level_m, exponent};
  parallel_rows(run.part(0.0, 0.3), filled.width(), filled.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < filled.width(); ++x) {
        if (d8(x, y) >= 8) continue;
        double sum = 0.0;
        for (uint8_t k = 0; k < 8; ++k) sum += static_cast<double>(share.weight(x, y, k));
        // A fall too small for its power leaves the water to D8.
        if (sum > 1e-30) norm(x, y) = static_cast<float>(1.0 / sum);
      }
    }
  });
  return Spread<MfdShare>(d8, share, run.part(0.3, 1.0)).take();
}

}  // namespace seamount::hydrology
