// Rays against a mesh of triangles, seen from both sides (Moeller and Trumbore, "Fast, minimum storage ray/triangle
// intersection", 1997).
#pragma once

#include <optional>

#include "seamount/geom/mesh/bvh.h"

namespace seamount::geom {

struct TriangleHit {
  float t = 0.0F;            ///< along the ray's direction
  uint32_t triangle = 0;     ///< number of the triangle
  float u = 0.0F, v = 0.0F;  ///< weights of its second and third corner
};

class MeshTracer {
 public:
  MeshTracer() = default;
  /// Copies what it needs: 36 bytes a triangle and the tree. REQUIRES: 3 positions a vertex, 3 indices a triangle.
  MeshTracer(std::span<const float> positions, std::span<const uint32_t> indices);

  const Box3& bounds() const { return bvh_.bounds(); }
  bool empty() const { return bvh_.empty(); }

  /// The first triangle in (ray.begin, end).
  std::optional<TriangleHit> first(const Ray3& ray, float end) const;
  /// Whether there is any.
  bool any(const Ray3& ray, float end) const;

 private:
  struct Triangle {
    std::array<float, 3> corner, edge1, edge2;
  };
  static bool meets(const Triangle& triangle, const Ray3& ray, float end, TriangleHit& hit);

  Bvh bvh_;
  std::vector<Triangle> triangles_;  ///< in the order of the tree
};

}  // namespace seamount::geom
