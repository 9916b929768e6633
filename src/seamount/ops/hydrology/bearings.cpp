#include "seamount/ops/hydrology/bearings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/surface.h"
#include "seamount/geom/scalar/quantile.h"

namespace seamount::hydrology {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace

void Bearings::add(float bearing_deg) {
  const auto bin = static_cast<size_t>(static_cast<double>(bearing_deg) / kBinDeg);
  ++counts[std::min(bin, kBins - 1)];
  const float angle = bearing_deg * static_cast<float>(std::numbers::pi / 180.0);
  north += static_cast<double>(std::cos(angle));
  east += static_cast<double>(std::sin(angle));
}

Bearings& Bearings::operator+=(const Bearings& other) {
  for (size_t i = 0; i < kBins; ++i) counts[i] += other.counts[i];
  north += other.north;
  east += other.east;
  return *this;
}

int64_t Bearings::total() const { return std::accumulate(counts.begin(), counts.end(), int64_t{0}); }

double Bearings::mean_deg() const {
  if (total() == 0) return kNaN;
  const double bearing = std::atan2(east, north) * 180.0 / std::numbers::pi;
  const double turned = bearing < 0.0 ? bearing + 360.0 : bearing;
  return turned < 360.0 ? turned : 0.0;
}

double Bearings::strength() const {
  return total() == 0 ? kNaN : std::hypot(north, east) / static_cast<double>(total());
}

Bearings aspects(const HeightField& terrain, const HeightField& surface, float sea_level_m, const RunContext& run) {
  constexpr int64_t kGrain = int64_t{1} << 16;
  const ScalarField bearing = geom::aspect_deg(surface, run);
  return parallel_sum<Bearings>(run, terrain.frame().cells(), kGrain, [&](int64_t begin, int64_t end) {
    Bearings part;
    for (int64_t i = begin; i < end; ++i)
      if (terrain.data()[i] > sea_level_m && bearing.data()[i] >= 0.0F) part.add(bearing.data()[i]);
    return part;
  });
}

double circular_wasserstein(const Bearings& a, const Bearings& b) {
  const auto all_a = static_cast<double>(a.total()), all_b = static_cast<double>(b.total());
  if (all_a == 0.0 || all_b == 0.0) return kNaN;
  std::array<double, Bearings::kBins> gaps{};  // of the cumulative curves after each bin
  double gap = 0.0;
  for (size_t i = 0; i < gaps.size(); ++i) {
    gap += static_cast<double>(a.counts[i]) / all_a - static_cast<double>(b.counts[i]) / all_b;
    gaps[i] = gap;
  }
  const double middle = geom::median(std::vector<double>(gaps.begin(), gaps.end()));
  double area = 0.0;
  for (const double each : gaps) area += std::abs(each - middle) * Bearings::kBinDeg;
  return area;
}

}  // namespace seamount::hydrology
