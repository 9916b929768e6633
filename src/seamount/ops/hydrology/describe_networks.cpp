#include "seamount/ops/hydrology/describe_networks.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace seamount::hydrology {
namespace {

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

}  // namespace

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
      measure(surveys, "drainage_density", "km/km2", [](const Survey& s) { return 1e3 * s.river_m / s.land_m2; })};
  size_t orders = 0;
  for (const Survey& one : surveys) orders = std::max(orders, one.streams.size());
  for (size_t i = 0; i < orders; ++i) {
    out.measures.push_back(measure(surveys, "streams_of_order_" + std::to_string(i + 1), "", [&](const Survey& s) {
      return i < s.streams.size() ? static_cast<double>(s.streams[i]) : 0.0;
    }));
  }
  if (comparable(surveys)) {
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
    for (int i = 0; i < kSteps && surveys[s].has_land(); ++i) {
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
  if (comparable(surveys) && !(surveys[0].peaks.empty() && surveys[1].peaks.empty())) {
    double sum = 0.0;
    for (size_t i = 0; i < kSteps; ++i) sum += std::abs(std::log10(rates[0][i] / rates[1][i]));
    out.distance = sum / kSteps;
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
  const auto per_area = [](double length_m, const Survey& s) { return 1e3 * length_m / s.land_m2; };
  for (const Survey& one : surveys) {
    out.plot.lines.push_back({});
    if (one.has_land()) out.plot.lines.back() = {{1.0, 2.0}, {per_area(one.ridge_m, one), per_area(one.river_m, one)}};
  }
  out.measures = {measure(surveys, "ridge_length", "km", [](const Survey& s) { return 1e-3 * s.ridge_m; }),
                  measure(surveys, "ridge_density", "km/km2", [&](const Survey& s) { return per_area(s.ridge_m, s); })};
  if (surveys.size() == 2 && surveys[0].ridge_m > 0.0 && surveys[1].ridge_m > 0.0)
    out.distance =
        std::abs(std::log10(per_area(surveys[0].ridge_m, surveys[0]) / per_area(surveys[1].ridge_m, surveys[1])));
  return out;
}

}  // namespace seamount::hydrology
