#include "seamount/geom/grid/pyramid_fill.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "seamount/base/rng.h"

namespace seamount::geom {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

TEST(PyramidFill, KeepsWhatIsGivenAndStaysBetween) {
  for (const auto& [width, height] : {std::pair{97, 41}, {1, 1}, {1, 30}, {64, 64}}) {
    Grid<float> values(GridFrame::centred(width, height, 10), kNone), weight(values.frame(), 0.0F);
    Rng rng(Seed{static_cast<uint64_t>(width)});
    for (int i = 0; i < 5; ++i) {
      const int x = rng.integer(0, width - 1), y = rng.integer(0, height - 1);
      values(x, y) = static_cast<float>(rng.uniform(2, 3));
      weight(x, y) = 1;
    }
    const Grid<float> given = values;
    pyramid_fill(values, weight, {.prior = 1.0F}, {});
    for (size_t i = 0; i < values.size(); ++i) {
      if (weight.data()[i] == 1) {
        EXPECT_EQ(values.data()[i], given.data()[i]);
      }
      EXPECT_GE(values.data()[i], 0.999F);
      EXPECT_LE(values.data()[i], 3.001F);
    }
  }
}

TEST(PyramidFill, FarAwayIsThePrior) {
  Grid<float> values(GridFrame::centred(512, 512, 1), kNone), weight(values.frame(), 0.0F);
  values(10, 10) = 1;
  weight(10, 10) = 1;
  pyramid_fill(values, weight, {.prior = 0.0F, .fade = 0.5F}, {});
  EXPECT_LT(values(500, 500), 0.05F);
  float nearer = 1;
  for (const int x : {11, 13, 20, 40, 90, 250}) {
    EXPECT_LT(values(x, 10), nearer) << x;
    nearer = values(x, 10);
  }
  EXPECT_GT(values(11, 10), 0.3F);
  Grid<float> empty(values.frame(), kNone);
  pyramid_fill(empty, Grid<float>(values.frame(), 0.0F), {.prior = 0.35F}, {});
  EXPECT_EQ(empty(3, 3), 0.35F);
}

TEST(PyramidFill, AConstantStaysOneWithoutFading) {
  Grid<float> values(GridFrame::centred(100, 60, 1), 0.0F), weight(values.frame(), 0.0F);
  values(7, 50) = values(80, 3) = 5;
  weight(7, 50) = weight(80, 3) = 1;
  pyramid_fill(values, weight, {.fade = 1.0F}, {});
  for (const float v : values.cells()) EXPECT_NEAR(v, 5, 1e-4F);
}

}  // namespace
}  // namespace seamount::geom
