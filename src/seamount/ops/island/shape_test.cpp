#include "seamount/ops/island/shape.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "seamount/base/error.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/ops/island/outlines.h"

namespace seamount::island {
namespace {

using ::testing::HasSubstr;

Ring circle(Vec2 centre, double radius, int points = 256) {
  Ring ring;
  for (int i = 0; i < points; ++i) {
    const double a = 2 * std::numbers::pi * i / points;
    ring.push_back(centre + radius * Vec2{std::cos(a), std::sin(a)});
  }
  return ring;
}

template <class Function>
std::string message_of(Function function) {
  try {
    function();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(PlanFromPolar, OutlinesThatCrossAreRefusedWithTheirPlace) {
  const std::string message = message_of([] {
    plan_from_polar({{{1000}}, {{1100, 900, 1100, 1100}}, {{2000}}, {{3000}}, {{4000}}}, {}, {});
  });
  EXPECT_THAT(message, HasSubstr("outline 1 (1000 m) does not lie inside outline 2"));
  EXPECT_THAT(message, HasSubstr("degrees"));
}

TEST(PlanFromPolar, RefusesOtherNumbersOfOutlinesAndRadiiThatAreNotPositive) {
  EXPECT_THAT(message_of([] { plan_from_polar({{{1000}}, {{1100}}}, {}, {}); }), HasSubstr("2 outlines; give one"));
  EXPECT_THAT(message_of([] { plan_from_polar({{{-5}}}, {}, {}); }), HasSubstr("radius -5"));
}

TEST(PlanFromPolar, DerivesOrderedOutlinesFromTheCoast) {
  const Plan plan = plan_from_polar({{{4000, 5000, 3000, 4500}}}, {}, {});
  ASSERT_EQ(plan.polar.size(), 5U);
  for (size_t a = 0; a < plan.polar[0].radii_m.size(); ++a) {
    for (size_t i = 0; i + 1 < plan.polar.size(); ++i)
      EXPECT_LT(plan.polar[i].radii_m[a], plan.polar[i + 1].radii_m[a]);
  }
}

TEST(PlanFromAreas, NamesDefectsAndCrossings) {
  const Polygon bow{{{0, 0}, {1000, 1000}, {1000, 0}, {0, 1000}}, {}};
  EXPECT_THAT(message_of([&] {
                plan_from_areas({{{"kauai", {bow}}}, {}, {}}, {}, "coast");
              }),
              HasSubstr("coast: 'kauai': "));
  const Drawing crossing{{{"beach", {{circle({0, 0}, 1000), {}}}}, {"reef", {{circle({800, 0}, 1000), {}}}}}, {}, {}};
  EXPECT_THAT(message_of([&] { plan_from_areas(crossing, {}, "outlines"); }),
              HasSubstr("outline 'beach' crosses outline 'reef' at x = "));
  EXPECT_THAT(message_of([] { plan_from_areas({}, {}, "coast"); }), HasSubstr("coast: holds no area"));
}

TEST(PlanFromAreas, LinesThatCloseAreACoast) {
  const Ring ring = circle({}, 1000, 40);
  Drawing drawing;
  drawing.lines.push_back({{ring.begin(), ring.begin() + 21}, 0, false, {}});
  drawing.lines.push_back({{ring.begin() + 20, ring.end()}, 0, false, {}});
  drawing.lines[1].points.push_back(ring.front());
  drawing.lines.push_back({circle({4000, 0}, 500, 30), 0, true, {}});
  const Plan plan = plan_from_areas(drawing, {}, "coast");
  EXPECT_EQ(plan.areas[kCoast].size(), 2U);
  EXPECT_NEAR(plan.land_m2, std::numbers::pi * (1e6 + 0.25e6), 0.02e6);
  drawing.lines.resize(1);
  EXPECT_THAT(message_of([&] { plan_from_areas(drawing, {}, "coast"); }),
              HasSubstr("coast: a line runs from (1000, 0) to (-1000, 0) and does not close"));
}

TEST(PlanFromAreas, TakesWhatIslandOutlinesTracesOfAnyLabels) {
  for (const uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
    LabelMap labels(GridFrame::centred(120, 90, 30.0), Region::abyss);
    for (int y = 0; y < 90; ++y)
      for (int x = 0; x < 120; ++x) {
        const double angle = std::atan2(y - 45, x - 60);
        const double wave = geom::fbm_circle(Seed{seed}, angle + 0.01 * x, 4.0, 5);
        const double r = std::hypot(x - 60, y - 45) * (1.0 + 0.6 * wave);
        labels(x, y) = r < 15   ? Region::mountain
                       : r < 16 ? Region::beach
                       : r < 25 ? Region::lagoon
                       : r < 26 ? Region::reef
                                : Region::abyss;
        if (x % 17 == 3 && y % 13 == 4 && r < 35) labels(x, y) = labels(x, std::min(y + 1, 89)) = Region::mountain;
      }
    const Drawing drawing = outlines(labels, {}, {});
    EXPECT_EQ(message_of([&] { plan_from_areas(drawing, {}, "outlines"); }), "no error") << "seed " << seed;
  }
}

TEST(CheckFits, SaysHowLargeTheDomainMustBe) {
  const Plan plan = plan_from_polar({{{4000}}}, {}, {});
  const std::string message = message_of([&] { check_fits(plan, GridFrame::centred(100, 100, 50), "coast"); });
  EXPECT_THAT(message, HasSubstr("touches the edge of the domain"));
  EXPECT_THAT(message, HasSubstr("it fits into width_m = "));
  EXPECT_EQ(message_of([&] { check_fits(plan, GridFrame::centred(300, 300, 50), "coast"); }), "no error");
}

TEST(PlanFromLabels, RefusesAMapOfAbyssAndFindsTheLand) {
  LabelMap labels(GridFrame::centred(200, 160, 20), Region::abyss);
  EXPECT_THAT(message_of([&] { plan_from_labels(labels, {}); }), HasSubstr("all of it is abyss"));
  for (int y = 40; y < 120; ++y) {
    for (int x = 60; x < 140; ++x) labels(x, y) = Region::mountain;
  }
  const Plan plan = plan_from_labels(labels, {});
  EXPECT_EQ(plan.areas[0].size(), 1U);
  EXPECT_NEAR(plan.land_m2, 80 * 80 * 400.0, 0.03 * 80 * 80 * 400.0);
}

TEST(ResampleRadii, PassesThroughTheGivenRadiiAndIsPeriodic) {
  const std::vector<double> given = {3, 5, 4, 6};
  const std::vector<double> fine = resample_radii(given, 400);
  for (size_t i = 0; i < given.size(); ++i) EXPECT_NEAR(fine[100 * i], given[i], 1e-12);
  EXPECT_NEAR(fine.front(), fine.back(), 0.1);
}

}  // namespace
}  // namespace seamount::island
