// The promise that results are the same bits with both compilers and on every vector width: hashes that change only
// when an algorithm changes on purpose (then a recipe's cache must forget what it knew: raise the operators'
// revisions).
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

#include "seamount/geom/grid/height_layers.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/grid/surface.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/scalar/blend.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/solve/poisson.h"
#include "seamount/geom/water/gullies.h"

namespace seamount::geom {
namespace {

uint64_t fingerprint(const Grid<float>& grid) {
  uint64_t hash = 0;
  for (const float value : grid.cells()) hash = mix_bits(hash ^ std::bit_cast<uint32_t>(value));
  return hash;
}

class Bits : public testing::Test {
 protected:
  const GridFrame frame_ = {333, 257, 20.0, -3000.0, 5e5, {}};
  const RunContext run_ = {};
  const ScalarField noise_ = fbm_grid(frame_, Seed{1}, {.wavelength_m = 2000}, run_);

  Grid<uint8_t> upper_part() const {
    Grid<uint8_t> mask(frame_);
    for (size_t i = 0; i < mask.size(); ++i) mask.cells()[i] = noise_.cells()[i] > 0.3F ? 1 : 0;
    return mask;
  }
};

TEST_F(Bits, Noise) {
  EXPECT_EQ(fingerprint(noise_), 0x62bae0dbc40b125fULL);
  EXPECT_EQ(fingerprint(ridged_grid(frame_, Seed{2}, {.wavelength_m = 2000}, run_)), 0x7eb80808a49761e6ULL);
}

TEST_F(Bits, SurfaceAndLayers) {
  HeightField terrain = noise_;
  for (float& z : terrain.cells()) z *= 300.0F;
  EXPECT_EQ(fingerprint(slope_deg(terrain, run_)), 0x8f55e50782bbcfcULL);
  EXPECT_EQ(fingerprint(aspect_deg(terrain, run_)), 0xa934c8f9b4d46e7ULL);
  EXPECT_EQ(fingerprint(curvature(terrain, Curvature::plan, run_)), 0xa03ebba96b8324e7ULL);
  EXPECT_EQ(fingerprint(at_scale(terrain, 90.0, run_)), 0x2b3a7f9cf746c1e2ULL);
  const Layers layers = height_layers(terrain, {20.0, 30.0, 60.0, 15.0}, true, 0.5, run_);
  EXPECT_EQ(fingerprint(layers.low), 0x9419dd22bbf5babaULL);
  EXPECT_EQ(fingerprint(layers.high), 0xbbb9da2df5fbd71ULL);
}

TEST_F(Bits, Gullies) {
  HeightField height = noise_;
  for (float& z : height.cells()) z *= 900.0F;
  add_gullies(height, Seed{3}, {}, ScalarField(frame_, 1.0F), run_);
  EXPECT_EQ(fingerprint(height), 0xae25199015d004cbULL);
}

TEST_F(Bits, Distances) {
  EXPECT_EQ(fingerprint(distance_to(upper_part(), run_)), 0xba8c0a8bff06c9ULL);
  const Polygon triangle = {{{-2000, 499000}, {3000, 498000}, {100, 496000}}, {}};
  EXPECT_EQ(fingerprint(signed_distance({triangle}, frame_, run_)), 0x188eb12d4d53136bULL);
}

TEST_F(Bits, Filters) {
  ScalarField blurred = noise_;
  gaussian_blur(blurred, 90.0, run_);
  EXPECT_EQ(fingerprint(blurred), 0x2e30f45af85a2236ULL);
  ScalarField blended(frame_);
  smax_rows(noise_.cells(), blurred.cells(), 3.0F, blended.cells());
  EXPECT_EQ(fingerprint(blended), 0x9757cfabde39bc29ULL);
  EXPECT_EQ(fingerprint(resample(noise_, {200, 150, 33.0, -3000.0, 5e5, {}}, run_)), 0x6394914712d8698bULL);
}

TEST_F(Bits, Poisson) {
  ScalarField u = noise_;
  solve_laplace(u, upper_part(), run_);
  EXPECT_EQ(fingerprint(u), 0x3c9dc3c271ecc079ULL);
}

}  // namespace
}  // namespace seamount::geom
