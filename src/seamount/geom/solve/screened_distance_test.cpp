#include "seamount/geom/solve/screened_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "seamount/base/error.h"
#include "seamount/geom/polygon/distance.h"

namespace seamount::geom {
namespace {

TEST(ScreenedDistance, BesideAStraightBorderItIsTheDistance) {
  Grid<uint8_t> inside(GridFrame::centred(120, 30, 5.0), 0);
  for (int y = 0; y < 30; ++y) inside(3, y) = 1;
  const ScalarField exact = distance_to(inside, {});
  for (const double length : {10.0, 20.0, 60.0}) {
    const ScalarField screened = screened_distance(inside, length, {});
    for (int x = 3; x < 60; ++x)
      EXPECT_NEAR(screened(x, 15), exact(x, 15), 0.02F * exact(x, 15) + 1e-3F) << x << ' ' << length;
  }
}

TEST(ScreenedDistance, OrdersPlacesAsTheExactDistanceDoes) {
  Grid<uint8_t> inside(GridFrame::centred(90, 70, 2.0), 0);
  for (int y = 20; y < 40; ++y)
    for (int x = 30; x < 50; ++x) inside(x, y) = std::hypot(x - 40, y - 30) < 9.0 ? 1 : 0;
  const ScalarField exact = distance_to(inside, {}), screened = screened_distance(inside, 4.0, {});
  for (int y = 0; y < 70; ++y)
    for (int x = 0; x < 90; ++x) {
      if (inside(x, y) != 0) {
        EXPECT_EQ(screened(x, y), 0.0F);
      }
      EXPECT_NEAR(screened(x, y), exact(x, y), 0.12F * exact(x, y) + 1.0F) << x << ' ' << y;
    }
}

TEST(ScreenedDistance, IsInfiniteToNothingAndRefusesNoLength) {
  Grid<uint8_t> inside(GridFrame::centred(5, 1, 2.0), 0);
  const ScalarField none = screened_distance(inside, 3.0, {});
  for (const float v : none.cells()) EXPECT_EQ(v, std::numeric_limits<float>::infinity());
  EXPECT_THROW(screened_distance(inside, 0.0, {}), InvalidArgument);
  inside(0, 0) = 1;
  const ScalarField one = screened_distance(inside, 4.0, {});
  for (int x = 1; x < 5; ++x) EXPECT_GT(one(x, 0), one(x - 1, 0));
}

}  // namespace
}  // namespace seamount::geom
