#include "seamount/ops/hydrology/descriptor_parts.h"

#include <cmath>

namespace seamount::hydrology {

Measure measure(const Surveys& surveys, const std::string& name, const char* unit,
                const std::function<double(const Survey&)>& value) {
  Measure out{name, unit, {}};
  for (const Survey& one : surveys) out.values.push_back(one.has_land() ? value(one) : kNaN);
  return out;
}

bool comparable(const Surveys& surveys) {
  return surveys.size() == 2 && surveys[0].has_land() && surveys[1].has_land();
}

std::optional<double> defined(double distance) {
  return std::isfinite(distance) ? std::optional(distance) : std::nullopt;
}

double per_100_km2(double count, const Survey& survey) { return count / survey.land_m2 * 1e8; }

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

}  // namespace seamount::hydrology
