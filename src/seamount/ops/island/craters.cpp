#include "seamount/ops/island/craters.h"

#include <algorithm>
#include <cmath>

namespace seamount::island {
namespace {

/// Where on [0, 1] a profile is highest.
double highest_at(const geom::CurveFunction& profile) {
  constexpr int kSamples = 200;
  double best = 0.0;
  for (int i = 1; i <= kSamples; ++i) {
    const double x = static_cast<double>(i) / kSamples;
    if (profile(x) > profile(best)) best = x;
  }
  return best;
}

}  // namespace

Craters::Craters(const std::vector<Peak>& peaks, const geom::CurveFunction& profile) {
  constexpr double kWithin = 0.85;  // of the rim: the rest drains inwards
  for (const Peak& peak : peaks) {
    const double rim = highest_at(peak.profile.knots.empty() ? profile : geom::CurveFunction(peak.profile));
    if (rim > 0.0) craters_.push_back({peak.place, kWithin * rim * peak.radius_m});
  }
}

Craters::Hold::Hold(const Craters& craters, HeightField& terrain) : terrain_(terrain) {
  const GridFrame& frame = terrain.frame();
  for (const Crater& crater : craters.craters_) {
    const double reach = crater.radius_m;
    const int x0 = std::max(0, static_cast<int>(std::floor(frame.column(crater.centre.x - reach))));
    const int x1 = std::min(frame.width - 1, static_cast<int>(std::ceil(frame.column(crater.centre.x + reach))));
    const int y0 = std::max(0, static_cast<int>(std::floor(frame.row(crater.centre.y + reach))));
    const int y1 = std::min(frame.height - 1, static_cast<int>(std::ceil(frame.row(crater.centre.y - reach))));
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        const double away = std::hypot(frame.x(x) - crater.centre.x, frame.y(y) - crater.centre.y);
        if (away > reach || terrain(x, y) <= 0.0F) continue;
        kept_.emplace_back(static_cast<int64_t>(y) * frame.width + x, terrain(x, y));
        terrain(x, y) = 0.0F;
      }
    }
  }
}

Craters::Hold::~Hold() {
  for (const auto& [cell, height] : kept_) terrain_.cells()[static_cast<size_t>(cell)] = height;
}

}  // namespace seamount::island
