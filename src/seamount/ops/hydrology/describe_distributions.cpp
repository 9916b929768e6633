#include "seamount/ops/hydrology/describe_distributions.h"

#include <algorithm>
#include <cmath>

namespace seamount::hydrology {
namespace {

using Distributions = std::vector<Distribution>;

/// Values from which on a plot shows them: all but a thousandth at both ends.
struct Span {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();

  explicit Span(const Distributions& all) {
    constexpr double kHardly = 0.001;
    for (const Distribution& one : all) {
      if (one.empty()) continue;
      low = std::min(low, one.quantile(kHardly));
      high = std::max(high, one.quantile(1.0 - kHardly));
    }
    const double least = std::max(1e-6, 1e-3 * std::max(std::abs(low), std::abs(high)));
    if (high - low < least) low -= least, high += least;
  }
};

/// Density over the value in bins of one width, on the same axis for all.
std::vector<PlotLine> density_lines(const Distributions& all, int bins, bool logarithmic) {
  const Span span(all);
  const double width = (span.high - span.low) / bins;
  std::vector<PlotLine> lines(all.size());
  for (size_t s = 0; s < all.size(); ++s) {
    if (all[s].empty()) continue;
    for (int i = 0; i < bins; ++i) {
      const double from = span.low + i * width, to = i + 1 == bins ? span.high : from + width;
      const double share = (i + 1 == bins ? all[s].up_to(to) : all[s].below(to)) - all[s].below(from);
      const double middle = 0.5 * (from + to);
      lines[s].x.push_back(logarithmic ? std::pow(10.0, middle) : middle);
      lines[s].y.push_back(share / width);
    }
  }
  return lines;
}

/// Wasserstein distance over the reference's deviation, or the terrain's where the reference is all one value. Nothing
/// where there is nothing to compare, or both are all one value and not the same.
std::optional<double> relative_distance(const Distributions& all) {
  if (all.size() != 2) return std::nullopt;
  const double moved = wasserstein(all[0], all[1]);
  const double own = all[0].deviation(), reference = all[1].deviation();
  return moved == 0.0 ? std::optional(0.0) : defined(moved / (reference > 0.0 ? reference : own));
}

}  // namespace

Descriptor describe_cells(const Surveys& surveys, const CellDistribution& what) {
  const int bins = what.logarithmic ? 24 : 96;  // counts of cells leave gaps in narrow logarithmic bins
  Distributions all;
  for (const Survey& one : surveys) all.push_back(one.*what.of);
  Descriptor out{what.name, what.title, what.meaning, {PlotKind::histogram, what.axis, "density"}, {}, {}};
  out.plot.log_x = what.logarithmic;
  out.plot.lines = density_lines(all, bins, what.logarithmic);
  if (!what.logarithmic) {
    out.measures.push_back(measure(surveys, "mean", what.unit, [&](const Survey& s) { return (s.*what.of).mean(); }));
    out.measures.push_back(
        measure(surveys, "deviation", what.unit, [&](const Survey& s) { return (s.*what.of).deviation(); }));
  }
  for (const auto& [name, share] : {std::pair{"p05", 0.05}, {"median", 0.5}, {"p95", 0.95}}) {
    const double part = share;
    out.measures.push_back(measure(surveys, name, what.unit, [&](const Survey& s) {
      const double value = (s.*what.of).quantile(part);
      return what.logarithmic ? std::pow(10.0, value) : value;
    }));
  }
  out.distance = relative_distance(all);
  return out;
}

Descriptor describe_aspect(const Surveys& surveys) {
  Descriptor out{
      "aspect",
      "Aspect",
      "Downhill bearing, clockwise from north. Direction strength is 1 where all slopes face one way and 0 where "
      "they cancel. Distance: circular Wasserstein over a half turn.",
      {PlotKind::histogram, "bearing (deg)", "density"},
      {},
      {}};
  constexpr size_t kMerged = 2;  // bins in one of the plot
  constexpr double kWidth = kMerged * Bearings::kBinDeg;
  for (const Survey& one : surveys) {
    PlotLine line;
    for (size_t i = 0; i < Bearings::kBins && one.aspect.total() > 0; i += kMerged) {
      line.x.push_back((static_cast<double>(i) + 0.5 * kMerged) * Bearings::kBinDeg);
      line.y.push_back(static_cast<double>(one.aspect.counts[i] + one.aspect.counts[i + 1]) /
                       (static_cast<double>(one.aspect.total()) * kWidth));
    }
    out.plot.lines.push_back(std::move(line));
  }
  out.measures.push_back(measure(surveys, "facing_north", "", [](const Survey& s) {
    // Share within 45 degrees of north.
    int64_t north = 0;
    for (size_t i = 0; i < Bearings::kBins / 8; ++i)
      north += s.aspect.counts[i] + s.aspect.counts[Bearings::kBins - 1 - i];
    return s.aspect.total() > 0 ? static_cast<double>(north) / static_cast<double>(s.aspect.total()) : kNaN;
  }));
  out.measures.push_back(
      measure(surveys, "mean_direction", "deg", [](const Survey& s) { return s.aspect.mean_deg(); }));
  out.measures.push_back(
      measure(surveys, "direction_strength", "", [](const Survey& s) { return s.aspect.strength(); }));
  if (surveys.size() == 2) out.distance = defined(circular_wasserstein(surveys[0].aspect, surveys[1].aspect) / 180.0);
  return out;
}

Descriptor describe_hypsometry(const Surveys& surveys) {
  constexpr int kSteps = 101;
  Descriptor out{"hypsometry",
                 "Hypsometric curve",
                 "Share of the land above a height, heights from the lowest (0) to the highest (1). Distance: area "
                 "between the curves.",
                 {PlotKind::curve, "share of land above", "relative height"},
                 {},
                 {}};
  for (const Survey& one : surveys) {
    PlotLine line;
    const double low = one.elevation.low(), relief = one.elevation.high() - low;
    for (int i = 0; i < kSteps && relief > 0.0; ++i) {
      const double above = static_cast<double>(i) / (kSteps - 1);
      line.x.push_back(above);
      line.y.push_back((one.elevation.quantile(1.0 - above) - low) / relief);
    }
    out.plot.lines.push_back(std::move(line));
  }
  out.measures.push_back(measure(surveys, "integral", "", [](const Survey& s) {
    const double relief = s.elevation.high() - s.elevation.low();
    return relief > 0.0 ? (s.elevation.mean() - s.elevation.low()) / relief : kNaN;
  }));
  if (surveys.size() == 2 && !out.plot.lines[0].y.empty() && !out.plot.lines[1].y.empty()) {
    double area = 0.0;
    for (size_t i = 0; i < kSteps; ++i) area += std::abs(out.plot.lines[0].y[i] - out.plot.lines[1].y[i]) / kSteps;
    out.distance = area;
  }
  return out;
}

Descriptor describe_isolation(const Surveys& surveys) {
  constexpr int kBins = 20;
  Descriptor out{
      "isolation",
      "Isolation of peaks",
      "Distance from a peak to the nearest higher ground (for the highest, the terrain's diagonal). Distance: "
      "Wasserstein of log10, over the reference's deviation.",
      {PlotKind::histogram, "isolation (m)", "density", true, false},
      {},
      {}};
  Distributions all;
  for (const Survey& one : surveys) {
    std::vector<double> logarithms;
    for (const Peak& peak : one.peaks) logarithms.push_back(std::log10(peak.isolation_m));
    all.emplace_back(std::move(logarithms));
  }
  out.plot.lines = density_lines(all, kBins, true);
  out.measures.push_back(measure(surveys, "median", "m", [](const Survey& s) {
    std::vector<double> isolation;
    for (const Peak& peak : s.peaks) isolation.push_back(peak.isolation_m);
    std::sort(isolation.begin(), isolation.end());
    return isolation.empty() ? kNaN : isolation[isolation.size() / 2];
  }));
  out.distance = relative_distance(all);
  return out;
}

}  // namespace seamount::hydrology
