#include <cmath>
#include <string>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/geom/current/flow_window.h"
#include "seamount/geom/current/object_flow.h"
#include "seamount/geom/polygon/distance.h"

namespace seamount::geom {
namespace {

void check(const RegionFlow& region, const std::string& name) {
  if (!(region.reach_m > 0.0) || !std::isfinite(region.reach_m))
    throw InvalidArgument(name, "reach " + format_number(region.reach_m) + " is not above 0");
  if (!std::isfinite(region.seaward_m_s) || !std::isfinite(region.shoreward_m_s))
    throw InvalidArgument(name, "has a speed that is no number");
  if (region.outline.outer.size() < 3) throw InvalidArgument(name, "has an outline of fewer than three points");
  const auto check_ring = [&](const Ring& ring) {
    for (const Vec2 p : ring)
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) throw InvalidArgument(name, "has a point that is no number");
  };
  check_ring(region.outline.outer);
  for (const Ring& hole : region.outline.holes) check_ring(hole);
}

/// Metres a second away from the region at a signed distance from its outline.
double speed_at(double distance, const RegionFlow& region) {
  const double t = std::abs(distance) / region.reach_m;
  if (t >= 1.0) return 0.0;
  const double obstacle = region.seaward_m_s * (1.0 - t * t) * (1.0 - t * t);
  return distance > 0.0 ? obstacle - region.shoreward_m_s * 6.75 * t * (1.0 - t) * (1.0 - t) : obstacle;
}

FlowWindow flow_of_region(const RegionFlow& region, const GridFrame& grid, const RunContext& run) {
  FlowWindow window;
  GridFrame frame;
  if (!window_around(region.outline.outer, region.reach_m, 1, grid, window.left, window.top, frame)) return window;
  const ScalarField distance = signed_distance({region.outline}, frame, run);
  window.flow = {ScalarField(frame, 0.0F), ScalarField(frame, 0.0F)};
  for (int y = 1; y + 1 < frame.height; ++y) {
    for (int x = 1; x + 1 < frame.width; ++x) {
      const double speed = speed_at(static_cast<double>(distance(x, y)), region) / (2.0 * frame.cell_m);
      window.flow.x(x, y) = static_cast<float>(speed * static_cast<double>(distance(x + 1, y) - distance(x - 1, y)));
      window.flow.y(x, y) = static_cast<float>(speed * static_cast<double>(distance(x, y - 1) - distance(x, y + 1)));
    }
  }
  return window;
}

}  // namespace

void add_region_flow(std::span<const RegionFlow> regions, VectorField& current, const RunContext& run) {
  for (size_t i = 0; i < regions.size(); ++i) check(regions[i], "regions[" + std::to_string(i) + "]");
  const GridFrame frame = current.frame();
  add_windows(static_cast<int64_t>(regions.size()), current, run, [&](int64_t i, const RunContext& one) {
    return flow_of_region(regions[static_cast<size_t>(i)], frame, one);
  });
}

}  // namespace seamount::geom
