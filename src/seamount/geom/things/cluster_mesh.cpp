#include "seamount/geom/things/cluster_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "seamount/geom/things/point3.h"

namespace seamount::geom {
namespace {

Point3 point(const std::vector<float>& values, size_t i) {
  return {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
}

ThingMesh clustered(const ThingMesh& mesh, Point3 low, double cell) {
  std::map<std::array<int64_t, 3>, uint32_t> cells;
  std::vector<uint32_t> joined(mesh.vertex_count());
  std::vector<Point3> sums, normals;
  std::vector<double> counts;
  ThingMesh coarse;
  for (size_t i = 0; i < mesh.vertex_count(); ++i) {
    const Point3 p = (1.0 / cell) * (point(mesh.positions, i) - low);
    const std::array<int64_t, 3> key = {static_cast<int64_t>(p.x), static_cast<int64_t>(p.y),
                                        static_cast<int64_t>(p.z)};
    const auto [found, is_new] = cells.try_emplace(key, static_cast<uint32_t>(sums.size()));
    if (is_new) {
      sums.emplace_back();
      normals.emplace_back();
      counts.push_back(0.0);
      coarse.colours.push_back(mesh.colours[i]);
    }
    joined[i] = found->second;
    sums[joined[i]] = sums[joined[i]] + point(mesh.positions, i);
    normals[joined[i]] = normals[joined[i]] + point(mesh.normals, i);
    counts[joined[i]] += 1.0;
  }
  for (size_t i = 0; i < sums.size(); ++i) {
    const Point3 p = (1.0 / counts[i]) * sums[i], n = unit(normals[i]);
    for (const double v : {p.x, p.y, p.z}) coarse.positions.push_back(static_cast<float>(v));
    for (const double v : {n.x, n.y, n.z}) coarse.normals.push_back(static_cast<float>(v));
  }
  std::set<std::array<uint32_t, 3>> seen;
  for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const uint32_t a = joined[mesh.indices[i]], b = joined[mesh.indices[i + 1]], c = joined[mesh.indices[i + 2]];
    std::array<uint32_t, 3> corners = {a, b, c};
    std::sort(corners.begin(), corners.end());
    const double area = length(cross(point(coarse.positions, b) - point(coarse.positions, a),
                                     point(coarse.positions, c) - point(coarse.positions, a)));
    if (a == b || b == c || c == a || area < 1e-9 * cell * cell || !seen.insert(corners).second) continue;
    coarse.indices.insert(coarse.indices.end(), {a, b, c});
  }
  return coarse;
}

}  // namespace

ThingMesh cluster_mesh(const ThingMesh& mesh, size_t most) {
  Point3 low{1e30, 1e30, 1e30}, high{-1e30, -1e30, -1e30};
  for (size_t i = 0; i < mesh.vertex_count(); ++i) {
    const Point3 p = point(mesh.positions, i);
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double size = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  ThingMesh best;
  for (double cells = 2.0; cells < 512.0; cells *= 1.3) {
    ThingMesh coarse = clustered(mesh, low - Point3{1e-6, 1e-6, 1e-6}, size / cells);
    if (coarse.triangle_count() > most) break;
    if (coarse.triangle_count() >= best.triangle_count()) best = std::move(coarse);
  }
  return best;
}

}  // namespace seamount::geom
