// The laws of smooth reconstruction beside the plain interpolation, on ground with plains, terraces and saddles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "seamount/base/rng.h"
#include "seamount/geom/contour/faces.h"
#include "seamount/geom/contour/nesting.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/solve/drain.h"
#include "seamount/ops/contour/convert/extract.h"
#include "seamount/ops/contour/convert/reconstruct.h"

namespace seamount::contour {
namespace {

constexpr double kInterval = 50.0;

/// Steep slopes between wide terraces and plains, cut by valleys.
HeightField terraces(uint64_t seed, int size, double cell_m) {
  const geom::Fbm shape{.wavelength_m = 0.5 * size * cell_m, .octaves = 6, .gain = 0.5, .cell_m = 2.0 * cell_m};
  HeightField z = geom::fbm_grid(GridFrame::centred(size, size, cell_m), Seed{seed}, shape, {});
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const double plain = 300.0 + 350.0 * static_cast<double>(z(x, y)) + 0.1 * x;
      const double step = 120.0;
      const double within = plain / step - std::floor(plain / step);
      z(x, y) = static_cast<float>(step * (std::floor(plain / step) + std::pow(within, 6.0)) + 0.05 * plain);
    }
  }
  return z;
}

ContourSet contours_of(const HeightField& z) {
  ExtractParams params;
  params.interval_m = kInterval;
  return extract(z, params, {});
}

ContourSet shaken(const ContourSet& set, double by_m, uint64_t seed) {
  ContourSet moved = set;
  Rng rng(Seed{seed}.derive("shake"));
  for (Contour& contour : moved.contours)
    for (Vec2& p : contour.ring) p = p + Vec2{rng.uniform(-by_m, by_m), rng.uniform(-by_m, by_m)};
  return moved;
}

/// How far below the lower of the two cells `reach` away, on opposite sides, in the direction where that is most.
float trench(const HeightField& z, int x, int y, int reach) {
  float deepest = 0.0F;
  for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {1, 1}, {1, -1}}) {
    if (!z.contains(x + reach * dx, y + reach * dy) || !z.contains(x - reach * dx, y - reach * dy)) continue;
    if (!z.contains(x + reach * dx, y - reach * dy) || !z.contains(x - reach * dx, y + reach * dy)) continue;
    deepest =
        std::max(deepest, std::min(z(x + reach * dx, y + reach * dy), z(x - reach * dx, y - reach * dy)) - z(x, y));
  }
  return deepest;
}

TEST(ContourReconstructSmooth, LiesBesideThePlainInterpolation) {
  for (const uint64_t seed : {1U, 2U, 3U, 4U}) {
    for (const double cell : {20.0, 45.0}) {
      const HeightField real = terraces(seed, 200, cell);
      const ContourSet set = contours_of(real);
      const HeightField smooth = reconstruct(set, {}, {});
      const HeightField plain = reconstruct(set, {.method = Method::interpolated}, {});
      int64_t lower = 0, higher = 0, trenches = 0;
      for (int y = 0; y < real.height(); ++y) {
        for (int x = 0; x < real.width(); ++x) {
          lower += smooth(x, y) < plain(x, y) - 0.5 * kInterval;
          higher += smooth(x, y) > plain(x, y) + 0.6 * kInterval;
          trenches += trench(smooth, x, y, 2) > 0.5 * kInterval && trench(plain, x, y, 2) < 0.1 * kInterval &&
                      trench(real, x, y, 2) < 0.1 * kInterval;
        }
      }
      EXPECT_LE(lower, 8) << seed << " " << cell;
      EXPECT_LE(higher, 8) << seed << " " << cell;
      EXPECT_LE(trenches, 8) << seed << " " << cell;
    }
  }
}

TEST(ContourReconstructSmooth, LittleNoiseChangesLittle) {
  for (const uint64_t seed : {1U, 2U, 3U}) {
    const ContourSet set = contours_of(terraces(seed, 160, 30.0));
    const HeightField smooth = reconstruct(set, {}, {});
    for (const auto& [by_m, most_m] : {std::pair{1e-6, 0.5}, {1e-4, 1.0}, {1e-3, 1.0}}) {
      const ContourSet moved = shaken(set, by_m, seed);
      if (geom::find_contour_crossing(moved.contours)) continue;
      const HeightField again = reconstruct(moved, {}, {});
      float most = 0.0F;
      for (size_t i = 0; i < smooth.size(); ++i) most = std::max(most, std::abs(smooth.cells()[i] - again.cells()[i]));
      EXPECT_LT(most, most_m) << seed << ", noise " << by_m;
    }
  }
}

/// A mountain whose foot is a sharp break of slope: one in two above, one in `gentle` below.
HeightField broken_slope(double gentle, double cell_m) {
  const int size = static_cast<int>(12000.0 / cell_m);
  HeightField z(GridFrame::centred(size, size, cell_m));
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const double r = std::hypot(z.frame().x(x), z.frame().y(y));
      z(x, y) = static_cast<float>(r < 1500.0 ? 1000.0 - 0.5 * r : 250.0 - (r - 1500.0) / gentle);
    }
  return z;
}

TEST(ContourReconstructSmooth, NoTerraceRunsAlongTheFootOfARange) {
  for (const double gentle : {6.0, 12.0, 20.0}) {
    for (const double cell_m : {15.0, 30.0}) {
      const HeightField land = broken_slope(gentle, cell_m);
      const HeightField z = reconstruct(contours_of(land), {}, {});
      // Down the fall line through the first two bands below the foot: never nearly level.
      const int row = z.height() / 2;
      const auto column = [&](double r) { return static_cast<int>(z.frame().column(r)); };
      const int last = column(1500.0 + 1.6 * kInterval * gentle),
                step = static_cast<int>(0.2 * kInterval * gentle / cell_m);
      for (int x = column(1520.0); x + step < last; ++x) {
        const double slope = static_cast<double>(z(x, row) - z(x + step, row)) / (step * cell_m);
        EXPECT_GT(slope, 0.35 / gentle) << gentle << " " << cell_m << " at " << z.frame().x(x);
      }
    }
  }
}

}  // namespace
}  // namespace seamount::contour
