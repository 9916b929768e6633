#include "seamount/geom/skeleton/region_snake.h"

#include <gtest/gtest.h>

#include <numbers>

#include "seamount/base/error.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/skeleton/tangles.h"
#include "seamount/geom/skeleton/test_fields.h"

namespace seamount::geom {
namespace {

Ring circle(Vec2 middle, double radius, int points) {
  Ring ring;
  for (int i = 0; i < points; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / points;
    ring.push_back(middle + radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return ring;
}

void expect_sound(const RegionFit& fit, const FieldAtPlaces& field) {
  const Ring& ring = fit.skeleton.points;
  ASSERT_GE(ring.size(), 8U);
  EXPECT_EQ(fit.skeleton.kind, SkeletonKind::region);
  EXPECT_GT(signed_area(ring), 0.0);
  EXPECT_TRUE(find_tangles(ring, true).empty());
  for (const RegionFit::Step& step : fit.steps) ASSERT_LT(step.after, step.before);
  std::vector<double> values(ring.size());
  field(ring, values);
  for (const double value : values) ASSERT_TRUE(std::isfinite(value));
}

TEST(RegionSnake, OnFlatGroundIsADiscOfItsArea) {
  const FieldAtPlaces flat = field_of([](Vec2) { return 3.0; });
  for (const double area : {100.0, 1e6, 1e9}) {
    const RegionFit fit = grow_regions(std::vector<RegionSeed>{{{70.0, -30.0}, area}}, {}, flat, {})[0];
    expect_sound(fit, flat);
    EXPECT_NEAR(fit.area_m2, area, 0.02 * area);
    const double length = ring_length(fit.skeleton.points);
    EXPECT_GT(4.0 * std::numbers::pi * fit.area_m2 / (length * length), 0.98);
    EXPECT_TRUE(fit.rests);
  }
}

TEST(RegionSnake, FollowsABelt) {
  // A belt around an island of 300 m, 60 m broad or so; the area is half of it.
  const FieldAtPlaces belt = field_of([](Vec2 p) {
    const double off = (std::hypot(p.x, p.y) - 300.0 - 30.0 * std::sin(5.0 * std::atan2(p.y, p.x))) / 40.0;
    return std::exp(-0.5 * off * off);
  });
  const RegionFit fit = grow_regions(std::vector<RegionSeed>{{{300.0, 0.0}, 90000.0}}, {}, belt, {})[0];
  expect_sound(fit, belt);
  EXPECT_NEAR(fit.area_m2, 90000.0, 4500.0);
  EXPECT_GT(fit.mean_field, 0.8);
  EXPECT_FALSE(contains(fit.skeleton.points, {0.0, 0.0}));
  const double length = ring_length(fit.skeleton.points);
  EXPECT_LT(4.0 * std::numbers::pi * fit.area_m2 / (length * length), 0.4);
}

TEST(RegionSnake, StaysSimpleAndInTheDomainWhateverTheField) {
  double sum = 0.0;
  for (uint64_t seed = 0; seed < 12; ++seed) {
    for (const double wavelength : {60.0, 250.0, 1000.0}) {
      const FieldAtPlaces noise = noise_in_square(Seed{seed}, wavelength, 1000.0);
      const FieldAtPlaces field = [&](std::span<const Vec2> places, std::span<double> values) {
        noise(places, values);
        for (size_t i = 0; i < places.size(); ++i) {
          if (std::hypot(places[i].x - 400.0, places[i].y - 500.0) < 60.0) values[i] = -INFINITY;
        }
      };
      const std::vector<RegionSeed> seeds = {{{500.0, 500.0}, 100000.0}, {{150.0, 850.0}, 50000.0}};
      const RegionOptions options = {.internal = 0.3, .border = seed % 2 == 0 ? 0.0 : 1.0, .steps = 60};
      for (const RegionFit& fit : grow_regions(seeds, options, field, {})) {
        expect_sound(fit, field);
        sum += fit.mean_field / (12.0 * 3.0 * 2.0);
      }
    }
  }
  EXPECT_GT(sum, 0.65);  // the field's mean is a half
}

TEST(RegionSnake, CannotGrowBeyondItsDomain) {
  const FieldAtPlaces field = noise_in_square(Seed{4}, 40.0, 100.0);
  const RegionFit fit = grow_regions(std::vector<RegionSeed>{{{50.0, 50.0}, 20000.0}}, {}, field, {})[0];
  expect_sound(fit, field);
  EXPECT_LT(fit.area_m2, 10000.0);
  EXPECT_GT(fit.area_m2, 7500.0);
}

TEST(RegionSnake, HeldVerticesStayAndAreaFollowsItsTarget) {
  const FieldAtPlaces field = noise_in_square(Seed{8}, 300.0, 1000.0);
  RegionOutlineToFit outline = {{SkeletonKind::region, circle({500.0, 500.0}, 100.0, 40)}, 0.0};
  outline.skeleton.hold.assign(40, 0.0F);
  outline.skeleton.hold[0] = 1.0F;
  outline.skeleton.hold[7] = 1.0F;
  outline.skeleton.hold[20] = 0.5F;
  for (const double area : {15000.0, 31000.0, 60000.0}) {
    outline.area_m2 = area;
    const RegionFit fit = fit_regions(std::vector{outline}, {}, field, {})[0];
    expect_sound(fit, field);
    EXPECT_NEAR(fit.area_m2, area, 0.05 * area);
    size_t held = 0;
    for (size_t i = 0; i < fit.skeleton.points.size(); ++i) {
      if (fit.skeleton.hold[i] < 1.0F) continue;
      EXPECT_EQ(fit.skeleton.points[i], outline.skeleton.points[held == 0 ? 0 : 7]);
      ++held;
    }
    EXPECT_EQ(held, 2U);
  }
  // In either direction, and without a target.
  outline.skeleton.hold.clear();
  std::reverse(outline.skeleton.points.begin(), outline.skeleton.points.end());
  outline.area_m2 = 0.0;
  const RegionFit fit = fit_regions(std::vector{outline}, {}, field, {})[0];
  expect_sound(fit, field);
}

TEST(RegionSnake, MirroredAndScaledWorldsGiveMirroredAndScaledRegions) {
  const Fbm shape = {.wavelength_m = 400.0, .octaves = 2};
  const auto gamma = [&](Vec2 p) { return fbm(Seed{5}, shape, p.x, p.y); };
  const RegionOptions options = {.steps = 400, .least_gain = 1e-6};
  const auto grown = [&](Vec2 at, double area, auto function) {
    return grow_regions(std::vector<RegionSeed>{{at, area}}, options, field_of(function), {})[0];
  };
  const RegionFit plain = grown({40.0, 70.0}, 50000.0, gamma);
  const RegionFit mirrored = grown({-40.0, 70.0}, 50000.0, [&](Vec2 p) { return gamma({-p.x, p.y}); });
  const RegionFit scaled = grown({400.0, 700.0}, 5000000.0, [&](Vec2 p) { return 40.0 * gamma(0.1 * p) + 9.0; });
  EXPECT_NEAR(mirrored.mean_field, plain.mean_field, 0.01);
  EXPECT_NEAR(scaled.mean_field, 40.0 * plain.mean_field + 9.0, 0.4);
  for (const Vec2 p : plain.skeleton.points) {
    double nearest_mirrored = 1e9, nearest_scaled = 1e9;
    for (const Vec2 q : mirrored.skeleton.points) {
      nearest_mirrored = std::min(nearest_mirrored, std::hypot(p.x + q.x, p.y - q.y));
    }
    for (const Vec2 q : scaled.skeleton.points) {
      nearest_scaled = std::min(nearest_scaled, std::hypot(p.x - 0.1 * q.x, p.y - 0.1 * q.y));
    }
    EXPECT_LT(nearest_mirrored, 12.0);
    EXPECT_LT(nearest_scaled, 12.0);
  }
}

TEST(RegionSnake, MeasuresWhatItHolds) {
  const FieldAtPlaces tilted = field_of([](Vec2 p) { return 2.0 * p.x - 3.0 * p.y + 5.0; });
  const Ring square = {{10.0, 20.0}, {50.0, 20.0}, {50.0, 80.0}, {10.0, 80.0}};
  std::vector<float> corners(4, 1.0F);
  const std::vector<RegionOutlineToFit> outlines = {{{SkeletonKind::region, square, corners}, 0.0}};
  const RegionFit fit = fit_regions(outlines, {.steps = 0}, tilted, {})[0];
  EXPECT_NEAR(fit.mean_field, 2.0 * 30.0 - 3.0 * 50.0 + 5.0, 1e-9);
  EXPECT_NEAR(fit.area_m2, 2400.0, 1e-9);
  std::vector<double> energies;
  const FieldAtPlaces hill = field_of([](Vec2 p) { return std::exp(-dot(p, p) / 20000.0); });
  for (const double spacing : {8.0, 4.0, 2.0}) {
    const RegionOptions options = {
        .border = 1.0, .bend_m = 20.0, .spacing_m = spacing, .raster_m = 2.0, .field_unit = 0.3, .steps = 1};
    const std::vector<RegionOutlineToFit> round = {{{SkeletonKind::region, circle({60.0, 0.0}, 100.0, 400)}, 31000.0}};
    energies.push_back(fit_regions(round, options, hill, {})[0].steps.at(0).before);
  }
  EXPECT_NEAR(energies[0], energies[2], 0.02 * std::abs(energies[2]));
  EXPECT_NEAR(energies[1], energies[2], 0.005 * std::abs(energies[2]));
}

TEST(RegionSnake, ManyTogetherAreWhatEachIsAloneAndCostFewCalls) {
  size_t calls = 0;
  const FieldAtPlaces noise = noise_in_square(Seed{3}, 200.0, 2000.0);
  const FieldAtPlaces counted = [&](std::span<const Vec2> p, std::span<double> v) {
    ++calls;
    noise(p, v);
  };
  std::vector<RegionSeed> seeds;
  seeds.reserve(10);
  for (int i = 0; i < 10; ++i) seeds.push_back({{200.0 * i + 30.0, 1000.0}, 5000.0 + 2000.0 * i});
  const RegionOptions options = {.steps = 40};
  const std::vector<RegionFit> together = grow_regions(seeds, options, counted, {});
  EXPECT_LT(calls, 60U);
  const std::vector<RegionFit> one_thread = grow_regions(seeds, options, noise, RunContext{.threads = 1});
  for (size_t i = 0; i < seeds.size(); ++i) EXPECT_EQ(one_thread[i].skeleton, together[i].skeleton);
  EXPECT_EQ(grow_regions(std::vector{seeds[4]}, options, noise, {})[0].skeleton, together[4].skeleton);
}

TEST(RegionSnake, BadInput) {
  const FieldAtPlaces field = noise_in_square(Seed{1}, 50.0, 100.0);
  EXPECT_TRUE(grow_regions(std::vector<RegionSeed>{{{-50.0, 5.0}, 20.0}}, {}, field, {})[0].skeleton.points.empty());
  EXPECT_TRUE(grow_regions({}, {}, field, {}).empty());
  EXPECT_THROW(grow_regions(std::vector<RegionSeed>{{{5.0, 5.0}, -1.0}}, {}, field, {}), InvalidArgument);
  EXPECT_THROW(grow_regions({}, {.raster_m = -1.0}, field, {}), InvalidArgument);
  const std::vector<RegionOutlineToFit> line = {{{SkeletonKind::region, {{1.0, 1.0}, {2.0, 2.0}}}, 10.0}};
  EXPECT_THROW(fit_regions(line, {}, field, {}), InvalidArgument);
  EXPECT_THROW(grow_regions(std::vector<RegionSeed>{{{5.0, 5.0}, 1e6}}, {.raster_m = 0.1}, field, {}), InvalidArgument);
  // Without a target a region that likes it everywhere ends where its raster does.
  const std::vector<RegionOutlineToFit> greedy = {{{SkeletonKind::region, circle({0.0, 0.0}, 1.0, 20)}, 0.0}};
  const RegionOptions wild = {.inside = 50.0, .field_unit = 1.0};
  const RegionFit grown = fit_regions(greedy, wild, field_of([](Vec2) { return 1.0; }), {})[0];
  EXPECT_TRUE(find_tangles(grown.skeleton.points, true).empty());
  const std::vector<RegionOutlineToFit> huge = {{{SkeletonKind::region, circle({50.0, 50.0}, 45.0, 20)}, 1e-9}};
  EXPECT_LT(fit_regions(huge, {}, field, {})[0].skeleton.points.size(), 5000U);
  const Ring knot = {{10.0, 10.0}, {50.0, 50.0}, {50.0, 10.0}, {10.0, 45.0}};
  const std::vector<RegionOutlineToFit> crossed = {{{SkeletonKind::region, knot}, 10.0}};
  EXPECT_EQ(fit_regions(crossed, {}, field, {})[0].skeleton.points.size(), knot.size());
}

}  // namespace
}  // namespace seamount::geom
