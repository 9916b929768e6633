#include "seamount/io/thing_parts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "seamount/base/error.h"

namespace seamount::io {
namespace {

using Vector = std::array<float, 3>;

Vector z_up(const Vector& y_up) { return {y_up[0], 0.0F - y_up[2], y_up[1]}; }

std::array<double, 3> area_vector(const Vector& a, const Vector& b, const Vector& c) {
  std::array<double, 3> u{}, v{};
  for (size_t k = 0; k < 3; ++k) {
    u[k] = static_cast<double>(b[k]) - a[k];
    v[k] = static_cast<double>(c[k]) - a[k];
  }
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

double length(const std::array<double, 3>& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

unsigned char encoded(float linear) {
  const double l = std::clamp(static_cast<double>(linear), 0.0, 1.0);
  return static_cast<unsigned char>(
      std::lround(255.0 * (l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1.0 / 2.4) - 0.055)));
}

}  // namespace

void ThingParts::triangle(const std::array<ThingCorner, 3>& corners, bool two_sided) {
  constexpr float kFar = 1e6F;  // metres: a thing, no landscape
  for (const ThingCorner& corner : corners) {
    for (const float v : corner.place)
      if (!(std::abs(v) <= kFar)) throw IoError(name_, "has a vertex that is no number, or is beyond 1000 km");
    for (const float v : corner.colour)
      if (!std::isfinite(v)) throw IoError(name_, "has a colour that is no number");
  }
  const double area = length(area_vector(corners[0].place, corners[1].place, corners[2].place));
  if (!(area > 1e-14)) return;
  if (triangles_.size() >= kMostThingTriangles)
    throw IoError(name_, "has more than " + std::to_string(kMostThingTriangles) + " triangles");
  triangles_.push_back({corners, two_sided});
}

ThingMesh ThingParts::mesh() const {
  if (triangles_.empty()) throw IoError(name_, "has no triangles");
  // Corners without a normal get that of all triangles at their place.
  std::map<Vector, std::array<double, 3>> smooth;
  for (const Triangle& t : triangles_) {
    const auto n = area_vector(t.corners[0].place, t.corners[1].place, t.corners[2].place);
    for (const ThingCorner& corner : t.corners)
      for (size_t k = 0; k < 3; ++k) smooth[corner.place][k] += n[k];
  }
  ThingMesh mesh;
  using Key = std::tuple<Vector, Vector, Vector>;
  std::map<Key, uint32_t> known;
  const auto vertex = [&](ThingCorner corner) {
    std::array<double, 3> n = {corner.normal[0], corner.normal[1], corner.normal[2]};
    if (!(length(n) > 1e-6) || !std::isfinite(length(n))) n = smooth[corner.place];
    double l = length(n);
    if (!(l > 0.0)) n = {0.0, l = 1.0, 0.0};
    for (size_t k = 0; k < 3; ++k) corner.normal[k] = static_cast<float>(n[k] / l);
    const auto [found, is_new] =
        known.try_emplace({corner.place, corner.normal, corner.colour}, static_cast<uint32_t>(known.size()));
    if (is_new) {
      const Vector p = z_up(corner.place), up = z_up(corner.normal);
      mesh.positions.insert(mesh.positions.end(), p.begin(), p.end());
      mesh.normals.insert(mesh.normals.end(), up.begin(), up.end());
      mesh.colours.push_back({encoded(corner.colour[0]), encoded(corner.colour[1]), encoded(corner.colour[2])});
    }
    return found->second;
  };
  for (const bool two_sided : {false, true}) {
    for (const Triangle& t : triangles_) {
      if (t.two_sided != two_sided) continue;
      for (const ThingCorner& corner : t.corners) mesh.indices.push_back(vertex(corner));
    }
    if (!two_sided) mesh.solid = mesh.indices.size();
  }
  return mesh;
}

}  // namespace seamount::io
