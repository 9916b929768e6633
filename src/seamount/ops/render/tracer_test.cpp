#include "seamount/ops/render/tracer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "seamount/base/rng.h"

namespace seamount::render {
namespace {

HeightField rough(int width, int height, uint64_t seed) {
  HeightField terrain(GridFrame::centred(width, height, 1.0));
  Rng rng(Seed{seed});
  for (float& h : terrain.cells()) h = static_cast<float>(rng.uniform(-2.0, 3.0));
  return terrain;
}

/// Independent and slow: small steps along the ray.
float walk(const Tracer& tracer, const LatticeRay& ray, float begin, float end) {
  for (float t = begin; t < end; t += 0.002F) {
    if (ray.height + t * ray.dheight <= tracer.height(ray.column + t * ray.dcolumn, ray.row + t * ray.drow)) return t;
  }
  return -1.0F;
}

TEST(Tracer, FindsTheFirstMeetingThatSmallStepsFind) {
  for (const auto& [w, h] : {std::pair{2, 2}, {17, 5}, {33, 40}, {2, 64}}) {
    const HeightField terrain = rough(w, h, static_cast<uint64_t>(w * 100 + h));
    const Tracer tracer(terrain, {});
    Rng rng(Seed{5});
    for (int i = 0; i < 300; ++i) {
      const LatticeRay ray{
          static_cast<float>(rng.uniform(-5.0, w + 5.0)), static_cast<float>(rng.uniform(-5.0, h + 5.0)),
          static_cast<float>(rng.uniform(0.0, 6.0)),      static_cast<float>(rng.uniform(-1.0, 1.0)),
          static_cast<float>(rng.uniform(-1.0, 1.0)),     static_cast<float>(rng.uniform(-0.6, 0.1))};
      float begin = 0.0F, end = 60.0F;
      if (!tracer.clip(ray, begin, end)) continue;
      const float slow = walk(tracer, ray, begin, end), fast = tracer.trace(ray, begin, end);
      if (slow < 0.0F) {
        // Small steps may miss a graze; where they do, the ray only just touches.
        if (fast < 0.0F) continue;
        const float gap =
            ray.height + fast * ray.dheight - tracer.height(ray.column + fast * ray.dcolumn, ray.row + fast * ray.drow);
        EXPECT_NEAR(gap, 0.0F, 0.01F);
      } else {
        ASSERT_GE(fast, 0.0F);
        EXPECT_LE(fast, slow + 1e-3F);
        const float gap =
            ray.height + fast * ray.dheight - tracer.height(ray.column + fast * ray.dcolumn, ray.row + fast * ray.drow);
        EXPECT_TRUE(fast <= begin + 1e-4F || std::abs(gap) <= 0.01F) << gap;
      }
    }
  }
}

TEST(Tracer, StraightDownMeetsTheBilinearSurface) {
  const HeightField terrain = rough(8, 8, 3);
  const Tracer tracer(terrain, {});
  const LatticeRay ray{2.3F, 5.6F, 10.0F, 0.0F, 0.0F, -1.0F};
  EXPECT_NEAR(10.0F - tracer.trace(ray, 0.0F, 50.0F), tracer.height(2.3F, 5.6F), 1e-5F);
}

TEST(Tracer, MissesWhatItFliesOver) {
  const HeightField terrain = rough(30, 30, 4);
  const Tracer tracer(terrain, {});
  EXPECT_LT(tracer.trace({0.5F, 0.5F, 3.5F, 1.0F, 0.7F, 0.0F}, 0.0F, 28.0F), 0.0F);
}

}  // namespace
}  // namespace seamount::render
