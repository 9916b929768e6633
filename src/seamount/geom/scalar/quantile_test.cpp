#include "seamount/geom/scalar/quantile.h"

#include <gtest/gtest.h>

namespace seamount::geom {
namespace {

TEST(Quantile, IsTheValueAtItsPlaceInTheOrder) {
  const std::vector<float> values = {5, 1, 4, 2, 3};
  EXPECT_EQ(quantile(values, 0.0), 1.0F);
  EXPECT_EQ(quantile(values, 0.2), 2.0F);
  EXPECT_EQ(quantile(values, 0.59), 3.0F);
  EXPECT_EQ(quantile(values, 1.0), 5.0F) << "the last, though floor(share n) lies beyond it";
}

TEST(Median, IsTheUpperOfTwo) {
  EXPECT_EQ(median(std::vector<double>{3, 1, 2}), 2.0);
  EXPECT_EQ(median(std::vector<double>{4, 1, 3, 2}), 3.0);
  EXPECT_EQ(median(std::vector<double>{7}), 7.0);
}

}  // namespace
}  // namespace seamount::geom
