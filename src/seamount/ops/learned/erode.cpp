#include "seamount/ops/learned/erode.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/model/same_size.h"
#include "seamount/ops/learned/erode_planes.h"

namespace seamount::learned {
namespace {

struct Bounds {
  float low = std::numeric_limits<float>::infinity(), high = -low;
  void widen(const Bounds& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
};

/// Lowest and highest ground of the four squares of kErodeReach cells around each of their corners.
Grid<Bounds> bounds_of(const HeightField& terrain, const RunContext& run) {
  const auto squares = [](int cells) { return (cells + kErodeReach - 1) / kErodeReach; };
  const GridFrame frame = GridFrame::centred(squares(terrain.width()), squares(terrain.height()), 1);
  Grid<Bounds> own(frame), corners(GridFrame::centred(frame.width + 1, frame.height + 1, 1));
  parallel_blocks(run, frame.height, 1, [&](int64_t row, int64_t) {
    const int v = static_cast<int>(row);
    std::fill(own.row(v).begin(), own.row(v).end(), Bounds());
    for (int y = v * kErodeReach; y < std::min((v + 1) * kErodeReach, terrain.height()); ++y) {
      for (int x = 0; x < terrain.width(); ++x) own(x / kErodeReach, v).widen({terrain(x, y), terrain(x, y)});
    }
  });
  for (int v = 0; v <= frame.height; ++v) {
    for (int u = 0; u <= frame.width; ++u) {
      for (int dv = -1; dv <= 0; ++dv)
        for (int du = -1; du <= 0; ++du) corners(u, v).widen(own.clamped(u + du, v + dv));
    }
  }
  return corners;
}

/// Between its square's corners, so that no square shows: beyond no ground of the nine squares around, and this side of
/// no ground of its own.
Bounds bounds_at(const Grid<Bounds>& corners, int x, int y) {
  const int u = x / kErodeReach, v = y / kErodeReach;
  constexpr float kPer = 1.0F / kErodeReach;
  const float right = (static_cast<float>(x % kErodeReach) + 0.5F) * kPer,
              down = (static_cast<float>(y % kErodeReach) + 0.5F) * kPer;
  const auto between = [&](float Bounds::*which) {
    const float upper = corners(u, v).*which + right * (corners(u + 1, v).*which - corners(u, v).*which);
    const float lower = corners(u, v + 1).*which + right * (corners(u + 1, v + 1).*which - corners(u, v + 1).*which);
    return upper + down * (lower - upper);
  };
  return {between(&Bounds::low), between(&Bounds::high)};
}

/// Lets the network's `plane` move ground about and neither make nor take any: what it adds in sum is taken from where
/// most changes, so that the mean falls by what the estimate's rivers carry away.
void take_drift(const ScalarField& base, ScalarField& plane, const RunContext& run) {
  struct Sums {
    double added = 0, change = 0;
    Sums& operator+=(const Sums& other) {
      added += other.added;
      change += other.change;
      return *this;
    }
  };
  constexpr int64_t kGrain = 1 << 16;
  const auto count = static_cast<int64_t>(base.size());
  const auto sums = parallel_sum<Sums>(run, count, kGrain, [&](int64_t begin, int64_t end) {
    Sums part;
    for (int64_t i = begin; i < end; ++i) {
      part.added += plane.data()[i];
      part.change += std::abs(base.data()[i] + plane.data()[i]);
    }
    return part;
  });
  if (!(sums.change > 0)) return;
  const auto share = static_cast<float>(sums.added / sums.change);
  parallel_blocks(run, count, kGrain, [&](int64_t begin, int64_t end) {
    for (int64_t i = begin; i < end; ++i) plane.data()[i] -= share * std::abs(base.data()[i] + plane.data()[i]);
  });
}

void check_inputs(const HeightField& terrain, const Mask* mask, const Network& network) {
  if (network.architecture().planes != kErodePlanes)
    throw InvalidArgument("model", "is a network of " + std::to_string(network.architecture().planes) +
                                       " planes, and erosion has " + std::to_string(kErodePlanes));
  if (mask != nullptr) check_same_size("mask", mask->frame(), terrain.frame());
  for (const float z : terrain.cells()) {
    if (!std::isfinite(z)) throw InvalidArgument("terrain", "has cells of which nothing is known: fill them first");
  }
}

}  // namespace

HeightField erode(const HeightField& terrain, const Mask* mask, const ErodeParams& params, const Network& network,
                  const RunContext& run) {
  check_params(params);
  check_inputs(terrain, mask, network);
  if (params.years == 0 || params.strength == 0) return terrain;
  const ErodePlanes planes(terrain, std::max(params.years, kFewestYears), params.sea_m, run.part(0, 0.5));
  if (planes.unit_m() == 0) return terrain;
  HeightField heights = network.evaluate(planes.planes(), terrain.frame(), run.part(0.5, 1));
  take_drift(planes.base(), heights, run);
  const Grid<Bounds> bounds = bounds_of(terrain, run);
  const auto unit = static_cast<float>(planes.unit_m()),
             strength = static_cast<float>(params.strength * std::min(1.0, params.years / kFewestYears));
  parallel_rows(run, terrain.width(), terrain.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < terrain.width(); ++x) {
        const float z = terrain(x, y), made = z + unit * (planes.base()(x, y) + heights(x, y));
        Bounds bound = bounds_at(bounds, x, y);
        bound.widen({z, z});  // rounding
        const float share = strength * (mask == nullptr ? 1.0F : std::clamp((*mask)(x, y), 0.0F, 1.0F));
        const float kept = z + share * (std::clamp(made, bound.low, bound.high) - z);
        heights(x, y) = share > 0 ? std::clamp(kept, bound.low, bound.high) : z;
      }
    }
  });
  return heights;
}

}  // namespace seamount::learned
