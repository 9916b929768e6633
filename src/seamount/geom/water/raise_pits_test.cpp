// Raised pits: nothing is lowered, and what is left to fill is small.
#include "seamount/geom/water/raise_pits.h"

#include <gtest/gtest.h>

#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/water/flow.h"

namespace seamount::geom {
namespace {

HeightField noise(int w, int h, uint64_t seed, int octaves = 8) {
  HeightField terrain(GridFrame::centred(w, h, 50));
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x)
      terrain(x, y) = static_cast<float>(
          400 * fbm(Seed{seed}, {.wavelength_m = 900, .octaves = octaves}, terrain.frame().x(x), terrain.frame().y(y)));
  return terrain;
}

TEST(RaisePits, OnItsOwnCellsNothingIsLeftToFill) {
  for (const uint64_t seed : {1U, 2U, 3U}) {
    for (const auto& [w, h] : {std::pair{97, 61}, {40, 130}, {3, 3}, {1, 7}}) {
      const HeightField before = noise(w, h, seed);
      HeightField terrain = before;
      raise_pits(terrain, 0.0F, 0.001, 200, {}, {});
      const HeightField filled = fill_depressions(terrain, 0.0F, {});
      for (size_t c = 0; c < terrain.size(); ++c) {
        ASSERT_GE(terrain.cells()[c], before.cells()[c]);
        ASSERT_TRUE(before.cells()[c] > 0.0F || terrain.cells()[c] == before.cells()[c]);
        ASSERT_NEAR(filled.cells()[c], terrain.cells()[c], 0.01) << seed << " " << w << "x" << h;
      }
    }
  }
}

TEST(RaisePits, OnACoarseLatticeWhatIsLeftIsShallow) {
  for (const uint64_t seed : {4U, 5U, 6U}) {
    HeightField terrain = noise(160, 160, seed, 1);
    for (float& z : terrain.cells()) z += 250.0F;
    const auto volume = [](const HeightField& z) {
      const HeightField filled = fill_depressions(z, 0.0F, {});
      double sum = 0;
      for (size_t c = 0; c < z.size(); ++c) sum += static_cast<double>(filled.cells()[c] - z.cells()[c]);
      return sum;
    };
    const double before = volume(terrain);
    raise_pits(terrain, 0.0F, 0.01, 80, {}, {});
    EXPECT_LT(volume(terrain), 0.35 * before) << seed;
  }
}

}  // namespace
}  // namespace seamount::geom
