#include "seamount/ops/erosion/fade.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "seamount/geom/scalar/noise.h"
#include "seamount/ops/erosion/run.h"

namespace seamount::erosion {
namespace {

HeightField hills(uint64_t seed, int size) {
  const GridFrame frame = GridFrame::centred(size, size, 6400.0 / size);
  HeightField z = geom::fbm_grid(frame, Seed{seed}, {.wavelength_m = 3000, .octaves = 8, .cell_m = frame.cell_m}, {});
  for (float& value : z.cells()) value = static_cast<float>(500 + 700 * value);
  return z;
}

/// A disc, 1 within, falling to 0 over `soft_m`.
Mask disc(const GridFrame& frame, double radius_m, double soft_m, bool inverted = false) {
  Mask mask(frame);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const double beyond = std::hypot(frame.x(x), frame.y(y)) - radius_m;
      const double share = soft_m > 0 ? std::clamp(1 - beyond / soft_m, 0.0, 1.0) : beyond < 0 ? 1.0 : 0.0;
      mask(x, y) = static_cast<float>(inverted ? 1 - share : share);
    }
  }
  return mask;
}

/// Slopes of the cells around which the mask changes, or lies within 500 m of its change; steepest last.
std::vector<double> slopes_along(const Mask& mask, const HeightField& z, double radius_m, double soft_m) {
  std::vector<double> slopes;
  for (int y = 1; y + 1 < z.height(); ++y) {
    for (int x = 1; x + 1 < z.width(); ++x) {
      const double beyond = std::hypot(mask.frame().x(x), mask.frame().y(y)) - radius_m;
      if (beyond < -500 || beyond > soft_m + 500) continue;
      slopes.push_back(std::hypot(z(x + 1, y) - z(x, y), z(x, y + 1) - z(x, y)) / z.cell_m());
    }
  }
  std::sort(slopes.begin(), slopes.end());
  return slopes;
}

double quantile(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<size_t>(share * static_cast<double>(sorted.size() - 1))];
}

Eroded eroded(const HeightField& start, const Mask& mask, const RunParams& params = {}) {
  return run({start, {}, {}}, {.hardness = {}, .mask = mask, .uplift = {}, .rain = {}}, params, Seed{5}, {});
}

/// Nothing along the edge is steeper than what is there without a mask, before or after, by more than a tenth.
void expect_no_cliff(const HeightField& start, const HeightField& open, double radius_m, double soft_m, bool inverted) {
  const Mask mask = disc(start.frame(), radius_m, soft_m, inverted);
  const auto with = slopes_along(mask, eroded(start, mask).terrain, radius_m, soft_m);
  const auto without = slopes_along(mask, open, radius_m, soft_m);
  const auto before = slopes_along(mask, start, radius_m, soft_m);
  for (const double share : {0.9, 0.99, 1.0}) {
    const double most = std::max(quantile(without, share), quantile(before, share));
    EXPECT_LE(quantile(with, share), 1.1 * most) << soft_m << " " << inverted << " " << share;
  }
}

TEST(ErosionMask, LeavesNoCliffAlongItsEdge) {
  for (const uint64_t seed : {1, 2, 3}) {
    const HeightField start = hills(seed, 100);
    const HeightField open = eroded(start, {}).terrain;
    for (const double soft_m : {0.0, 400.0})
      for (const bool inverted : {false, true}) expect_no_cliff(start, open, 1800, soft_m, inverted);
  }
}

TEST(ErosionMask, LeavesNoCliffOnASmoothDome) {
  HeightField start(GridFrame::centred(128, 128, 50));
  for (int y = 0; y < start.height(); ++y)
    for (int x = 0; x < start.width(); ++x)
      start(x, y) = static_cast<float>(900 - 0.3 * std::hypot(start.frame().x(x), start.frame().y(y)));
  const HeightField open = eroded(start, {}).terrain;
  for (const double soft_m : {0.0, 400.0})
    for (const bool inverted : {false, true}) expect_no_cliff(start, open, 1500, soft_m, inverted);
}

TEST(ErosionMask, KeepsItsShareOfTheChange) {
  const HeightField start = hills(4, 150);
  const Eroded open = eroded(start, {});
  const Eroded half = eroded(start, Mask(start.frame(), 0.25F)), all = eroded(start, Mask(start.frame(), 1.0F));
  double change = 0, kept = 0;
  for (size_t i = 0; i < start.size(); ++i) {
    change += std::abs(open.terrain.data()[i] - start.data()[i]);
    kept += std::abs(half.terrain.data()[i] - start.data()[i]);
  }
  EXPECT_NEAR(kept / change, 0.25, 0.01);
  EXPECT_TRUE(all.terrain == open.terrain);
  EXPECT_TRUE(all.flow == open.flow);
}

TEST(ErosionMask, ConservesMassAndLeavesWhatItCovers) {
  for (const double uplift_mm_yr : {0.0, 0.5}) {
    const HeightField start = hills(6, 131);
    const Mask mask = disc(start.frame(), 1500, 700, uplift_mm_yr > 0);
    const Eroded made = eroded(start, mask, {.uplift_mm_yr = uplift_mm_yr});
    double lost = 0;
    for (size_t i = 0; i < start.size(); ++i) {
      lost += start.data()[i] - made.terrain.data()[i];
      if (mask.data()[i] == 0.0F) {
        ASSERT_EQ(made.terrain.data()[i], start.data()[i]);
      }
      ASSERT_GE(made.debris.data()[i], 0.0F);
      ASSERT_GE(made.sediment.data()[i], 0.0F);
    }
    lost *= start.cell_m() * start.cell_m();
    EXPECT_NEAR(lost, made.ledger.exported - made.ledger.uplifted, 1e-4 * made.ledger.eroded);
  }
}

TEST(ErosionMask, FadesAsFastAsTheChangeAllows) {
  const GridFrame frame = GridFrame::centred(200, 40, 10);
  const HeightField before(frame, 500.0F);
  HeightField after = before;
  Mask mask(frame, 0.0F);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 60; x < frame.width; ++x) {
      after(x, y) = 470.0F;
      mask(x, y) = 1.0F;
    }
  }
  const Mask share = faded(mask, before, after, {});
  for (int x = 0; x < frame.width; ++x) {
    const double expected = std::clamp(slope_of_fade(after) * 10 * (x - 59) / 30.0, 0.0, 1.0);
    EXPECT_NEAR(share(x, 17), expected, 1e-5) << x;
  }
}

}  // namespace
}  // namespace seamount::erosion
