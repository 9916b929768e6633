#include "seamount/ops/erosion/fans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace seamount::erosion {
namespace {

double sum(const ScalarField& field) { return std::accumulate(field.cells().begin(), field.cells().end(), 0.0); }

TEST(Fans, ADamOfFreshSedimentRunsOffToTheSides) {
  const GridFrame frame = GridFrame::centred(41, 41, 10);
  Layers ground{HeightField(frame, 100.0F), ScalarField(frame, 2.0F), ScalarField(frame, 1.0F)};
  ScalarField fresh(frame, 0.0F), share(frame), next(frame);
  for (int y = 0; y < 41; ++y) {
    fresh(20, y) = 3;
    ground.surface(20, y) += 3;
    ground.sediment(20, y) += 3;
  }
  const double surface = sum(ground.surface), sediment = sum(ground.sediment);
  spread_deposits(ground, fresh, {}, share, next, {});
  EXPECT_NEAR(sum(ground.surface), surface, 1e-6 * surface);
  EXPECT_NEAR(sum(ground.sediment), sediment, 1e-5 * sediment);
  EXPECT_LT(ground.surface(20, 20), 101);
  EXPECT_GT(ground.surface(17, 20), 100.1F);
  for (const float debris : ground.debris.cells()) EXPECT_EQ(debris, 2);
  for (const float fine : ground.sediment.cells()) EXPECT_GE(fine, 1);
}

TEST(Fans, OldGroundStays) {
  const GridFrame frame = GridFrame::centred(20, 20, 10);
  Layers ground{HeightField(frame, 0.0F), ScalarField(frame, 0.0F), ScalarField(frame, 50.0F)};
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 20; ++x) ground.surface(x, y) = static_cast<float>(x * x);
  }
  const HeightField before = ground.surface;
  ScalarField fresh(frame, 0.0F), share(frame), next(frame);
  spread_deposits(ground, fresh, {}, share, next, {});
  EXPECT_TRUE(ground.surface == before);
}

}  // namespace
}  // namespace seamount::erosion
