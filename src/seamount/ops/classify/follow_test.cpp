#include "seamount/ops/classify/follow.h"

#include <gtest/gtest.h>

#include "seamount/base/error.h"

namespace seamount::classify {
namespace {

TEST(FollowLabelsOfAnyChange, TakesTheLevelOfTheSeaAndChecksSizes) {
  HeightField before(GridFrame::centred(12, 5, 100));
  LabelMap labels(before.frame(), Region::lagoon);
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 12; ++x) {
      before(x, y) = static_cast<float>(10 * x - 55);
      if (x > 5) labels(x, y) = x == 6 ? Region::beach : Region::mountain;
    }
  }
  EXPECT_EQ(follow(before, before, labels, {}, {}), labels);
  const LabelMap high = follow(before, before, labels, {.sea_m = 20}, {});
  for (int x = 0; x < 12; ++x) {
    const bool land = high(x, 2) == Region::mountain || high(x, 2) == Region::beach;
    EXPECT_EQ(land, before(x, 2) > 20) << x;
  }
  EXPECT_THROW(follow(before, HeightField(GridFrame::centred(3, 3, 1)), labels, {}, {}), IncompatibleInputs);
  EXPECT_THROW(follow(before, before, labels, {.sea_m = 1e9}, {}), InvalidArgument);
}

}  // namespace
}  // namespace seamount::classify
