#include "seamount/geom/skeleton/snake.h"

#include <gtest/gtest.h>

#include <numbers>

#include "seamount/base/error.h"
#include "seamount/geom/skeleton/elastic_line.h"
#include "seamount/geom/skeleton/tangles.h"
#include "seamount/geom/skeleton/test_fields.h"

namespace seamount::geom {
namespace {

Polyline straight(Vec2 from, Vec2 to, int edges) {
  Polyline line;
  for (int i = 0; i <= edges; ++i) line.push_back(from + (static_cast<double>(i) / edges) * (to - from));
  return line;
}

void expect_falling(const SnakeFit& fit) {
  for (size_t i = 1; i < fit.energies.size(); ++i) ASSERT_LT(fit.energies[i], fit.energies[i - 1]);
}

FieldAtPlaces hill(Vec2 top, double sigma) {
  return field_of([=](Vec2 p) { return std::exp(-dot(p - top, p - top) / (2.0 * sigma * sigma)); });
}

/// Mean squared slope of the field along a line.
double steepness(const Polyline& line, const FieldAtPlaces& field) {
  std::vector<double> values(line.size());
  field(line, values);
  double sum = 0.0;
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec2 edge = line[i + 1] - line[i];
    const double rise = (values[i + 1] - values[i]) / std::hypot(edge.x, edge.y);
    sum += rise * rise / static_cast<double>(line.size() - 1);
  }
  return sum;
}

TEST(Snake, GradientWeightDecidesWhetherItClimbsOrKeepsToTheContour) {  // P3 fig. 1.26
  const FieldAtPlaces field = hill({0.0, 0.0}, 300.0);
  SnakeCurve start;
  start.skeleton = {SkeletonKind::curve, straight({-500.0, 300.0}, {0.0, 300.0}, 30), std::vector<float>(31, 0.0F)};
  start.skeleton.hold[0] = 1.0F;
  start.length_m = 500.0;
  std::vector<double> steep, ends;
  for (const double gradient : {30.0, 0.0, -30.0}) {
    const SnakeOptions options = {.external = 0.0, .gradient = gradient, .field_unit = 0.5, .steps = 500};
    const SnakeFit fit = fit_snakes(std::vector{start}, options, field, {})[0];
    EXPECT_EQ(fit.skeleton.points[0], start.skeleton.points[0]);
    EXPECT_NEAR(fit.length_m, 500.0, 25.0);
    steep.push_back(steepness(fit.skeleton.points, field));
    ends.push_back(std::hypot(fit.skeleton.points.back().x, fit.skeleton.points.back().y));
    expect_falling(fit);
  }
  EXPECT_GT(steep[0], 1.3 * steep[1]);
  EXPECT_LT(steep[2], 0.7 * steep[1]);
  EXPECT_LT(ends[0], 200.0);  // up the hill
  EXPECT_GT(ends[2], 300.0);  // round it
}

TEST(Snake, ReachesItsLength) {
  const std::vector<FieldAtPlaces> fields = {field_of([](Vec2) { return 0.0; }), field_of([](Vec2) { return 7.0; }),
                                             hill({100.0, 50.0}, 400.0),
                                             field_of([](Vec2 p) { return 300.0 * std::sin(p.x / 200.0); })};
  for (size_t f = 0; f < fields.size(); ++f) {
    for (const double length : {50.0, 2000.0, 10000.0}) {
      const std::vector<SnakeSeed> seeds = {{{10.0, 20.0}, length, {0.6, 0.8}}};
      for (const double gradient : {-1.0, 0.0, 1.0}) {
        const SnakeFit fit = grow_snakes(seeds, {.gradient = gradient}, fields[f], {})[0];
        EXPECT_NEAR(fit.length_m, length, 0.05 * length) << f << " " << gradient;
        EXPECT_EQ(fit.skeleton.kind, SkeletonKind::curve);
        expect_falling(fit);
      }
    }
  }
  const SnakeFit flat = grow_snakes(std::vector<SnakeSeed>{{{0.0, 0.0}, 100.0, {0.6, 0.8}}}, {}, fields[0], {})[0];
  for (const Vec2 p : flat.skeleton.points) EXPECT_NEAR(cross(p, Vec2{0.6, 0.8}), 0.0, 1e-6);
}

TEST(Snake, FindsARingFromOnePlaceOnIt) {
  // A crest of radius 300 m, 40 m broad: 1.5 km of its 1.9 km.
  const FieldAtPlaces crest = field_of([](Vec2 p) {
    const double off = (std::hypot(p.x, p.y) - 300.0) / 40.0;
    return std::exp(-0.5 * off * off);
  });
  const SnakeFit fit = grow_snakes(std::vector<SnakeSeed>{{{290.0, 20.0}, 1500.0}}, {}, crest, {})[0];
  EXPECT_NEAR(fit.length_m, 1500.0, 75.0);
  EXPECT_GT(fit.mean_field, 0.97);
  for (const Vec2 p : fit.skeleton.points) EXPECT_NEAR(std::hypot(p.x, p.y), 300.0, 25.0);
}

TEST(Snake, NeverCrossesItselfNorLeavesTheDomainNorGainsEnergy) {
  for (uint64_t seed = 0; seed < 34; ++seed) {
    for (const double wavelength : {60.0, 250.0, 1000.0}) {
      const FieldAtPlaces field = noise_in_square(Seed{seed}, wavelength, 1000.0);
      const std::vector<SnakeSeed> seeds = {{{500.0, 500.0}, 1500.0}, {{120.0, 900.0}, 700.0}, {{3.0, 2.0}, 400.0}};
      const SnakeOptions options = {.external = 2.0, .gradient = static_cast<double>(seed % 3) - 1.0, .steps = 60};
      for (const SnakeFit& fit : grow_snakes(seeds, options, field, {})) {
        ASSERT_GE(fit.skeleton.points.size(), 2U);
        EXPECT_TRUE(find_tangles(fit.skeleton.points, false).empty());
        expect_falling(fit);
        std::vector<double> values(fit.skeleton.points.size());
        field(fit.skeleton.points, values);
        for (const double value : values) EXPECT_TRUE(std::isfinite(value));
        if (options.gradient > 0.0) {
          EXPECT_LE(values.front(), values.back());
        }
      }
    }
  }
}

TEST(Snake, HeldVerticesStayAndHinderedOnesLag) {
  const FieldAtPlaces field = field_of([](Vec2 p) { return -std::pow((p.y - 60.0) / 50.0, 2.0); });
  const Polyline line = straight({0.0, 0.0}, {400.0, 0.0}, 40);
  std::vector<SnakeCurve> curves(3);
  for (SnakeCurve& curve : curves) curve.skeleton = {SkeletonKind::curve, line, std::vector<float>(line.size(), 0.0F)};
  curves[1].skeleton.hold[20] = 1.0F;
  curves[2].skeleton.hold.assign(line.size(), 0.75F);
  const SnakeOptions one = {.field_unit = 1.0, .steps = 2};
  const std::vector<SnakeFit> early = fit_snakes(curves, one, field, {});
  EXPECT_EQ(early[1].skeleton.points[20], line[20]);
  EXPECT_GT(early[0].skeleton.points[20].y, 5.0);
  EXPECT_GT(early[2].skeleton.points[20].y, 0.0);
  EXPECT_LT(early[2].skeleton.points[20].y, 0.75 * early[0].skeleton.points[20].y);
  const SnakeOptions many = {.field_unit = 1.0, .steps = 500};
  const std::vector<SnakeFit> late = fit_snakes(curves, many, field, {});
  EXPECT_EQ(late[1].skeleton.points[20], line[20]);
  EXPECT_GT(late[1].skeleton.points[0].y, 5.0);
  EXPECT_EQ(late[1].skeleton.hold, curves[1].skeleton.hold);
  // With a target, vertices are spread anew: held ones stay among them.
  curves[1].length_m = 500.0;
  const SnakeFit longer = fit_snakes(std::vector{curves[1]}, many, field, {})[0];
  const auto held = std::find(longer.skeleton.hold.begin(), longer.skeleton.hold.end(), 1.0F);
  ASSERT_NE(held, longer.skeleton.hold.end());
  EXPECT_EQ(longer.skeleton.points[static_cast<size_t>(held - longer.skeleton.hold.begin())], line[20]);
  EXPECT_NEAR(longer.length_m, 500.0, 25.0);
}

TEST(Snake, ALineThatIsTooLongGivesUpItsEnds) {
  const SnakeCurve curve = {{SkeletonKind::curve, straight({0.0, 0.0}, {900.0, 10.0}, 60)}, 500.0};
  const SnakeFit fit = fit_snakes(std::vector{curve}, {}, field_of([](Vec2 p) { return p.x / 900.0; }), {})[0];
  EXPECT_NEAR(fit.length_m, 500.0, 25.0);
  EXPECT_GT(fit.skeleton.points.front().x, 300.0);
  expect_falling(fit);
}

TEST(Snake, MirroredAndScaledWorldsGiveMirroredAndScaledSnakes) {
  const Fbm shape = {.wavelength_m = 300.0, .octaves = 2};
  const auto gamma = [&](Vec2 p) { return fbm(Seed{5}, shape, p.x, p.y); };
  const std::vector<SnakeSeed> seed = {{{40.0, 70.0}, 600.0, {0.0, 1.0}}};
  const SnakeOptions options = {.gradient = -0.5};
  const Polyline plain = grow_snakes(seed, options, field_of(gamma), {})[0].skeleton.points;
  const std::vector<SnakeSeed> mirrored_seed = {{{-40.0, 70.0}, 600.0, {0.0, 1.0}}};
  const Polyline mirrored = grow_snakes(mirrored_seed, options, field_of([&](Vec2 p) {
                                          return gamma({-p.x, p.y});
                                        }),
                                        {})[0]
                                .skeleton.points;
  const std::vector<SnakeSeed> large_seed = {{{400.0, 700.0}, 6000.0, {0.0, 1.0}}};
  const Polyline large =
      grow_snakes(large_seed, options, field_of([&](Vec2 p) { return 100.0 * gamma(0.1 * p) - 3.0; }), {})[0]
          .skeleton.points;
  const Polyline scaled =
      grow_snakes(large_seed, options, field_of([&](Vec2 p) { return gamma(0.1 * p); }), {})[0].skeleton.points;
  ASSERT_EQ(mirrored.size(), plain.size());
  ASSERT_EQ(scaled.size(), plain.size());
  const bool turned = std::abs(mirrored[0].x + plain[0].x) > 1.0;  // which end comes first may change
  for (size_t i = 0; i < plain.size(); ++i) {
    const Vec2 m = mirrored[turned ? plain.size() - 1 - i : i];
    EXPECT_NEAR(m.x, -plain[i].x, 0.5);
    EXPECT_NEAR(m.y, plain[i].y, 0.5);
    EXPECT_NEAR(scaled[i].x, 10.0 * plain[i].x, 5.0);
    EXPECT_NEAR(scaled[i].y, 10.0 * plain[i].y, 5.0);
  }
  EXPECT_NEAR(chain_length(large, false), 6000.0, 300.0);
}

TEST(Snake, EnergyDoesNotDependOnTheNumberOfVertices) {
  const FieldAtPlaces field = hill({50.0, 0.0}, 80.0);
  std::vector<double> energies;
  for (const int edges : {200, 400, 800}) {
    SnakeCurve wave;
    for (int i = 0; i <= edges; ++i) {
      const double x = 200.0 * i / edges;
      wave.skeleton.points.push_back({x, 8.0 * std::sin(x / 20.0)});
    }
    wave.skeleton.kind = SkeletonKind::curve;
    const SnakeOptions options = {.gradient = 2.0, .bend_m = 20.0, .field_unit = 0.3, .steps = 0};
    energies.push_back(fit_snakes(std::vector{wave}, options, field, {})[0].energies[0]);
  }
  EXPECT_NEAR(energies[1], energies[2], 0.01 * std::abs(energies[2]));
  EXPECT_NEAR(energies[0], energies[2], 0.04 * std::abs(energies[2]));
}

TEST(Snake, ManyTogetherAreWhatEachIsAloneAndCostFewCalls) {
  size_t calls = 0, places = 0;
  const FieldAtPlaces noise = noise_in_square(Seed{3}, 200.0, 2000.0);
  const FieldAtPlaces counted = [&](std::span<const Vec2> p, std::span<double> v) {
    ++calls;
    places += p.size();
    noise(p, v);
  };
  std::vector<SnakeSeed> seeds;
  seeds.reserve(20);
  for (int i = 0; i < 20; ++i) seeds.push_back({{100.0 * i + 30.0, 1000.0}, 300.0 + 10.0 * i});
  const std::vector<SnakeFit> together = grow_snakes(seeds, {}, counted, {});
  EXPECT_LT(calls, 700U);
  for (size_t i = 0; i < seeds.size(); i += 7) {
    EXPECT_EQ(grow_snakes(std::vector{seeds[i]}, {}, noise, {})[0].skeleton, together[i].skeleton);
  }
  const std::vector<SnakeFit> one_thread = grow_snakes(seeds, {}, noise, RunContext{.threads = 1});
  for (size_t i = 0; i < seeds.size(); ++i) EXPECT_EQ(one_thread[i].skeleton, together[i].skeleton);
  // Four times the vertices, about four times the places.
  std::vector<size_t> cost;
  for (const double spacing : {5.0, 1.25}) {
    places = 0;
    const FieldAtPlaces waves = [&](std::span<const Vec2> p, std::span<double> v) {
      places += p.size();
      for (size_t i = 0; i < p.size(); ++i) v[i] = std::sin(p[i].x / 90.0) * std::cos(p[i].y / 70.0);
    };
    grow_snakes(std::span(seeds).first(4), {.spacing_m = spacing}, waves, {});
    cost.push_back(places);
  }
  EXPECT_LT(cost[1], 8 * cost[0]);
}

TEST(Snake, BadInput) {
  const FieldAtPlaces field = noise_in_square(Seed{1}, 50.0, 100.0);
  const SnakeFit lost = grow_snakes(std::vector<SnakeSeed>{{{-5.0, 5.0}, 20.0}}, {}, field, {})[0];
  EXPECT_TRUE(lost.skeleton.points.empty());
  EXPECT_TRUE(grow_snakes({}, {}, field, {}).empty());
  const std::vector<SnakeSeed> none = {{{5.0, 5.0}, 0.0}};
  EXPECT_THROW(grow_snakes(none, {}, field, {}), InvalidArgument);
  EXPECT_THROW(grow_snakes({}, {.internal = -1.0}, field, {}), InvalidArgument);
  const std::vector<SnakeCurve> dot = {{{SkeletonKind::curve, {{1.0, 1.0}}}, 10.0}};
  EXPECT_THROW(fit_snakes(dot, {}, field, {}), InvalidArgument);
  const Polyline knot = {{10.0, 10.0}, {50.0, 50.0}, {50.0, 10.0}, {10.0, 50.0}};
  EXPECT_EQ(fit_snakes(std::vector<SnakeCurve>{{{SkeletonKind::curve, knot}}}, {}, field, {})[0].skeleton.points, knot);
  const std::vector<SnakeCurve> long_one = {{{SkeletonKind::curve, {{0.0, 10.0}, {100.0, 10.0}}}, 1e-6}};
  EXPECT_LT(fit_snakes(long_one, {}, field, {})[0].skeleton.points.size(), 5000U);
  const Polyline nowhere = {{10.0, 10.0}, {10.0, 10.0}};
  EXPECT_EQ(fit_snakes(std::vector<SnakeCurve>{{{SkeletonKind::curve, nowhere}}}, {}, field, {})[0].skeleton.points,
            nowhere);
}

}  // namespace
}  // namespace seamount::geom
