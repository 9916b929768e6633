#include "seamount/ops/hydrology/describe_curves.h"

#include <cmath>

namespace seamount::hydrology {
namespace {

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

}  // namespace

Descriptor describe_slope_area(const Surveys& surveys) {
  Descriptor out{
      "slope_area",
      "Slope and drainage area",
      "Fall along the flow over its way, where so much ground drains. Rivers that carve obey slope ~ area^-concavity, "
      "fitted from 1 km2 on, or from a tenth of the largest catchment's area where that is less. Distance: mean |log10 "
      "of the ratio|.",
      {PlotKind::curve, "drainage area (m2)", "slope", true, true},
      {},
      {}};
  Measure concavity{"concavity", "", {}}, from{"concavity_from", "m2", {}};
  for (const Survey& one : surveys) {
    PlotLine line;
    for (const SlopeOfArea& point : one.channels.curve) {
      line.x.push_back(point.area_m2);
      line.y.push_back(point.slope);
    }
    concavity.values.push_back(one.has_land() ? one.channels.concavity : kNaN);
    from.values.push_back(one.has_land() ? one.channels.from_m2 : kNaN);
    out.plot.lines.push_back(std::move(line));
  }
  out.measures = {std::move(concavity), std::move(from)};
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

}  // namespace seamount::hydrology
