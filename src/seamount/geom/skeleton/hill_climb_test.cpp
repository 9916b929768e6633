#include "seamount/geom/skeleton/hill_climb.h"

#include <gtest/gtest.h>

#include <limits>

#include "seamount/base/error.h"
#include "seamount/base/rng.h"
#include "seamount/geom/scalar/noise.h"

namespace seamount::geom {
namespace {

template <class Function>
FieldAtPlaces each(Function function) {
  return [function](std::span<const Vec2> places, std::span<double> values) {
    for (size_t i = 0; i < places.size(); ++i) values[i] = function(places[i]);
  };
}

std::vector<Vec2> scattered(Seed seed, int count, double side) {
  Rng rng(seed);
  std::vector<Vec2> points;
  points.reserve(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) points.push_back({rng.uniform(0.0, side), rng.uniform(0.0, side)});
  return points;
}

TEST(HillClimb, ReachesTheTopOfAHill) {
  const Vec2 top = {40.0, 65.0};
  const auto hill = each([&](Vec2 p) { return std::exp(-dot(p - top, p - top) / 2000.0); });
  for (const Climbed& climbed : hill_climb(scattered(Seed{1}, 200, 100.0), {.cell_m = 2.0}, hill, {})) {
    EXPECT_TRUE(climbed.rests);
    EXPECT_NEAR(climbed.at.x, top.x, 0.1);
    EXPECT_NEAR(climbed.at.y, top.y, 0.1);
  }
}

TEST(HillClimb, ReachesASharpRidge) {
  const auto ridge = each([](Vec2 p) { return -std::abs(p.x - p.y) - 0.1 * std::abs(p.x + p.y - 100.0); });
  for (const Climbed& climbed : hill_climb(scattered(Seed{2}, 50, 100.0), {.cell_m = 1.0, .steps = 1000}, ridge, {})) {
    EXPECT_LT(std::abs(climbed.at.x - climbed.at.y), 0.5);
  }
}

TEST(HillClimb, NeverGoesLowerAndStaysInTheDomain) {
  for (uint64_t seed = 0; seed < 5; ++seed) {
    const Fbm shape = {.wavelength_m = 30.0, .octaves = 5};
    const auto value = [&](Vec2 p) {
      if (p.x < 0.0 || p.y < 0.0 || p.x > 100.0 || p.y > 100.0) return std::numeric_limits<double>::quiet_NaN();
      if (std::hypot(p.x - 50.0, p.y - 50.0) < 10.0) return -std::numeric_limits<double>::infinity();
      return fbm(Seed{seed}, shape, p.x, p.y);
    };
    const std::vector<Vec2> points = scattered(Seed{seed}, 300, 100.0);
    const std::vector<Climbed> climbed = hill_climb(points, {.cell_m = 1.0, .most_distance_m = 20.0}, each(value), {});
    double gain = 0.0;
    for (size_t i = 0; i < points.size(); ++i) {
      const double before = value(points[i]);
      if (!std::isfinite(before)) {
        EXPECT_EQ(climbed[i].at, points[i]);
        EXPECT_FALSE(climbed[i].rests);
        continue;
      }
      EXPECT_EQ(climbed[i].value, value(climbed[i].at));
      EXPECT_GE(climbed[i].value, before);
      EXPECT_LE(std::hypot(climbed[i].at.x - points[i].x, climbed[i].at.y - points[i].y), 20.0 + 1e-9);
      gain += climbed[i].value - before;
    }
    EXPECT_GT(gain / static_cast<double>(points.size()), 0.2);
  }
}

TEST(HillClimb, CallsTheFieldOncePerStepOfAll) {
  int calls = 0;
  const FieldAtPlaces counted = [&](std::span<const Vec2> places, std::span<double> values) {
    ++calls;
    for (size_t i = 0; i < places.size(); ++i) values[i] = -dot(places[i], places[i]);
  };
  hill_climb(scattered(Seed{3}, 1000, 50.0), {.steps = 20}, counted, {});
  EXPECT_LE(calls, 21);
  calls = 0;
  EXPECT_TRUE(hill_climb({}, {}, counted, {}).empty());
  EXPECT_EQ(calls, 0);
}

TEST(HillClimb, FlatGroundIsARest) {
  const std::vector<Vec2> points = {{1.0, 2.0}};
  const std::vector<Climbed> climbed = hill_climb(points, {}, each([](Vec2) { return 3.0; }), {});
  EXPECT_TRUE(climbed[0].rests);
  EXPECT_EQ(climbed[0].at, points[0]);
  EXPECT_THROW(hill_climb(points, {.cell_m = 0.0}, each([](Vec2) { return 3.0; }), {}), InvalidArgument);
}

}  // namespace
}  // namespace seamount::geom
