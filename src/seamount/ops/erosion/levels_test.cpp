#include "seamount/ops/erosion/levels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "seamount/geom/scalar/noise.h"

namespace seamount::erosion {
namespace {

Layers hills(int size) {
  const GridFrame frame = GridFrame::centred(size, size, 20);
  HeightField z = geom::fbm_grid(frame, Seed{3}, {.wavelength_m = 600, .octaves = 6, .cell_m = 20}, {});
  for (float& value : z.cells()) value = 400 + 300 * value;
  return {std::move(z), ScalarField(frame, 2.0F), ScalarField(frame, 1.0F)};
}

double sum(const ScalarField& field) { return std::accumulate(field.cells().begin(), field.cells().end(), 0.0); }

TEST(Levels, WhereNothingChangedNothingIsBent) {
  const Layers start = hills(64), coarse = halved(start, {});
  Layers fine = start;
  Ledger ledger;
  refine(coarse, coarse, fine, {}, Grid<uint8_t>(start.frame(), 0), Seed{1}, ledger, {});
  EXPECT_EQ(fine.surface, start.surface);
  EXPECT_EQ(fine.debris, start.debris);
  EXPECT_EQ(ledger.exported, 0.0);
}

TEST(Levels, TheVolumeOfAChangeIsKeptAndMasksAndOutletsHold) {
  const Layers start = hills(64), coarse = halved(start, {});
  Layers now = coarse, fine = start;
  for (int y = 8; y < 24; ++y) {
    for (int x = 8; x < 24; ++x)
      now.surface(x, y) -= static_cast<float>(60 + 30 * std::sin(0.7 * x) * std::cos(0.9 * y));
  }
  Maps site;
  site.mask = Mask(start.frame(), 1.0F);
  for (int x = 0; x < 64; ++x) site.mask(x, 4) = 0.0F;
  Grid<uint8_t> pinned(start.frame(), 0);
  pinned(20, 20) = 1;
  Ledger ledger;
  refine(now, coarse, fine, site, pinned, Seed{1}, ledger, {});
  const double change = 4.0 * (sum(now.surface) - sum(coarse.surface));
  EXPECT_NEAR(sum(fine.surface) - sum(start.surface), change, 1e-4 * std::abs(change));
  EXPECT_NEAR(ledger.exported, (change - (sum(fine.surface) - sum(start.surface))) * 400.0,
              1e-4 * std::abs(change) * 400.0);
  EXPECT_EQ(fine.surface(20, 20), start.surface(20, 20));
  for (int x = 0; x < 64; ++x) EXPECT_EQ(fine.surface(x, 4), start.surface(x, 4));
  Layers other = start;
  refine(now, coarse, other, site, pinned, Seed{2}, ledger, {});
  EXPECT_FALSE(other.surface == fine.surface);
}

}  // namespace
}  // namespace seamount::erosion
