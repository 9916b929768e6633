#include "seamount/geom/mesh/mesh_tracer.h"

namespace seamount::geom {
namespace {

using Vector = std::array<float, 3>;

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
float dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

}  // namespace

MeshTracer::MeshTracer(std::span<const float> positions, std::span<const uint32_t> indices) {
  const auto corner = [&](size_t i) -> Vector {
    const size_t at = 3 * size_t{indices[i]};
    return {positions[at], positions[at + 1], positions[at + 2]};
  };
  std::vector<Box3> boxes(indices.size() / 3);
  for (size_t i = 0; i < boxes.size(); ++i)
    for (size_t k = 0; k < 3; ++k) boxes[i].include(corner(3 * i + k));
  bvh_ = Bvh(boxes);
  triangles_.reserve(boxes.size());
  for (const uint32_t i : bvh_.order()) {
    const Vector a = corner(3 * size_t{i});
    triangles_.push_back({a, minus(corner(3 * size_t{i} + 1), a), minus(corner(3 * size_t{i} + 2), a)});
  }
}

bool MeshTracer::meets(const Triangle& triangle, const Ray3& ray, float end, TriangleHit& hit) {
  const Vector p = cross(ray.direction, triangle.edge2);
  const float determinant = dot(triangle.edge1, p);
  if (determinant == 0.0F) return false;
  const float inverse = 1.0F / determinant;
  const Vector s = minus(ray.from, triangle.corner);
  const float u = dot(s, p) * inverse;
  if (!(u >= 0.0F && u <= 1.0F)) return false;
  const Vector q = cross(s, triangle.edge1);
  const float v = dot(ray.direction, q) * inverse;
  if (!(v >= 0.0F && u + v <= 1.0F)) return false;
  const float t = dot(triangle.edge2, q) * inverse;
  if (!(t > ray.begin && t < end)) return false;
  hit.t = t;
  hit.u = u;
  hit.v = v;
  return true;
}

std::optional<TriangleHit> MeshTracer::first(const Ray3& ray, float end) const {
  TriangleHit hit;
  bool found = false;
  bvh_.traverse(ray, end, 0.0F, [&](uint32_t i, float until) {
    if (!meets(triangles_[i], ray, until, hit)) return until;
    hit.triangle = bvh_.order()[i];
    found = true;
    return hit.t;
  });
  return found ? std::optional(hit) : std::nullopt;
}

bool MeshTracer::any(const Ray3& ray, float end) const {
  TriangleHit hit;
  bool found = false;
  bvh_.traverse(ray, end, 0.0F, [&](uint32_t i, float until) {
    found = meets(triangles_[i], ray, until, hit);
    return found ? ray.begin - 1.0F : until;
  });
  return found;
}

}  // namespace seamount::geom
