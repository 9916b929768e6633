#include "seamount/geom/mesh/mesh_tracer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "seamount/base/rng.h"

namespace seamount::geom {
namespace {

struct Soup {
  std::vector<float> positions;
  std::vector<uint32_t> indices;
};

/// Triangles of many sizes; some are flat boxes, some lie in one another's planes.
Soup soup(int count, uint64_t seed) {
  Rng rng(Seed{seed});
  Soup made;
  for (int i = 0; i < count; ++i) {
    const double size = std::pow(10.0, rng.uniform(-1.5, 0.5));
    const double x = rng.uniform(-3.0, 3.0), y = rng.uniform(-3.0, 3.0), z = rng.uniform(-1.0, 1.0);
    for (int k = 0; k < 3; ++k) {
      made.indices.push_back(static_cast<uint32_t>(made.positions.size() / 3));
      made.positions.push_back(static_cast<float>(x + size * rng.uniform(-1.0, 1.0)));
      made.positions.push_back(static_cast<float>(y + size * rng.uniform(-1.0, 1.0)));
      made.positions.push_back(i % 5 == 0 ? 0.25F : static_cast<float>(z + size * rng.uniform(-1.0, 1.0)));
    }
  }
  return made;
}

Ray3 ray(Rng& rng) {
  Ray3 made;
  for (size_t k = 0; k < 3; ++k) {
    made.from[k] = static_cast<float>(rng.uniform(-3.0, 3.0));
    made.direction[k] = static_cast<float>(rng.normal());
  }
  if (rng.chance(0.1)) made.direction[static_cast<size_t>(rng.integer(0, 2))] = 0.0F;
  const auto [x, y, z] = made.direction;
  const float length = std::sqrt(x * x + y * y + z * z);
  for (float& d : made.direction) d = length > 0.0F ? d / length : 1.0F;
  return made;
}

TEST(MeshTracer, FindsWhatTestingAllTrianglesFinds) {
  for (const int count : {1, 2, 5, 64, 300}) {
    const Soup all = soup(count, static_cast<uint64_t>(count));
    const MeshTracer tracer(all.positions, all.indices);
    std::vector<MeshTracer> single;
    for (size_t i = 0; i < all.indices.size(); i += 3)
      single.emplace_back(all.positions, std::span(all.indices).subspan(i, 3));
    Rng rng(Seed{99});
    int hits = 0;
    for (int k = 0; k < 100000 / 5; ++k) {
      const Ray3 r = ray(rng);
      const float end = k % 3 == 0 ? 4.0F : 1e9F;
      std::optional<TriangleHit> nearest;
      for (size_t i = 0; i < single.size(); ++i) {
        const auto hit = single[i].first(r, nearest ? nearest->t : end);
        if (hit) nearest = TriangleHit{hit->t, static_cast<uint32_t>(i), hit->u, hit->v};
      }
      const auto found = tracer.first(r, end);
      ASSERT_EQ(found.has_value(), nearest.has_value()) << count << " ray " << k;
      EXPECT_EQ(tracer.any(r, end), nearest.has_value());
      if (!found) continue;
      ++hits;
      EXPECT_NEAR(found->t, nearest->t, 1e-5F * (1.0F + nearest->t));  // triangles in one plane tie, but for rounding
    }
    EXPECT_GE(hits, count > 200 ? 2000 : count > 50 ? 300 : 0);
  }
}

TEST(MeshTracer, ManyEqualBoxesEnd) {
  Soup all = soup(1, 3);
  for (int i = 0; i < 5000; ++i) {
    for (uint32_t k = 0; k < 3; ++k) all.indices.push_back(k);
  }
  const MeshTracer tracer(all.positions, all.indices);
  EXPECT_FALSE(tracer.empty());
  Rng rng(Seed{5});
  for (int k = 0; k < 100; ++k) tracer.first(ray(rng), 1e9F);
  EXPECT_TRUE(MeshTracer().empty());
  EXPECT_FALSE(MeshTracer().any(ray(rng), 1e9F));
}

}  // namespace
}  // namespace seamount::geom
