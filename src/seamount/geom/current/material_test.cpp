// Materials in currents around objects: what the figures of P3 show, as laws.
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "seamount/geom/current/kelvinlet_sum.h"
#include "seamount/geom/current/object_flow.h"
#include "seamount/geom/solve/transport.h"

namespace seamount::geom {
namespace {

VectorField flowing(const GridFrame& frame, Vec2 v) {
  return {ScalarField(frame, static_cast<float>(v.x)), ScalarField(frame, static_cast<float>(v.y))};
}

Polygon disc(Vec2 centre, double radius) {
  Polygon polygon;
  for (int i = 0; i < 60; ++i) {
    const double a = 2.0 * std::numbers::pi * i / 60.0;
    polygon.outer.push_back(centre + radius * Vec2{std::cos(a), std::sin(a)});
  }
  return polygon;
}

void deposit(ScalarField& source, Vec2 centre, double radius, float rate) {
  const GridFrame& frame = source.frame();
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x)
      if (std::hypot(frame.x(x) - centre.x, frame.y(y) - centre.y) < radius) source(x, y) += rate;
}

/// Mean over the cells within `radius` of a place.
double mean(const ScalarField& field, Vec2 centre, double radius) {
  const GridFrame& frame = field.frame();
  double sum = 0.0;
  int count = 0;
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x)
      if (std::hypot(frame.x(x) - centre.x, frame.y(y) - centre.y) < radius)
        sum += static_cast<double>(field(x, y)), ++count;
  return sum / count;
}

TEST(Material, SandGathersBetweenTwoIslandsAndNotAroundOne) {  // fig. 1.27
  const GridFrame frame = GridFrame::centred(200, 120, 10.0);
  const Vec2 west{-330, 0}, east{330, 0}, middle{0, 0};
  const auto sand_of = [&](const std::vector<Vec2>& islands) {
    ScalarField source(frame, 0.0F);
    std::vector<RegionFlow> regions;
    for (const Vec2 at : islands) {
      deposit(source, at, 200.0, 1e-3F);
      regions.push_back({disc(at, 200.0), 250.0, 0.3, 0.0});
    }
    VectorField current = flowing(frame, {0, 0});
    add_region_flow(regions, current, {});
    return steady_state({&source, &current, nullptr, 3.0, 1e-4}, {});
  };
  const ScalarField both = sand_of({west, east}), alone = sand_of({west});
  // Between them far more than on the islands' other sides, and more than the sum of two that stand alone.
  const double between = mean(both, middle, 40.0);
  EXPECT_GT(between, 1.5 * mean(both, {-660, 0}, 40.0));
  EXPECT_GT(between, 1.05 * 2.0 * mean(alone, middle, 40.0));
  EXPECT_GT(mean(both, {0, 130}, 40.0), 1.2 * 2.0 * mean(alone, {0, 130}, 40.0));  // in the ends of the valley most
  // The flow carries the sand off the island itself.
  EXPECT_LT(mean(alone, west, 100.0), mean(alone, {-330, 280}, 40.0));
  // Around one it lies evenly.
  const double ring = mean(alone, {-330, 280}, 40.0);
  EXPECT_NEAR(mean(alone, {-330 + 280, 0}, 40.0), ring, 0.15 * ring);
}

TEST(Material, ARockLeavesAWake) {  // fig. 1.34: a scale and two twists behind it
  const GridFrame frame = GridFrame::centred(160, 120, 5.0);
  ScalarField source(frame, 0.0F);
  for (double y = -60; y <= 60; y += 20) deposit(source, {-250, y}, 8.0, 0.01F);
  const auto sand = [&](const std::vector<Kelvinlet>& rock) {
    VectorField current = flowing(frame, {0.5, 0.0});
    add_kelvinlets(rock, current, {});
    return steady_state({&source, &current, nullptr, 0.2, 1e-3}, {});
  };
  const double eps = 50.0;
  const std::vector<Kelvinlet> rock = {{KelvinletKind::scale, {0, 0}, eps, {0.7, 0}},
                                       {KelvinletKind::twist, {70, 40}, 40.0, {0.35, 0}},
                                       {KelvinletKind::twist, {70, -40}, 40.0, {-0.35, 0}}};
  const ScalarField with = sand(rock), without = sand({});
  EXPECT_LT(mean(with, {0, 0}, 25.0), 0.5 * mean(without, {0, 0}, 25.0));        // on the rock there is less
  EXPECT_GT(mean(with, {20, 130}, 20.0), 3.0 * mean(without, {20, 130}, 20.0));  // it went round it,
  EXPECT_GT(mean(with, {20, -130}, 20.0), 3.0 * mean(without, {20, -130}, 20.0));
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 160; x += 7)
      ASSERT_NEAR(with(x, y), with(x, 119 - y), 5e-3F * with(x, y) + 2e-4F) << x << ' ' << y;
}

struct Spread {
  double mass = 0.0, along = 0.0, width = 0.0, top = 0.0;
};

Spread spread_of(const ScalarField& field) {
  const GridFrame& frame = field.frame();
  Spread spread;
  double second = 0.0;
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      const auto c = static_cast<double>(field(x, y));
      spread.mass += c;
      spread.along += c * frame.x(x);
      second += c * frame.y(y) * frame.y(y);
      spread.top = std::max(spread.top, c);
    }
  spread.along /= spread.mass;
  spread.width = std::sqrt(second / spread.mass);
  return spread;
}

TEST(Material, TheFiveVariantsOfACanyonsSand) {  // fig. 1.44
  const GridFrame frame = GridFrame::centred(240, 120, 5.0);
  ScalarField source(frame, 0.0F);
  for (const double x : {-60.0, -10.0, 30.0}) deposit(source, {x, x / 4}, 12.0, 0.01F);
  VectorField water = flowing(frame, {0, 0});
  add_curve_flow(std::vector<CurveFlow>{{{{-700, 0}, {700, 0}}, 60.0, 0.5, 0.0}}, water, {});
  const auto variant = [&](float coupling, double diffusivity, double decay) {
    VectorField flow = water;
    for (ScalarField* part : {&flow.x, &flow.y})
      for (float& v : part->cells()) v *= coupling;
    return spread_of(steady_state({&source, &flow, nullptr, diffusivity, decay}, {}));
  };
  const double middle = -40.0 / 3.0;
  const Spread normal = variant(1.0F, 0.5, 0.01), lasting = variant(1.0F, 0.5, 0.002), heavy = variant(0.0F, 0.5, 0.01),
               diffuse = variant(1.0F, 10.0, 0.01), inverse = variant(-1.0F, 0.5, 0.01);
  EXPECT_GT(normal.along, middle + 20.0);  // downstream
  EXPECT_GT(lasting.mass, 2.0 * normal.mass);
  EXPECT_GT(lasting.along, normal.along + 40.0);
  EXPECT_NEAR(heavy.along, middle, 2.0);
  EXPECT_GT(heavy.top, normal.top);
  EXPECT_GT(diffuse.width, 1.5 * normal.width);
  EXPECT_LT(diffuse.top, normal.top);
  EXPECT_LT(inverse.along, middle - 20.0);  // upwind
}

}  // namespace
}  // namespace seamount::geom
