#include "seamount/ops/erosion/balance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "seamount/geom/scalar/noise.h"

namespace seamount::erosion {
namespace {

HeightField hills(double base_m) {
  const GridFrame frame = GridFrame::centred(131, 96, 40);
  HeightField z = geom::fbm_grid(frame, Seed{3}, {.wavelength_m = 2500, .octaves = 8, .cell_m = frame.cell_m}, {});
  for (float& value : z.cells()) value = static_cast<float>(base_m + 500 * value);
  return z;
}

TEST(ErosionBalance, VolumesOfCellsWithKnownLayers) {
  const GridFrame frame = GridFrame::centred(2, 1, 10);  // 100 m2 a cell
  HeightField start(frame, 10.0F);
  const ScalarField sediment(frame, 1.0F);
  Eroded after{start, ScalarField(frame, 0.0F), sediment, ScalarField(frame, 0.0F), ScalarField(frame, 0.0F), {}};
  after.terrain(0, 0) = 4.0F;  // dry: 1 m of sediment and 5 m of bedrock are gone
  after.sediment(0, 0) = 0.0F;
  after.terrain(1, 0) = 12.0F;  // under a lake: 2 m of debris came to lie there
  after.debris(1, 0) = 2.0F;
  after.lake(1, 0) = 0.5F;
  after.ledger.exported = 390;
  const Balance found = balance({start, nullptr, &sediment}, after, {});
  EXPECT_DOUBLE_EQ(found.worn, 500);
  EXPECT_DOUBLE_EQ(found.on_land, -100);
  EXPECT_DOUBLE_EQ(found.under_water, 200);
  EXPECT_DOUBLE_EQ(found.exported, 390);
  EXPECT_DOUBLE_EQ(found.error, 10);
}

TEST(ErosionBalance, ClosesToTenThousandthOfWhatWasPickedUp) {
  for (const double base_m : {400.0, 20.0}) {
    for (const double uplift_mm_yr : {0.0, 0.5}) {
      for (const Method method : {Method::hydraulic, Method::stream_power}) {
        const HeightField start = hills(base_m);
        const RunParams params{.method = method, .uplift_mm_yr = uplift_mm_yr};
        const Eroded after = run({start, {}, {}}, {}, params, Seed{11}, {});
        const Balance found = balance({start}, after, params);
        EXPECT_GT(found.worn, 0);
        EXPECT_GT(found.picked_up, 0);
        EXPECT_LT(std::abs(found.error), 1e-4 * found.picked_up) << base_m << " " << uplift_mm_yr;
        EXPECT_NEAR(found.worn, found.on_land + found.under_water + found.exported + found.error, 1e-9 * found.worn);
      }
    }
  }
}

TEST(ErosionBalance, NothingMovesInNoTime) {
  const HeightField start = hills(20.0);
  const Eroded after = run({start, {}, {}}, {}, {.years = 0}, Seed{1}, {});
  const Report report = balance_report({start}, after, {.years = 0});
  ASSERT_EQ(report.descriptors.size(), 1U);
  for (const Measure& measure : report.descriptors[0].measures) EXPECT_EQ(measure.values.at(0), 0.0) << measure.name;
}

TEST(ErosionBalance, HistogramCountsEveryCellOnce) {
  const HeightField start = hills(100.0);
  const Eroded after = run({start, {}, {}}, {}, {.years = 20000}, Seed{1}, {});
  const Report report = balance_report({start}, after, {.years = 20000});
  double sum = 0;
  for (const double share : report.descriptors[0].plot.lines.at(0).y) sum += share;
  EXPECT_NEAR(sum, 1.0, 1e-9);
}

}  // namespace
}  // namespace seamount::erosion
