#include "seamount/ops/terrain/blend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "seamount/geom/scalar/blend.h"
#include "seamount/geom/scalar/noise.h"

namespace seamount::terrain {
namespace {

HeightField hills(uint64_t seed, int width = 61, int height = 43) {
  HeightField terrain = geom::fbm_grid(GridFrame::centred(width, height, 20.0), Seed{seed}, {.wavelength_m = 700}, {});
  for (float& z : terrain.cells()) z *= 250.0F;
  return terrain;
}

const BlendMode kModes[] = {BlendMode::mix, BlendMode::max, BlendMode::min, BlendMode::add, BlendMode::subtract};

TEST(Blend, IsItsFormulaOnEveryCell) {
  const HeightField a = hills(1), b = hills(2);
  Mask mask(a.frame());
  for (size_t i = 0; i < mask.size(); ++i) mask.cells()[i] = static_cast<float>(i % 7) / 5.0F - 0.1F;
  for (const BlendMode mode : kModes) {
    for (const double smooth : {0.0, 12.0}) {
      const HeightField out = blend(a, b, &mask, {.mode = mode, .strength = 0.8, .smooth_m = smooth}, {});
      for (size_t i = 0; i < a.size(); ++i) {
        const double p = a.cells()[i], q = b.cells()[i];
        const double k = 0.5 / smooth;
        const double done = mode == BlendMode::mix   ? q
                            : mode == BlendMode::add ? p + q
                            : mode == BlendMode::subtract
                                ? p - q
                                : (mode == BlendMode::max ? (smooth > 0 ? geom::smax(p, q, k) : std::max(p, q))
                                                          : (smooth > 0 ? geom::smin(p, q, k) : std::min(p, q)));
        const double w = 0.8 * std::clamp(static_cast<double>(mask.cells()[i]), 0.0, 1.0);
        ASSERT_NEAR(out.cells()[i], p + w * (done - p), 2e-3);
      }
    }
  }
}

TEST(Blend, AWeightOfZeroLeavesTheFirstAndOfOneGivesTheWhole) {
  const HeightField a = hills(1), b = hills(2);
  const Mask none(a.frame(), 0.0F), all(a.frame(), 1.0F);
  for (const BlendMode mode : kModes) {
    EXPECT_EQ(blend(a, b, nullptr, {.mode = mode, .strength = 0}, {}), a);
    EXPECT_EQ(blend(a, b, &none, {.mode = mode, .strength = 1}, {}), a);
    EXPECT_EQ(blend(a, b, &all, {.mode = mode, .strength = 1}, {}),
              blend(a, b, nullptr, {.mode = mode, .strength = 1}, {}));
  }
  EXPECT_EQ(blend(a, b, nullptr, {.strength = 1}, {}), b);
}

TEST(Blend, SmoothMaximumNeverLiesBelowEither) {
  const HeightField a = hills(1), b = hills(2);
  const HeightField out = blend(a, b, nullptr, {.mode = BlendMode::max, .strength = 1, .smooth_m = 20}, {});
  for (size_t i = 0; i < a.size(); ++i) {
    ASSERT_GE(out.cells()[i], std::max(a.cells()[i], b.cells()[i]) - 1e-3F);
    ASSERT_LE(out.cells()[i], std::max(a.cells()[i], b.cells()[i]) + 20.01F);
  }
}

TEST(Blend, SubtractingWhatWasAddedIsNothing) {
  const HeightField a = hills(1), b = hills(2);
  const HeightField there = blend(a, b, nullptr, {.mode = BlendMode::add, .strength = 0.5}, {});
  const HeightField back = blend(there, b, nullptr, {.mode = BlendMode::subtract, .strength = 0.5}, {});
  for (size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(back.cells()[i], a.cells()[i], 1e-3);
}

TEST(Blend, RefusesWhatDoesNotFitAndSaysWhatHelps) {
  const HeightField a = hills(1);
  try {
    blend(a, hills(2, 60), nullptr, {}, {});
    FAIL();
  } catch (const IncompatibleInputs& error) {
    EXPECT_STREQ(
        error.what(),
        "with: 60 x 43 cells do not match the first terrain's 61 x 43; terrain.resample brings terrains to one "
        "size");
  }
  HeightField finer = hills(2);
  GridFrame frame = finer.frame();
  frame.cell_m = 10.0;
  finer.set_frame(frame);
  EXPECT_THROW(blend(a, finer, nullptr, {}, {}), IncompatibleInputs);
  const Mask small(GridFrame::centred(3, 3, 20.0), 1.0F);
  EXPECT_THROW(blend(a, hills(2), &small, {}, {}), IncompatibleInputs);
}

/// Where one of the two is not known the other stands, as far as the mask lets it; sums need both.
TEST(Blend, UnknownCellsTakeWhatIsKnown) {
  const GridFrame frame = GridFrame::centred(4, 1, 10.0);
  const float none = std::numeric_limits<float>::quiet_NaN();
  HeightField a(frame), b(frame);
  const std::array<float, 4> of_a = {1, none, 3, none}, of_b = {10, 20, none, none};
  std::copy(of_a.begin(), of_a.end(), a.cells().begin());
  std::copy(of_b.begin(), of_b.end(), b.cells().begin());
  for (const BlendMode mode : {BlendMode::mix, BlendMode::max, BlendMode::min}) {
    for (const double smooth : {0.0, 5.0}) {
      const HeightField out = blend(a, b, nullptr, {.mode = mode, .smooth_m = smooth}, {});
      EXPECT_EQ(out(1, 0), 20.0F);
      EXPECT_EQ(out(2, 0), 3.0F);
      EXPECT_TRUE(std::isnan(out(3, 0)));
    }
  }
  const HeightField sum = blend(a, b, nullptr, {.mode = BlendMode::add}, {});
  EXPECT_EQ(sum(0, 0), 11.0F);
  EXPECT_TRUE(std::isnan(sum(1, 0)) && std::isnan(sum(2, 0)));
  const Mask nowhere(frame, 0.0F);
  const HeightField kept = blend(a, b, &nowhere, {}, {});
  EXPECT_TRUE(std::isnan(kept(1, 0)));
  EXPECT_EQ(kept(2, 0), 3.0F);
}

}  // namespace
}  // namespace seamount::terrain
