#include "seamount/ops/island/craters.h"

#include <algorithm>
#include <cmath>

namespace seamount::island {

Grid<uint8_t> craters(const std::vector<Peak>& peaks, const geom::CurveFunction& profile, const GridFrame& frame) {
  constexpr double kWithin = 0.85;  // of the rim: the rest drains inwards
  Grid<uint8_t> out;
  for (const Peak& peak : peaks) {
    const double rim = highest_at(peak.profile.knots.empty() ? profile : geom::CurveFunction(peak.profile));
    const double reach = kWithin * rim * peak.radius_m;
    if (reach <= 0.0) continue;
    if (out.empty()) out = Grid<uint8_t>(frame, 0);
    const int x0 = std::max(0, static_cast<int>(std::floor(frame.column(peak.place.x - reach))));
    const int x1 = std::min(frame.width - 1, static_cast<int>(std::ceil(frame.column(peak.place.x + reach))));
    const int y0 = std::max(0, static_cast<int>(std::floor(frame.row(peak.place.y + reach))));
    const int y1 = std::min(frame.height - 1, static_cast<int>(std::ceil(frame.row(peak.place.y - reach))));
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        if (std::hypot(frame.x(x) - peak.place.x, frame.y(y) - peak.place.y) <= reach) out(x, y) = 1;
      }
    }
  }
  return out;
}

}  // namespace seamount::island
