#include "seamount/geom/scalar/point_source.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace seamount::geom {
namespace {

TEST(PointSource, BesselK0HasItsTabulatedValues) {
  EXPECT_NEAR(bessel_k0(0.1), 2.4270690, 1e-6);
  EXPECT_NEAR(bessel_k0(1.0), 0.4210244, 1e-6);
  EXPECT_NEAR(bessel_k0(2.0), 0.1138939, 1e-6);
  EXPECT_NEAR(bessel_k0(5.0), 0.003691098, 1e-8);
}

TEST(PointSource, HoldsWhatItDepositedOverItsDecay) {
  const double diffusivity = 3.0, decay = 0.02, rate = 1.7;
  double point = 0.0, gaussian = 0.0;
  const double dr = 0.05;
  for (double r = dr / 2; r < 400.0; r += dr) {
    point += 2.0 * std::numbers::pi * r * dr * steady_point_source(rate, r, diffusivity, decay);
    gaussian += 2.0 * std::numbers::pi * r * dr * steady_gaussian_source(rate, r, diffusivity, decay, 8.0);
  }
  EXPECT_NEAR(point, rate / decay, 2e-3 * rate / decay);
  EXPECT_NEAR(gaussian, rate / decay, 2e-3 * rate / decay);
}

TEST(PointSource, ANarrowGaussianIsAPoint) {
  for (const double r : {5.0, 20.0, 60.0}) {
    const double exact = steady_point_source(1.0, r, 2.0, 0.01);
    EXPECT_NEAR(steady_gaussian_source(1.0, r, 2.0, 0.01, 0.02), exact, 1e-4 * exact) << r;
  }
}

TEST(PointSource, SteadyStateIsTheSumOfAllThatWasReleased) {
  const double diffusivity = 2.0, decay = 0.05, r = 6.0;
  double sum = 0.0;
  const double dt = 0.01;
  for (double t = dt / 2; t < 400.0; t += dt) sum += dt * released_unit(r, 0.0, t, 0.0, 0.0, diffusivity, decay);
  EXPECT_NEAR(sum, steady_point_source(1.0, r, diffusivity, decay), 1e-4 * sum);
}

TEST(PointSource, ReleasedUnitDriftsAndDecays) {
  double mass = 0.0, east = 0.0;
  for (double x = -60; x <= 100; x += 0.5)
    for (double y = -60; y <= 60; y += 0.5) {
      const double c = 0.25 * released_unit(x, y, 10.0, 2.0, -1.0, 3.0, 0.1);
      mass += c;
      east += c * x;
    }
  EXPECT_NEAR(mass, std::exp(-1.0), 1e-6);
  EXPECT_NEAR(east / mass, 20.0, 1e-6);
}

}  // namespace
}  // namespace seamount::geom
