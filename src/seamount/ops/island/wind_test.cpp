// P0 eq. 1.3 to 1.7 against values by hand, and the laws of warps.
#include "seamount/ops/island/wind.h"

#include <gtest/gtest.h>

#include <cmath>

#include "seamount/geom/current/stroke_field.h"
#include "seamount/ops/island/build.h"
#include "seamount/ops/island/radial_strokes.h"

namespace seamount::island {
namespace {

Stroke straight(double strength, double width = 800) { return {{{-6000, 0}, {6000, 0}}, width, strength}; }

TEST(Displacement, IsEquation1_3WithAnUnnormalisedFalloff) {
  const GridFrame frame = GridFrame::centred(200, 200, 40);
  const geom::StrokeField field({straight(300)}, frame, {});
  for (const double d : {0.0, 400.0, 800.0, 1600.0, 2400.0}) {
    const Vec2 phi = field.at(100, d);
    EXPECT_NEAR(phi.x, 300 * std::exp(-d * d / (2 * 800.0 * 800.0)), 0.8) << d;  // along the stroke
    EXPECT_NEAR(phi.y, 0, 0.01);
  }
}

/// Minutes and gigabytes before: a point every quarter of a width, two million kilometres long.
TEST(Displacement, APointFarAwayCostsNothingAndLeadsThere) {
  const GridFrame frame = GridFrame::centred(25, 25, 80);
  const auto from = [](double x) { return Stroke{{{x, 0}, {0, 100}, {500, 300}}, 150, 90}; };
  const geom::StrokeField far({from(-2147483649.0)}, frame, {}), near({from(-30000.0)}, frame, {});
  for (const Vec2 p : {Vec2{-900, 0}, {-400, 100}, {0, 0}, {0, 100}, {450, 250}, {800, -700}}) {
    EXPECT_NEAR(far.at(p.x, p.y).x, near.at(p.x, p.y).x, 3.0);
    EXPECT_NEAR(far.at(p.x, p.y).y, near.at(p.x, p.y).y, 3.0);
  }
  const geom::StrokeField nowhere({Stroke{{{1e9, 1e9}, {2e9, 1e9}}, 150, 90}}, frame, {});
  EXPECT_EQ(nowhere.at(0, 0), Vec2{});
}

TEST(Displacement, IsTheSumOverStrokes) {
  const GridFrame frame = GridFrame::centred(150, 150, 50);
  const Stroke other{{{0, -3000}, {0, 3000}}, 600, -150};
  const geom::StrokeField both({straight(300), other}, frame, {});
  const Vec2 phi = both.at(250, 350);
  EXPECT_NEAR(phi.x, 300 * std::exp(-350.0 * 350 / (2 * 800.0 * 800)), 0.8);
  EXPECT_NEAR(phi.y, -150 * std::exp(-250.0 * 250 / (2 * 600.0 * 600)), 0.8);
}

HeightField ramp(const GridFrame& frame) {
  HeightField h(frame);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) h(x, y) = static_cast<float>(0.1 * frame.x(x) + 0.02 * frame.y(y));
  }
  return h;
}

TEST(Wind, IsBackwardWarpingWithResistance) {
  const GridFrame frame = GridFrame::centred(160, 120, 50);
  const HeightField terrain = ramp(frame);
  const ScalarField coordinate(frame, 1.5F);
  const WindParams params{.strokes = {straight(300)}, .resistance = {{{0, 0.25}, {5, 0.25}}}};
  const Warped out = wind(terrain, nullptr, &coordinate, params, Seed{1}, {});
  for (const int y : {20, 45, 60, 80}) {
    const double phi = 300 * std::exp(-std::pow(frame.y(y), 2) / (2 * 800.0 * 800));
    EXPECT_NEAR(out.terrain(80, y), terrain(80, y) - 0.1 * 0.75 * phi, 0.1) << y;  // h(p - (1 - rho) Phi)
  }
}

TEST(Wind, FullResistanceAndNoStrokesLeaveTheTerrainAlone) {
  const GridFrame frame = GridFrame::centred(64, 48, 100);
  const HeightField terrain = ramp(frame);
  const ScalarField coordinate(frame, 2.0F);
  EXPECT_EQ(wind(terrain, nullptr, &coordinate, {}, Seed{1}, {}).terrain, terrain);
  const WindParams held{.strokes = {straight(300)}, .resistance = {{{0, 1.0}}}};
  EXPECT_EQ(wind(terrain, nullptr, &coordinate, held, Seed{1}, {}).terrain, terrain);
}

/// Strong strokes from several sides, which would fold the terrain if applied in one step.
WindParams storm() {
  WindParams p;
  p.strokes = {{{{-5000, 1000}, {0, 300}, {4000, -1500}}, 500, 1500},
               {{{3000, 4000}, {500, 0}, {-2000, -3000}}, 400, -1200}};
  p.radial_count = 18;
  p.radial_width_m = 250;
  p.radial_strength_m = 400;
  p.resistance = {{{0, 0.0}, {5, 0.0}}};
  return p;
}

TEST(Wind, IsABijectionHoweverStrongTheStrokes) {
  const GridFrame frame = GridFrame::centred(400, 400, 25);
  // Carrying the coordinates themselves shows where every cell comes from.
  HeightField x_of(frame), y_of(frame);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      x_of(x, y) = static_cast<float>(frame.x(x));
      y_of(x, y) = static_cast<float>(frame.y(y));
    }
  }
  const HeightField sx = wind(x_of, nullptr, nullptr, storm(), Seed{3}, {}).terrain;
  const HeightField sy = wind(y_of, nullptr, nullptr, storm(), Seed{3}, {}).terrain;
  const auto from_edge = [&](int x, int y) { return std::abs(sx(x, y)) > 4960 || std::abs(sy(x, y)) > 4960; };
  for (int y = 0; y + 1 < frame.height; ++y) {
    for (int x = 0; x + 1 < frame.width; ++x) {
      if (from_edge(x, y) || from_edge(x + 1, y) || from_edge(x, y + 1)) continue;  // beyond it nothing is known
      const double a = sx(x + 1, y) - sx(x, y), b = sx(x, y + 1) - sx(x, y);
      const double c = sy(x + 1, y) - sy(x, y), d = sy(x, y + 1) - sy(x, y);
      ASSERT_LT(a * d - b * c, 0) << x << " " << y;  // rows run south: the unmoved determinant is -25^2
    }
  }
}

TEST(Wind, LabelsMoveWithTheTerrain) {
  const GridFrame frame = GridFrame::centred(256, 256, 50);
  const Plan plan = plan_from_polar({{{3500}}}, {}, {});
  const Island isle =
      build(plan, {.massif = 0.0, .relief = 0, .detail = {.coast_m = 0.0, .noise_m = 0}}, frame, Seed{2}, {});
  WindParams p = storm();
  p.resistance = {{{0, 0.3}, {5, 0.3}}};
  const Warped out = wind(isle.terrain, &isle.labels, &isle.coordinate, p, Seed{2}, {});
  int wrong = 0;
  for (size_t c = 0; c < out.terrain.size(); ++c) {
    const bool land_by_label = out.labels.cells()[c] == Region::mountain || out.labels.cells()[c] == Region::beach;
    if (std::abs(out.terrain.cells()[c]) < 4.0F) continue;  // nearest and cubic readings differ by up to a cell
    wrong += land_by_label != (out.terrain.cells()[c] > 0) ? 1 : 0;
    EXPECT_NEAR(out.coordinate.cells()[c], static_cast<double>(out.labels.cells()[c]) + 0.5, 0.5 + 0.6);
  }
  EXPECT_LT(wrong, 40);
}

TEST(RadialStrokes, RunOutwardsLandwardAndSeawardInTurn) {
  const std::vector<Stroke> strokes = radial_strokes(12, 100, 80, {}, 5000, Seed{9});
  ASSERT_EQ(strokes.size(), 12U);
  for (size_t i = 0; i < strokes.size(); ++i) {
    EXPECT_GT(std::hypot(strokes[i].points.back().x, strokes[i].points.back().y),
              std::hypot(strokes[i].points.front().x, strokes[i].points.front().y));
    EXPECT_EQ(strokes[i].strength_m > 0, i % 2 == 0);
  }
  EXPECT_EQ(radial_strokes(12, 100, 80, {}, 5000, Seed{9})[3].points, strokes[3].points);
}

}  // namespace
}  // namespace seamount::island
