#include "seamount/ops/hydrology/descriptors.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace seamount::hydrology {
namespace {

using Surveys = std::vector<Survey>;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Measure measure(const Surveys& surveys, const char* name, const char* unit,
                const std::function<double(const Survey&)>& value) {
  Measure out{name, unit, {}};
  for (const Survey& one : surveys) out.values.push_back(value(one));
  return out;
}

/// Density over the value, for a plot.
PlotLine density(const Histogram& fine, int bins) {
  const Histogram histogram = fine.coarser(bins);
  const double all = static_cast<double>(std::max<int64_t>(1, histogram.total())) * histogram.width();
  PlotLine line;
  for (size_t i = 0; i < histogram.counts.size(); ++i) {
    line.x.push_back(histogram.middle(i));
    line.y.push_back(static_cast<double>(histogram.counts[i]) / all);
  }
  return line;
}

/// Cuts off the ends of a histogram's plot where hardly anything lies.
void trim(Plot& plot) {
  constexpr double kHardly = 0.004;  // of the highest density
  double highest = 0.0;
  for (const PlotLine& line : plot.lines)
    for (const double y : line.y) highest = std::max(highest, y);
  size_t first = plot.lines[0].y.size(), last = 0;
  for (const PlotLine& line : plot.lines) {
    for (size_t i = 0; i < line.y.size(); ++i) {
      if (!(line.y[i] > kHardly * highest)) continue;
      first = std::min(first, i);
      last = std::max(last, i);
    }
  }
  if (first > last) return;
  const auto begin = static_cast<std::ptrdiff_t>(first > 0 ? first - 1 : 0);
  const auto end = static_cast<std::ptrdiff_t>(std::min(last + 2, plot.lines[0].y.size()));
  for (PlotLine& line : plot.lines) {
    line.x = {line.x.begin() + begin, line.x.begin() + end};
    line.y = {line.y.begin() + begin, line.y.begin() + end};
  }
}

/// A descriptor that is a distribution of cells.
struct Distribution {
  const char *name, *title, *unit, *meaning, *axis;
  Histogram Survey::*of;
  bool logarithmic = false;  ///< the histogram holds log10 of the values
};

Descriptor describe_distribution(const Surveys& surveys, const Distribution& what) {
  const int bins = what.logarithmic ? 24 : 96;  // counts of cells leave gaps in narrow logarithmic bins
  Descriptor out{what.name, what.title, what.meaning, {PlotKind::histogram, what.axis, "density"}, {}, {}};
  const auto plain = [&](double value) { return what.logarithmic ? std::pow(10.0, value) : value; };
  for (const Survey& one : surveys) out.plot.lines.push_back(density(one.*what.of, bins));
  trim(out.plot);
  if (what.logarithmic) {
    out.plot.log_x = true;
    for (PlotLine& line : out.plot.lines)
      for (double& x : line.x) x = std::pow(10.0, x);
  }
  if (!what.logarithmic) {
    out.measures.push_back(measure(surveys, "mean", what.unit, [&](const Survey& s) { return (s.*what.of).mean(); }));
    out.measures.push_back(
        measure(surveys, "deviation", what.unit, [&](const Survey& s) { return (s.*what.of).deviation(); }));
  }
  for (const auto& [name, share] : {std::pair{"p05", 0.05}, {"median", 0.5}, {"p95", 0.95}}) {
    const double part = share;
    out.measures.push_back(measure(surveys, name, what.unit, [&](const Survey& s) {
      return (s.*what.of).total() > 0 ? plain((s.*what.of).quantile(part)) : kNaN;
    }));
  }
  if (surveys.size() == 2) {
    const Histogram &a = surveys[0].*what.of, &b = surveys[1].*what.of;
    const double scale = b.deviation();
    if (a.total() > 0 && b.total() > 0) out.distance = wasserstein(a, b) / (scale > 0.0 ? scale : b.width());
  }
  return out;
}

Descriptor describe_aspect(const Surveys& surveys) {
  Descriptor out{"aspect",
                 "Aspect",
                 "Downhill bearing, clockwise from north. Distance: circular Wasserstein over a half turn.",
                 {PlotKind::histogram, "bearing (deg)", "density"},
                 {},
                 {}};
  for (const Survey& one : surveys) out.plot.lines.push_back(density(one.aspect, 36));
  out.measures.push_back(measure(surveys, "facing_north", "", [](const Survey& s) {
    // Share within 45 degrees of north.
    int64_t north = 0;
    for (size_t i = 0; i < s.aspect.counts.size(); ++i)
      if (s.aspect.middle(i) < 45.0 || s.aspect.middle(i) > 315.0) north += s.aspect.counts[i];
    return static_cast<double>(north) / static_cast<double>(std::max<int64_t>(1, s.aspect.total()));
  }));
  if (surveys.size() == 2) out.distance = circular_wasserstein(surveys[0].aspect, surveys[1].aspect) / 180.0;
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
    const double relief = std::max(1e-9, one.high_m - one.low_m);
    for (int i = 0; i < kSteps; ++i) {
      const double above = static_cast<double>(i) / (kSteps - 1);
      line.x.push_back(above);
      line.y.push_back(std::clamp((one.elevation.quantile(1.0 - above) - one.low_m) / relief, 0.0, 1.0));
    }
    out.plot.lines.push_back(std::move(line));
  }
  out.measures.push_back(measure(surveys, "integral", "", [](const Survey& s) {
    return s.high_m > s.low_m ? (s.elevation.mean() - s.low_m) / (s.high_m - s.low_m) : kNaN;
  }));
  if (surveys.size() == 2) {
    double area = 0.0;
    for (size_t i = 0; i < kSteps; ++i) area += std::abs(out.plot.lines[0].y[i] - out.plot.lines[1].y[i]) / kSteps;
    out.distance = area;
  }
  return out;
}

/// y at x on a curve of ascending x, linear between the logarithms; nothing beyond its ends.
std::optional<double> log_at(const PlotLine& line, double x) {
  for (size_t i = 0; i + 1 < line.x.size(); ++i) {
    if (x < line.x[i] || x > line.x[i + 1]) continue;
    const double t = (std::log10(x) - std::log10(line.x[i])) / (std::log10(line.x[i + 1]) - std::log10(line.x[i]));
    return (1.0 - t) * std::log10(line.y[i]) + t * std::log10(line.y[i + 1]);
  }
  return std::nullopt;
}

/// Mean |log10 of the ratio| of two curves over the points of the second where both are defined.
std::optional<double> log_gap(const PlotLine& a, const PlotLine& b) {
  double sum = 0.0;
  int count = 0;
  for (size_t i = 0; i < b.x.size(); ++i) {
    const std::optional<double> there = log_at(a, b.x[i]);
    if (!there) continue;
    sum += std::abs(*there - std::log10(b.y[i]));
    ++count;
  }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

/// Least-squares slope of log y over log x for x in [low, high].
double log_slope(const PlotLine& line, double low, double high) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (size_t i = 0; i < line.x.size(); ++i) {
    if (line.x[i] < low || line.x[i] > high) continue;
    const double x = std::log10(line.x[i]), y = std::log10(line.y[i]);
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  const double spread = n * sxx - sx * sx;
  return n >= 2 && spread > 0.0 ? (n * sxy - sx * sy) / spread : kNaN;
}

Descriptor describe_slope_area(const Surveys& surveys, const SurveyPlan& plan) {
  Descriptor out{
      "slope_area",
      "Slope and drainage area",
      "Mean slope of the cells with a drainage area. Rivers that carve obey slope ~ area^-concavity. Distance: "
      "mean |log10 of the ratio|.",
      {PlotKind::curve, "drainage area (m2)", "slope", true, true},
      {},
      {}};
  Measure concavity{"concavity", "", {}};
  for (const Survey& one : surveys) {
    PlotLine line;
    for (const SlopeOfArea& point : one.slope_of_area) {
      line.x.push_back(point.area_m2);
      line.y.push_back(point.slope);
    }
    concavity.values.push_back(-log_slope(line, plan.channel_m2, std::numeric_limits<double>::infinity()));
    out.plot.lines.push_back(std::move(line));
  }
  out.measures.push_back(std::move(concavity));
  if (surveys.size() == 2) out.distance = log_gap(out.plot.lines[0], out.plot.lines[1]);
  return out;
}

Descriptor describe_roughness(const Surveys& surveys) {
  Descriptor out{
      "roughness",
      "Roughness",
      "Height difference (root mean square) over a distance; the slope of the curve at short distances is the "
      "Hurst exponent. Distance: mean |log10 of the ratio|.",
      {PlotKind::curve, "distance (m)", "height difference (m)", true, true},
      {},
      {}};
  Measure hurst{"hurst_exponent", "", {}}, shortest{"at_one_cell", "m", {}};
  for (const Survey& one : surveys) {
    PlotLine line;
    for (const Unevenness& point : one.unevenness) {
      line.x.push_back(point.lag_m);
      line.y.push_back(point.rms_m);
    }
    constexpr double kShort = 16.5;  // cells
    hurst.values.push_back(line.x.empty() ? kNaN : log_slope(line, 0.0, kShort * line.x.front()));
    shortest.values.push_back(line.y.empty() ? kNaN : line.y.front());
    out.plot.lines.push_back(std::move(line));
  }
  out.measures = {std::move(hurst), std::move(shortest)};
  if (surveys.size() == 2) out.distance = log_gap(out.plot.lines[0], out.plot.lines[1]);
  return out;
}

/// Mean ratio of streams of an order to those of the next: exp of the slope of log count over order (Horton 1945).
double bifurcation_ratio(const std::vector<int>& streams) {
  PlotLine line;
  for (size_t i = 0; i < streams.size(); ++i) {
    if (streams[i] == 0) continue;
    line.x.push_back(std::pow(10.0, static_cast<double>(i)));
    line.y.push_back(streams[i]);
  }
  return std::pow(10.0, -log_slope(line, 0.0, std::numeric_limits<double>::infinity()));
}

double per_100_km2(double count, const Survey& survey) { return count / std::max(1.0, survey.land_m2) * 1e8; }

Descriptor describe_strahler(const Surveys& surveys) {
  Descriptor out{"strahler",
                 "Stream orders",
                 "Streams per 100 km2 by Strahler order. Distance: mean over orders of |log10 of the ratio|; an "
                 "order that one lacks counts as half a stream.",
                 {PlotKind::bars, "order", "streams per 100 km2", false, true},
                 {},
                 {}};
  for (const Survey& one : surveys) {
    PlotLine line;
    for (size_t i = 0; i < one.streams.size(); ++i) {
      if (one.streams[i] == 0) continue;
      line.x.push_back(static_cast<double>(i + 1));
      line.y.push_back(per_100_km2(one.streams[i], one));
    }
    out.plot.lines.push_back(std::move(line));
  }
  out.measures = {
      measure(surveys, "highest_order", "", [](const Survey& s) { return static_cast<double>(s.streams.size()); }),
      measure(surveys, "bifurcation_ratio", "", [](const Survey& s) { return bifurcation_ratio(s.streams); }),
      measure(surveys, "drainage_density", "km/km2",
              [](const Survey& s) { return 1e3 * s.river_m / std::max(1.0, s.land_m2); })};
  if (surveys.size() == 2) {
    const size_t orders = std::max(surveys[0].streams.size(), surveys[1].streams.size());
    double sum = 0.0;
    for (size_t i = 0; i < orders; ++i) {
      const auto rate = [&](const Survey& s) {
        return per_100_km2(i < s.streams.size() ? std::max(0.5, static_cast<double>(s.streams[i])) : 0.5, s);
      };
      sum += std::abs(std::log10(rate(surveys[0]) / rate(surveys[1])));
    }
    if (orders > 0) out.distance = sum / static_cast<double>(orders);
  }
  return out;
}

Descriptor describe_prominence(const Surveys& surveys, const SurveyPlan& plan) {
  constexpr int kSteps = 24;
  Descriptor out{"prominence",
                 "Prominence of peaks",
                 "Peaks per 100 km2 that are at least so prominent. Distance: mean over prominences of |log10 of the "
                 "ratio|; half a peak where there is none.",
                 {PlotKind::curve, "prominence (m)", "peaks per 100 km2", true, true},
                 {},
                 {}};
  double highest = 2.0 * plan.min_prominence_m;
  for (const Survey& one : surveys)
    if (!one.peaks.empty()) highest = std::max(highest, one.peaks.front().prominence_m);
  std::vector<std::vector<double>> rates(surveys.size());
  for (size_t s = 0; s < surveys.size(); ++s) {
    PlotLine line;
    for (int i = 0; i < kSteps; ++i) {
      const double least = plan.min_prominence_m * std::pow(highest / plan.min_prominence_m, i / (kSteps - 1.0));
      const auto count = std::count_if(surveys[s].peaks.begin(), surveys[s].peaks.end(),
                                       [&](const Peak& peak) { return peak.prominence_m >= least * (1.0 - 1e-12); });
      rates[s].push_back(per_100_km2(std::max(0.5, static_cast<double>(count)), surveys[s]));
      if (count == 0) continue;
      line.x.push_back(least);
      line.y.push_back(per_100_km2(static_cast<double>(count), surveys[s]));
    }
    out.plot.lines.push_back(std::move(line));
  }
  out.measures = {measure(surveys, "peaks", "", [](const Survey& s) { return static_cast<double>(s.peaks.size()); }),
                  measure(surveys, "peaks_per_100_km2", "",
                          [](const Survey& s) { return per_100_km2(static_cast<double>(s.peaks.size()), s); }),
                  measure(surveys, "median", "m", [](const Survey& s) {
                    return s.peaks.empty() ? kNaN : s.peaks[s.peaks.size() / 2].prominence_m;
                  })};
  if (surveys.size() == 2) {
    double sum = 0.0;
    for (size_t i = 0; i < kSteps; ++i) sum += std::abs(std::log10(rates[0][i] / rates[1][i]));
    out.distance = sum / kSteps;
  }
  return out;
}

Descriptor describe_isolation(const Surveys& surveys) {
  Descriptor out{
      "isolation",
      "Isolation of peaks",
      "Distance from a peak to the nearest higher ground (for the highest, the terrain's diagonal). Distance: "
      "Wasserstein of log10, over the reference's deviation.",
      {PlotKind::histogram, "isolation (m)", "density", true, false},
      {},
      {}};
  double low = std::numeric_limits<double>::infinity(), high = 0.0;
  for (const Survey& one : surveys) {
    for (const Peak& peak : one.peaks) {
      low = std::min(low, peak.isolation_m);
      high = std::max(high, peak.isolation_m);
    }
  }
  if (!(low < high)) low = 1.0, high = 10.0;
  constexpr int kFine = 480, kPlotBins = 20;
  std::vector<Histogram> histograms;
  for (const Survey& one : surveys) {
    Histogram histogram(std::log10(low), std::log10(high) + 1e-9, kFine);
    for (const Peak& peak : one.peaks) histogram.add(std::log10(peak.isolation_m));
    PlotLine line = density(histogram, kPlotBins);
    for (double& x : line.x) x = std::pow(10.0, x);
    out.plot.lines.push_back(std::move(line));
    histograms.push_back(std::move(histogram));
  }
  out.measures.push_back(measure(surveys, "median", "m", [](const Survey& s) {
    std::vector<double> all;
    for (const Peak& peak : s.peaks) all.push_back(peak.isolation_m);
    std::sort(all.begin(), all.end());
    return all.empty() ? kNaN : all[all.size() / 2];
  }));
  if (surveys.size() == 2 && histograms[0].total() > 0 && histograms[1].total() > 0) {
    const double scale = histograms[1].deviation();
    out.distance = wasserstein(histograms[0], histograms[1]) / (scale > 0.0 ? scale : 1.0);
  }
  return out;
}

Descriptor describe_ridges(const Surveys& surveys) {
  Descriptor out{"ridges",
                 "Ridges and rivers",
                 "Length of ridges (1) and rivers (2) per area. Distance: |log10 of the ratio| of the ridges'.",
                 {PlotKind::bars, "1 ridges, 2 rivers", "km per km2"},
                 {},
                 {}};
  const auto per_area = [](double length_m, const Survey& s) { return 1e3 * length_m / std::max(1.0, s.land_m2); };
  for (const Survey& one : surveys)
    out.plot.lines.push_back({{1.0, 2.0}, {per_area(one.ridge_m, one), per_area(one.river_m, one)}});
  out.measures = {measure(surveys, "ridge_length", "km", [](const Survey& s) { return 1e-3 * s.ridge_m; }),
                  measure(surveys, "ridge_density", "km/km2", [&](const Survey& s) { return per_area(s.ridge_m, s); })};
  if (surveys.size() == 2 && surveys[0].ridge_m > 0.0 && surveys[1].ridge_m > 0.0)
    out.distance =
        std::abs(std::log10(per_area(surveys[0].ridge_m, surveys[0]) / per_area(surveys[1].ridge_m, surveys[1])));
  return out;
}

}  // namespace

std::vector<Descriptor> make_descriptors(const std::vector<Survey>& surveys, const SurveyPlan& plan) {
  constexpr const char* kOverDeviation = " Distance: Wasserstein of the histograms, over the reference's deviation.";
  const auto distribution = [&](const char* name, const char* title, const char* unit, const std::string& meaning,
                                const char* axis, Histogram Survey::*of, bool logarithmic = false) {
    const std::string full = meaning + kOverDeviation;
    return describe_distribution(surveys, {name, title, unit, full.c_str(), axis, of, logarithmic});
  };
  return {distribution("elevation", "Elevation", "m", "Height above sea level.", "elevation (m)", &Survey::elevation),
          describe_hypsometry(surveys),
          distribution("slope", "Slope", "deg", "Steepness.", "slope (deg)", &Survey::slope),
          describe_aspect(surveys),
          distribution("curvature", "Curvature", "1/m", "Mean curvature, positive on crests, negative in hollows.",
                       "curvature (1/m)", &Survey::curvature),
          distribution("local_relief", "Local relief", "m", "Highest less lowest height in a square around each cell.",
                       "relief (m)", &Survey::relief),
          distribution("drainage_area", "Drainage area", "m2", "Ground whose water passes through a cell, as log10.",
                       "drainage area (m2)", &Survey::area, true),
          describe_slope_area(surveys, plan),
          describe_strahler(surveys),
          describe_ridges(surveys),
          describe_prominence(surveys, plan),
          describe_isolation(surveys),
          describe_roughness(surveys)};
}

}  // namespace seamount::hydrology
