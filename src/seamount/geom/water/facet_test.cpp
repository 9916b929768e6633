#include "seamount/geom/water/facet.h"

#include <gtest/gtest.h>

#include <cmath>

#include "seamount/geom/scalar/noise.h"

namespace seamount::geom {
namespace {

TEST(Facets, WaterFollowsAPlanesSlopeOnAverage) {
  for (const double angle_deg : {0.0, 10.0, 30.0, 45.0, 80.0, 200.0, 355.0}) {
    const double angle = angle_deg * 3.14159265358979 / 180;
    HeightField plane(GridFrame::centred(60, 60, 10));
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 60; ++x)
        plane(x, y) = static_cast<float>(500 - 3 * (std::cos(angle) * x + std::sin(angle) * -y));  // row 0 is north
    FlowDirections ways = flow_directions(plane, kNoSea, {});
    turn_to_facets(plane, kNoSea, Seed{5}, ways, {});
    double east = 0, north = 0;
    for (int y = 1; y < 59; ++y) {
      for (int x = 1; x < 59; ++x) {
        ASSERT_LT(ways(x, y), 8);
        east += kFlowDx[ways(x, y)];
        north -= kFlowDy[ways(x, y)];
      }
    }
    EXPECT_NEAR(std::remainder(std::atan2(north, east) - angle, 6.28318530717959), 0, 0.02) << angle_deg;
  }
}

TEST(Facets, EachStepFallsAndTheLowestPlacesKeepTheirWays) {
  const GridFrame frame = GridFrame::centred(90, 70, 25);
  HeightField z = fbm_grid(frame, Seed{2}, {.wavelength_m = 900, .octaves = 5}, {});
  for (float& h : z.cells()) h *= 200;
  const HeightField filled = fill_depressions(z, -20, {});
  const FlowDirections before = flow_directions(filled, -20, {});
  FlowDirections ways = before;
  RunContext one;
  one.threads = 1;
  turn_to_facets(filled, -20, Seed{3}, ways, {});
  FlowDirections again = before;
  turn_to_facets(filled, -20, Seed{3}, again, one);
  EXPECT_EQ(ways, again);
  const auto steps = flow_steps(frame.width);
  int turned = 0;
  for (size_t i = 0; i < ways.size(); ++i) {
    if (before.data()[i] < 8) {  // the plain form as judge
      std::array<float, 8> fall{};
      for (size_t k = 0; k < 8; ++k)
        fall[k] = filled.data()[i] - std::max(-20.0F, filled.data()[static_cast<int64_t>(i) + steps[k]]);
      const uint8_t drawn = steepest_facet(fall, facet_draw(Seed{3}, i));
      ASSERT_EQ(ways.data()[i], drawn < 8 && fall[drawn] > 0 ? drawn : before.data()[i]);
    }
    if (ways.data()[i] == before.data()[i]) continue;
    ++turned;
    ASSERT_LT(ways.data()[i], 8);
    ASSERT_LT(std::max(-20.0F, filled.data()[static_cast<int64_t>(i) + steps[ways.data()[i]]]), filled.data()[i]);
  }
  EXPECT_GT(turned, 200);
  EXPECT_EQ(count_pits(ways), 0);
}

}  // namespace
}  // namespace seamount::geom
