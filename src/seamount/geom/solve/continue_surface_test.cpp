#include "seamount/geom/solve/continue_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace seamount::geom {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/// Known in a square, and on a slanting strip.
HeightField part_of(const HeightField& all) {
  HeightField known = all;
  for (int y = 0; y < all.height(); ++y) {
    for (int x = 0; x < all.width(); ++x) {
      const bool square = x >= 20 && x < 40 && y >= 15 && y < 30, strip = std::abs(x - 2 * y + 10) < 9;
      if (!square && !strip) known(x, y) = kNone;
    }
  }
  return known;
}

HeightField plane(int width, int height) {
  HeightField z(GridFrame::centred(width, height, 30));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) z(x, y) = 500.0F + 12.0F * static_cast<float>(x) - 7.0F * static_cast<float>(y);
  return z;
}

TEST(ContinueSurface, APlaneGoesOnAsThatPlane) {
  const HeightField all = plane(70, 50);
  HeightField made = all;
  continue_surface(part_of(all), {}, made, {});
  for (size_t i = 0; i < all.size(); ++i) ASSERT_NEAR(made.data()[i], all.data()[i], 0.01);
}

TEST(ContinueSurface, KnownCellsStayAndFarOnesDoNotChange) {
  const HeightField all = plane(70, 50), known = part_of(all);
  const HeightField before(all.frame(), -300.0F);
  HeightField made = before;
  continue_surface(known, {.near = 3, .far = 6}, made, {});
  int changed = 0;
  for (int y = 0; y < 50; ++y) {
    for (int x = 0; x < 70; ++x) {
      if (!std::isnan(known(x, y))) {
        ASSERT_EQ(made(x, y), known(x, y));
        continue;
      }
      double nearest = 1e9;
      for (int v = 0; v < 50; ++v)
        for (int u = 0; u < 70; ++u)
          if (!std::isnan(known(u, v))) nearest = std::min(nearest, std::hypot(u - x, v - y));
      EXPECT_EQ(made(x, y) != before(x, y), nearest < 6) << x << " " << y;
      changed += nearest < 6;
    }
  }
  EXPECT_GT(changed, 200);
}

TEST(ContinueSurface, NoCreaseAtTheRim) {
  HeightField all = plane(70, 50);
  for (int y = 0; y < 50; ++y)
    for (int x = 0; x < 70; ++x) all(x, y) += 60.0F * std::sin(0.2F * static_cast<float>(x + y));
  HeightField known = all;
  for (int y = 0; y < 50; ++y)
    for (int x = 35; x < 70; ++x) known(x, y) = kNone;
  HeightField level(all.frame(), 0.0F), made = level;
  for (int y = 0; y < 50; ++y)
    for (int x = 0; x < 70; ++x) made(x, y) = known(std::min(x, 34), y);  // meets the heights, with a crease
  const auto crease = [&](const HeightField& z) {
    double sum = 0;
    for (int y = 0; y < 50; ++y) sum += std::abs(z(35, y) - 2 * z(34, y) + z(33, y));
    return sum / 50;
  };
  const double before = crease(made);
  continue_surface(known, {}, made, {});
  EXPECT_LT(crease(made), 0.35 * before);
}

TEST(ContinueSurface, OddShapesAndThreads) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 9}, {9, 1}, {6, 5}}) {
    HeightField known = plane(width, height), made(known.frame(), 1.0F);
    known(width / 2, height / 2) = kNone;
    continue_surface(known, {}, made, {});
    for (const float z : made.cells()) EXPECT_TRUE(std::isfinite(z));
    HeightField none(known.frame(), kNone), same(known.frame(), 7.0F);
    continue_surface(none, {}, same, {});
    for (const float z : same.cells()) EXPECT_EQ(z, 7.0F);
  }
  const HeightField all = plane(70, 50), known = part_of(all);
  HeightField one(all.frame(), 0.0F), many = one;
  continue_surface(known, {}, one, {.threads = 1});
  continue_surface(known, {}, many, {.threads = 4});
  EXPECT_EQ(one, many);
}

}  // namespace
}  // namespace seamount::geom
