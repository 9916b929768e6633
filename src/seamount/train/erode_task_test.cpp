#include "seamount/train/erode_task.h"

#include <gtest/gtest.h>

#include <cmath>

#include "seamount/base/error.h"
#include "seamount/ops/learned/erode_planes.h"

namespace seamount::train {
namespace {

TEST(ErodeTask, ASampleIsAFunctionOfItsNumber) {
  const ErodeTask task("", 64, 2, Seed{3}, {});
  const Sample a = task.training(7);
  task.training(900);
  const Sample b = task.training(7);
  EXPECT_EQ(a.planes, b.planes);
  EXPECT_EQ(a.target, b.target);
  EXPECT_NE(a.target, task.training(8).target);
  EXPECT_NE(a.target, task.held_out(7).target);
  ASSERT_EQ(a.target.size(), 64U * 64U);
  ASSERT_EQ(a.planes.size(), a.target.size() * learned::kErodePlanes);
  for (const float dz : a.target) EXPECT_LE(std::abs(dz), 12);
  for (const float w : a.weight) EXPECT_TRUE(w > 0 && w <= 1);
}

TEST(ErodeTask, RefusesWhatMakesNoSamples) {
  EXPECT_THROW(ErodeTask("", 60, 2, Seed{1}, {}), InvalidArgument);
  EXPECT_THROW(ErodeTask("", 288, 2, Seed{1}, {}), InvalidArgument);
  EXPECT_THROW(ErodeTask("", 64, 0, Seed{1}, {}), InvalidArgument);
  EXPECT_THROW(ErodeTask("/nowhere", 64, 2, Seed{1}, {}), InvalidArgument);
}

}  // namespace
}  // namespace seamount::train
