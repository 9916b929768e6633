// No ground so steep that it stands out as a spike or a wall (node_heights.h). Places that growth leaves to the very
// end have the highest ranks, and with them the summits' heights, however narrow they are: alone by a coast they would
// be towers. Such ground is cut back to a slope that rises from the lower ground around it.
#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>

#include "seamount/geom/scalar/bucket_sort.h"
#include "seamount/ops/contour/heights/node_heights.h"

namespace seamount::contour {
namespace {

constexpr double kSteepest = 2.0;  ///< of the root of the mean square slope of the ground

size_t at(int32_t i) { return static_cast<size_t>(i); }

/// Root of the mean square of the slopes (m/m) of the triangles whose nodes all lie in regions, by area.
double usual_slope(const Tin& tin, const std::vector<double>& height) {
  double sum = 0.0;
  double area = 0.0;
  for (const auto& [a, b, c] : tin.triangles) {
    if (tin.region[at(a)] < 0 || tin.region[at(b)] < 0 || tin.region[at(c)] < 0) continue;
    const Vec2 u = tin.nodes[at(b)] - tin.nodes[at(a)];
    const Vec2 v = tin.nodes[at(c)] - tin.nodes[at(a)];
    const double twice = cross(u, v);
    if (!(twice > 0.0)) continue;
    const double du = height[at(b)] - height[at(a)];
    const double dv = height[at(c)] - height[at(a)];
    const Vec2 rise = du * v - dv * u;  // the gradient, turned by a right angle, times twice the area
    sum += dot(rise, rise) / twice;
    area += twice;
  }
  return area > 0.0 ? std::sqrt(sum / area) : 0.0;
}

}  // namespace

void cut_spikes(const Tin& tin, const geom::NodeGraph& graph, const Limits& limits, std::vector<double>& height,
                const RunContext& run) {
  const double steepest = kSteepest * usual_slope(tin, height);
  if (!(steepest > 0.0)) return;
  run.check_cancelled();
  using Open = std::pair<double, int32_t>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  const auto lower_around = [&](size_t node) {
    for (const int32_t neighbour : graph.around(node)) {
      const size_t n = at(neighbour);
      if (tin.region[n] < 0 || tin.regions[at(tin.region[n])].peak_m) continue;
      const Vec2 d = tin.nodes[n] - tin.nodes[node];
      const double most = std::max(height[node] + steepest * std::sqrt(dot(d, d)), limits.floor[n]);
      if (height[n] <= most) continue;
      height[n] = most;
      open.emplace(most, neighbour);
    }
  };
  std::vector<Open> order;
  order.reserve(height.size());
  for (size_t node = 0; node < height.size(); ++node) {
    if (tin.region[node] >= 0) order.emplace_back(height[node], static_cast<int32_t>(node));
  }
  if (order.empty()) return;
  const auto [low, high] = std::minmax_element(order.begin(), order.end());
  const double from = low->first, range = std::max(high->first - from, 1e-9);
  run.check_cancelled();
  geom::bucket_sort(
      order, [&](const Open& o) { return (o.first - from) / range; }, std::less<>());
  for (const auto& [z, node] : order) {  // merged with what was lowered on the way: always the lowest next
    run.check_cancelled();
    while (!open.empty() && open.top().first < z) {
      const auto [lowered, other] = open.top();
      open.pop();
      if (lowered == height[at(other)]) lower_around(at(other));
    }
    if (z == height[at(node)]) lower_around(at(node));
  }
  while (!open.empty()) {
    run.check_cancelled();
    const auto [lowered, other] = open.top();
    open.pop();
    if (lowered == height[at(other)]) lower_around(at(other));
  }
}

}  // namespace seamount::contour
