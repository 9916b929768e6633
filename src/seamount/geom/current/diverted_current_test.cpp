#include "seamount/geom/current/diverted_current.h"

#include <cmath>

#include <gtest/gtest.h>

#include "seamount/base/error.h"

namespace seamount::geom {
namespace {

HeightField sea_with(const GridFrame& frame, double height, double sigma) {
  HeightField sea(frame);
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      const double r2 = std::pow(frame.x(x), 2) + std::pow(frame.y(y), 2);
      sea(x, y) = static_cast<float>(-50.0 + height * std::exp(-r2 / (2 * sigma * sigma)));
    }
  return sea;
}

TEST(DivertedCurrent, OverALevelGroundIsTheBase) {
  const HeightField flat(GridFrame::centred(30, 20, 10.0), -20.0F);
  DiversionOptions options;
  options.base_m_s = {0.3, -0.4};
  VectorField current = diverted_current(flat, options, {});
  EXPECT_NEAR(current.x(10, 10), 0.3F, 1e-6F);
  EXPECT_NEAR(current.y(10, 10), -0.4F, 1e-6F);
  options.venturi_per_m = 0.05;  // twice as fast at 20 m
  current = diverted_current(flat, options, {});
  EXPECT_NEAR(current.x(10, 10), 0.6F, 1e-5F);
}

TEST(DivertedCurrent, IsTheEquationOnAPlane) {
  // Slope 0.1 to the north, current to the north-east: the contour it leans to is east.
  const GridFrame frame = GridFrame::centred(60, 60, 10.0);
  HeightField plane(frame);
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 60; ++x) plane(x, y) = static_cast<float>(-100.0 + 0.1 * frame.y(y));
  DiversionOptions options;
  options.base_m_s = {1.0, 1.0};
  options.scales = {{40.0, 1.0, 20.0}};
  const VectorField current = diverted_current(plane, options, {});
  EXPECT_NEAR(current.x(30, 30), 0.9 + 0.1 * std::sqrt(2.0) * 2.0, 1e-3);
  EXPECT_NEAR(current.y(30, 30), 0.9, 1e-3);
}

TEST(DivertedCurrent, GoesRoundAHillOnBothSides) {
  const GridFrame frame = GridFrame::centred(101, 101, 20.0);
  DiversionOptions options;
  options.base_m_s = {0.5, 0.0};
  const VectorField current = diverted_current(sea_with(frame, 120.0, 200.0), options, {});
  // Upstream (west) of the hill, north of its axis the flow turns north, south of it south; downstream it comes back.
  EXPECT_GT(current.y(38, 40), 0.02F);
  EXPECT_LT(current.y(38, 60), -0.02F);
  EXPECT_LT(current.y(62, 40), -0.02F);
  EXPECT_GT(current.y(62, 60), 0.02F);
  for (int y = 0; y < 101; ++y)
    for (int x = 0; x < 101; ++x) {
      ASSERT_NEAR(current.x(x, y), current.x(x, 100 - y), 2e-4F);
      ASSERT_NEAR(current.y(x, y), -current.y(x, 100 - y), 2e-4F);
      ASSERT_GE(current.x(x, y), -1e-4F);  // never against the base
    }
}

TEST(DivertedCurrent, DriesOutOnLand) {
  const GridFrame frame = GridFrame::centred(61, 61, 20.0);
  const HeightField sea = sea_with(frame, 120.0, 200.0);
  DiversionOptions options;
  options.base_m_s = {0.5, 0.0};
  options.shallows_m = 5.0;
  const VectorField current = diverted_current(sea, options, {});
  EXPECT_EQ(current.x(30, 30), 0.0F);
  EXPECT_GT(current.x(2, 2), 0.4F);
}

TEST(DivertedCurrent, OddShapesAndBadNumbers) {
  DiversionOptions options;
  options.base_m_s = {0.2, 0.1};
  EXPECT_NEAR(diverted_current(HeightField(GridFrame::centred(1, 1, 3.0), -4.0F), options, {}).x(0, 0), 0.2F, 1e-6F);
  EXPECT_NEAR(diverted_current(HeightField(GridFrame::centred(1, 9, 3.0), -4.0F), options, {}).y(0, 4), 0.1F, 1e-6F);
  options.scales[1].sigma_m = -1.0;
  try {
    diverted_current(HeightField(GridFrame::centred(4, 4, 3.0), -4.0F), options, {});
    FAIL();
  } catch (const InvalidArgument& e) {
    EXPECT_EQ(e.field(), "scales[1].sigma_m");
  }
  EXPECT_THROW(diverted_current(HeightField(GridFrame::centred(4, 4, 3.0), std::nanf("")), {}, {}), InvalidArgument);
}

}  // namespace
}  // namespace seamount::geom
