#include "seamount/ops/erosion/slopes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace seamount::erosion {
namespace {

Layers flat(int width, int height, float sediment, float debris) {
  const GridFrame frame = GridFrame::centred(width, height, 10);
  return {HeightField(frame, 100.0F), ScalarField(frame, debris), ScalarField(frame, sediment)};
}

double sum(const ScalarField& field) { return std::accumulate(field.cells().begin(), field.cells().end(), 0.0); }

double steepest_deg(const HeightField& z) {
  double most = 0;
  for (int y = 0; y < z.height(); ++y) {
    for (int x = 0; x < z.width(); ++x) {
      most = std::max({most, std::abs(static_cast<double>(z(x, y)) - z.clamped(x + 1, y)),
                       std::abs(static_cast<double>(z(x, y)) - z.clamped(x, y + 1))});
    }
  }
  return std::atan(most / z.cell_m()) * 180 / std::numbers::pi;
}

void settle(Layers& ground, const Slopes& slopes, int steps) {
  ScalarField share(ground.frame()), next(ground.frame());
  for (int i = 0; i < steps; ++i) run_slopes(ground, {}, slopes, share, next, {});
}

TEST(Slopes, EachLayerComesToRestAtItsAngle) {
  const Slopes slopes{.years = 1000, .sediment_angle_deg = 20, .debris_angle_deg = 35, .bedrock_angle_deg = 60};
  for (const auto& [sediment, debris, angle] :
       {std::tuple{200.0F, 0.0F, 20.0}, {0.0F, 200.0F, 35.0}, {0.0F, 0.0F, 60.0}}) {
    Layers ground = flat(61, 41, 0, 0);
    const auto cell = static_cast<size_t>(20) * 61 + 30;
    ground.surface.data()[cell] += 200;
    ground.sediment.data()[cell] = sediment;
    ground.debris.data()[cell] = debris;
    const double before = sum(ground.surface);
    settle(ground, slopes, 300);
    EXPECT_NEAR(sum(ground.surface), before, 1e-6 * before);
    EXPECT_LT(steepest_deg(ground.surface), angle + 1) << angle;
    EXPECT_GT(steepest_deg(ground.surface), 0.5 * angle) << angle;
    EXPECT_NEAR(sum(ground.sediment), sediment, 0.01);
  }
}

TEST(Slopes, BareSteepRockCrumbles) {
  Layers ground = flat(30, 30, 0, 0);
  for (int y = 0; y < 30; ++y) {
    for (int x = 10; x < 30; ++x) ground.surface(x, y) += 6.0F * static_cast<float>(std::min(x, 20) - 10);
  }
  const HeightField before = ground.surface;
  settle(ground, {.years = 1000, .weathering_m_yr = 1e-3, .slides = 0}, 1);
  EXPECT_EQ(ground.debris(4, 15), 0);
  EXPECT_GT(ground.debris(15, 15), 0.3F);
  EXPECT_TRUE(ground.surface == before);
}

}  // namespace
}  // namespace seamount::erosion
