#include "seamount/ops/contour/heights/distribution.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/geom/scalar/curve.h"

namespace seamount::contour {
namespace {

constexpr int kDensityBins = 512;

/// Densities over the share of the range. Mountains: most ground on the lower slopes, few high summits. Hills: about
/// the middle. A plateau: a plain, a scarp and a wide top. A coast: lowland that thins out inland. A volcano: a cone
/// whose flanks steepen upwards, so that area falls with the square of the height that is left. A canyon: a plateau
/// with walls, benches and a narrow floor.
Curve landform_density(Landform landform) {
  switch (landform) {
    case Landform::uniform:
      return {{{0, 1}, {1, 1}}};
    case Landform::hills:
      return {{{0, 0.25}, {0.2, 0.9}, {0.42, 1.5}, {0.7, 0.75}, {1, 0.06}}};
    case Landform::plateau:
      return {{{0, 2.2}, {0.1, 1.1}, {0.2, 0.3}, {0.66, 0.3}, {0.8, 1.6}, {0.9, 3.0}, {1, 0.5}}};
    case Landform::coastal:
      return {{{0, 3.2}, {0.08, 2.5}, {0.2, 1.4}, {0.45, 0.65}, {0.75, 0.28}, {1, 0.05}}};
    case Landform::volcano:
      return {{{0, 2.6}, {0.12, 1.9}, {0.3, 1.15}, {0.55, 0.62}, {0.8, 0.34}, {1, 0.16}}};
    case Landform::canyon:
      return {{{0, 0.7}, {0.1, 0.25}, {0.3, 0.3}, {0.42, 0.8}, {0.5, 0.35}, {0.72, 0.4}, {0.86, 2.8}, {1, 1.2}}};
    case Landform::mountain:
      break;
  }
  return {{{0, 0.6}, {0.12, 1.25}, {0.28, 1.5}, {0.5, 1.05}, {0.75, 0.5}, {0.92, 0.17}, {1, 0.04}}};
}

}  // namespace

HeightDistribution HeightDistribution::from_bins(const std::vector<double>& bins, double low_m, double high_m,
                                                 const std::string& field) {
  if (bins.empty()) throw InvalidArgument(field, "no bins; give how much ground lies at each height, lowest first");
  if (!(low_m < high_m)) {
    throw InvalidArgument(field, fmt::format("its heights end at {} m, not above their begin at {} m",
                                             format_number(high_m), format_number(low_m)));
  }
  HeightDistribution made;
  made.low_ = low_m;
  made.high_ = high_m;
  double sum = 0.0;
  made.below_.push_back(0.0);
  for (size_t i = 0; i < bins.size(); ++i) {
    if (!std::isfinite(bins[i]) || bins[i] < 0.0) {
      throw InvalidArgument(field, fmt::format("bin {} is {}; no bin lies below 0", i, format_number(bins[i])));
    }
    made.below_.push_back(sum += bins[i]);
  }
  if (!(sum > 0.0) || !std::isfinite(sum)) throw InvalidArgument(field, "all bins are 0; no ground lies at any height");
  for (double& below : made.below_) below /= sum;
  return made;
}

HeightDistribution HeightDistribution::from_density(const Curve& density, double low_m, double high_m,
                                                    const std::string& field) {
  if (density.knots.size() < 2) throw InvalidArgument(field, "a density needs at least two knots");
  for (const Knot& knot : density.knots) {
    if (knot.x >= 0.0 && knot.x <= 1.0) continue;
    throw InvalidArgument(
        field, fmt::format("x = {} is outside [0, 1], the share of the range of heights", format_number(knot.x)));
  }
  const geom::CurveFunction function(density, geom::CurveKind::monotone_cubic, field);
  std::vector<double> bins;
  bins.reserve(kDensityBins);
  for (int i = 0; i < kDensityBins; ++i) bins.push_back(function((i + 0.5) / kDensityBins));
  return from_bins(bins, low_m, high_m, field);
}

HeightDistribution HeightDistribution::of_landform(Landform landform, double low_m, double high_m) {
  return from_density(landform_density(landform), low_m, high_m, "landform");
}

double HeightDistribution::share_below(double z) const {
  const auto bins = static_cast<double>(below_.size() - 1);
  const double t = std::clamp((z - low_) / (high_ - low_), 0.0, 1.0) * bins;
  const auto bin = std::min(static_cast<size_t>(t), below_.size() - 2);
  return below_[bin] + (t - static_cast<double>(bin)) * (below_[bin + 1] - below_[bin]);
}

double HeightDistribution::quantile(double from, double to, double u) const {
  u = std::clamp(u, 0.0, 1.0);
  const double first = share_below(from);
  const double last = share_below(to);
  if (!(last > first) || from < low_ || to > high_) return from + u * (to - from);
  const double share = first + u * (last - first);
  // The first edge with at least this much below it ends the bin.
  const auto edge = std::lower_bound(below_.begin() + 1, below_.end() - 1, share);
  const auto bin = static_cast<size_t>(edge - below_.begin()) - 1;
  const double mass = below_[bin + 1] - below_[bin];
  const double within = mass > 0.0 ? std::clamp((share - below_[bin]) / mass, 0.0, 1.0) : 0.0;
  const double width = (high_ - low_) / static_cast<double>(below_.size() - 1);
  return std::clamp(low_ + (static_cast<double>(bin) + within) * width, from, to);
}

MeasuredHeights measure_heights(const HeightField& terrain, double above_m, int bins) {
  double low = 0.0;
  double high = 0.0;
  bool any = false;
  const auto counts = [&](float z) { return std::isfinite(z) && static_cast<double>(z) >= above_m; };
  for (const float z : terrain.cells()) {
    if (!counts(z)) continue;
    low = any ? std::min(low, static_cast<double>(z)) : static_cast<double>(z);
    high = any ? std::max(high, static_cast<double>(z)) : static_cast<double>(z);
    any = true;
  }
  if (!any) throw IncompatibleInputs(fmt::format("terrain: no cell lies at or above {} m", format_number(above_m)));
  if (!(high > low)) {
    throw IncompatibleInputs(
        fmt::format("terrain: it lies at {} m everywhere and shows no distribution of heights", format_number(low)));
  }
  MeasuredHeights measured{std::vector<double>(static_cast<size_t>(bins), 0.0), low, high};
  for (const float z : terrain.cells()) {
    if (!counts(z)) continue;
    const double t = (static_cast<double>(z) - low) / (high - low) * bins;
    measured.bins[static_cast<size_t>(std::clamp(t, 0.0, bins - 1.0))] += 1.0;
  }
  return measured;
}

}  // namespace seamount::contour
