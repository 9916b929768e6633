#include "seamount/geom/grid/surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "seamount/geom/scalar/noise.h"

namespace seamount::geom {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

template <class Height>
HeightField terrain_of(const GridFrame& frame, Height height) {
  HeightField terrain(frame);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) terrain(x, y) = static_cast<float>(height(frame.x(x), frame.y(y)));
  }
  return terrain;
}

TEST(Surface, APlaneHasOneSlopeAndAspectUpToItsEdges) {
  const HeightField plane =
      terrain_of(GridFrame::centred(9, 7, 20.0), [](double x, double y) { return 100 + 0.3 * x - 0.4 * y; });
  const ScalarField slope = slope_deg(plane, {}), aspect = aspect_deg(plane, {});
  for (const float s : slope.cells()) EXPECT_NEAR(s, std::atan(0.5) * kDegrees, 1e-3);
  // Falls by 0.3 towards the west and by 0.4 towards the north.
  for (const float a : aspect.cells()) EXPECT_NEAR(a, 360.0 - std::atan2(0.3, 0.4) * kDegrees, 1e-2);
  for (const Curvature kind : {Curvature::profile, Curvature::plan, Curvature::mean}) {
    const ScalarField bent = curvature(plane, kind, {});
    for (const float c : bent.cells()) EXPECT_NEAR(c, 0.0, 1e-6);
  }
}

TEST(Surface, AspectIsTheBearingOfTheFall) {
  const auto bearing = [](double p, double q) {
    const HeightField plane =
        terrain_of(GridFrame::centred(3, 3, 10.0), [&](double x, double y) { return p * x + q * y; });
    return aspect_deg(plane, {})(1, 1);
  };
  EXPECT_NEAR(bearing(0, -1), 0, 1e-3);   // falls to the north
  EXPECT_NEAR(bearing(-1, 0), 90, 1e-3);  // to the east
  EXPECT_NEAR(bearing(0, 1), 180, 1e-3);
  EXPECT_NEAR(bearing(1, 0), 270, 1e-3);
  EXPECT_NEAR(bearing(-1, -1), 45, 1e-3);
  EXPECT_EQ(bearing(0, 0), -1);
}

TEST(Surface, ASphereIsConvexByItsRadius) {
  const double radius = 4000;
  const HeightField dome = terrain_of(GridFrame::centred(81, 81, 10.0), [&](double x, double y) {
    return std::sqrt(radius * radius - x * x - y * y) - radius;
  });
  for (const auto& [x, y] : {std::pair{40, 40}, {60, 45}, {20, 70}}) {
    const SurfaceFit fit = fit_surface(dome, x, y);
    EXPECT_NEAR(fit.profile_curvature(), 1 / radius, 0.03 / radius);
    EXPECT_NEAR(fit.plan_curvature(), 1 / radius, 0.03 / radius);
    EXPECT_NEAR(fit.mean_curvature(), 1 / radius, 0.03 / radius);
  }
}

TEST(Surface, AConeCurvesAlongItsContoursOnlyAndAValleyIsConcave) {
  // z = -|p| tan(a): normal curvature along the contour is sin(a) / |p|.
  const HeightField cone =
      terrain_of(GridFrame::centred(101, 101, 10.0), [](double x, double y) { return -0.75 * std::hypot(x, y); });
  const double distance = std::hypot(cone.frame().x(90), cone.frame().y(30));
  const SurfaceFit on_cone = fit_surface(cone, 90, 30);
  EXPECT_NEAR(on_cone.plan_curvature(), 0.6 / distance, 0.02 / distance);
  EXPECT_NEAR(on_cone.profile_curvature(), 0, 0.02 / distance);
  const HeightField valley =
      terrain_of(GridFrame::centred(51, 51, 10.0), [](double x, double y) { return 1e-3 * x * x + 0.2 * y; });
  EXPECT_LT(fit_surface(valley, 25, 25).plan_curvature(), -1e-3);
  EXPECT_NEAR(fit_surface(valley, 25, 25).profile_curvature(), 0, 1e-6);
}

TEST(Surface, FieldsAgreeWithThePlainFormOnEveryCell) {
  for (const auto& [width, height] : {std::pair{67, 41}, {1, 1}, {1, 9}, {9, 1}, {2, 2}}) {
    HeightField terrain = fbm_grid(GridFrame::centred(width, height, 12.0), Seed{4}, {.wavelength_m = 300}, {});
    for (float& z : terrain.cells()) z *= 120.0F;
    const ScalarField slope = slope_deg(terrain, {}), aspect = aspect_deg(terrain, {});
    const ScalarField profile = curvature(terrain, Curvature::profile, {});
    const ScalarField plan = curvature(terrain, Curvature::plan, {});
    const ScalarField mean = curvature(terrain, Curvature::mean, {});
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const SurfaceFit fit = fit_surface(terrain, x, y);
        ASSERT_NEAR(slope(x, y), fit.slope_deg(), 1e-3);
        if (fit.slope_deg() > 0.1) {
          ASSERT_NEAR(std::remainder(aspect(x, y) - fit.aspect_deg(), 360.0), 0, 0.02);
          ASSERT_NEAR(profile(x, y), fit.profile_curvature(), 2e-5);
          ASSERT_NEAR(plan(x, y), fit.plan_curvature(), 2e-5);
        }
        ASSERT_NEAR(mean(x, y), fit.mean_curvature(), 1e-5);
      }
    }
  }
}

TEST(Surface, AScaleTakesSmallFormsAwayAndLeavesPlanesAlone) {
  const GridFrame frame = GridFrame::centred(80, 60, 10.0);
  const HeightField plane = terrain_of(frame, [](double x, double y) { return 0.2 * x + 0.1 * y; });
  const HeightField rough =
      terrain_of(frame, [](double x, double y) { return 0.2 * x + 0.1 * y + std::sin(x / 4.0) * std::sin(y / 4.0); });
  const HeightField smooth = at_scale(rough, 100.0, {}), still = at_scale(plane, 100.0, {});
  for (size_t i = 0; i < plane.size(); ++i) {
    ASSERT_NEAR(still.cells()[i], plane.cells()[i], 0.02);
    const int x = static_cast<int>(i) % 80, y = static_cast<int>(i) / 80;
    const bool edge = x < 10 || y < 10 || x >= 70 || y >= 50;  // the outermost cells keep their heights
    ASSERT_NEAR(smooth.cells()[i], plane.cells()[i], edge ? 2.0 : 0.02);
  }
  EXPECT_EQ(at_scale(rough, 5.0, {}), rough);
  EXPECT_EQ(at_scale(HeightField(GridFrame::centred(1, 1, 10.0), 3.0F), 1e5, {})(0, 0), 3.0F);
}

TEST(Surface, MeanIsHalfTheSumAndLevelGroundHasNoDirection) {
  const HeightField terrain = terrain_of(GridFrame::centred(5, 5, 10.0), [](double x, double y) {
    return 0.002 * x * x - 0.001 * y * y + 0.1 * x + 0.05 * y;
  });
  const SurfaceFit fit = fit_surface(terrain, 2, 2);
  EXPECT_NEAR(fit.mean_curvature(), 0.5 * (fit.profile_curvature() + fit.plan_curvature()), 1e-12);
  const SurfaceFit level{0, 0, -0.01, 0, -0.03};
  EXPECT_NEAR(level.profile_curvature(), 0.02, 1e-12);
  EXPECT_NEAR(level.plan_curvature(), 0.02, 1e-12);
  EXPECT_EQ(level.aspect_deg(), -1);
}

}  // namespace
}  // namespace seamount::geom
