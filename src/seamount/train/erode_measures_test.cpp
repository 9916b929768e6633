#include "seamount/train/erode_measures.h"

#include <gtest/gtest.h>

#include "seamount/ops/learned/erode_planes.h"
#include "seamount/ops/learned/test_network.h"

namespace seamount::train {
namespace {

/// A network that adds nothing: the estimate alone.
learned::Network silent() {
  Weights weights = learned::random_weights({learned::kErodePlanes, {8, 16}}, 1);
  for (const char* name : {"outer.weight", "outer.bias"})
    for (float& w : weights.tensors[name].values) w = 0;
  return learned::Network(weights, learned::Precision::f32);
}

TEST(ErodeMeasures, ASilentNetworkIsTheEstimate) {
  const std::vector<ErodeMeasure> measures = measure_erosion(silent(), {}, 2, Seed{4}, {});
  ASSERT_EQ(measures.size(), 2U);
  for (const ErodeMeasure& one : measures) {
    EXPECT_NEAR(one.off, one.estimate, 0.02);  // but for what may not lie lower or higher than all ground around
    EXPECT_GT(one.seeds, 0.005);
    EXPECT_LT(one.seeds, one.estimate);
    EXPECT_LT(one.estimate, 0.9) << "better than no erosion";
    EXPECT_LE(std::abs(one.drift), one.off + 1e-6);
  }
  const ErodeMeasure mean = mean_of(measures);
  EXPECT_LT(mean.estimate, 0.7);
  EXPECT_GT(mean.years, 0);
}

}  // namespace
}  // namespace seamount::train
