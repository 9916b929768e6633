#include "seamount/ops/glacier/run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "seamount/geom/grid/resample.h"
#include "seamount/geom/scalar/noise.h"

namespace seamount::glacier {
namespace {

/// A valley of V section that falls from the north, with a headwall, to a plain in the south.
HeightField valley(int width, int height, double cell) {
  HeightField z(GridFrame::centred(width, height, cell));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double north = z.frame().y(y) / z.frame().height_m();  // from -1/2 to 1/2
      const double floor = north > 0.4 ? 2000 - 12000 * (north - 0.4) : 900 + 1100 * (north + 0.5) / 0.9;
      const double side = 0.6 * std::abs(z.frame().x(x)), crest = 0.3 * z.frame().width_m();
      z(x, y) = static_cast<float>(floor + std::min(side, 1.2 * crest - side));
    }
  }
  return z;
}

HeightField hills(int width, int height, uint64_t seed) {
  const GridFrame frame = GridFrame::centred(width, height, 12000.0 / width);
  HeightField z = geom::fbm_grid(frame, Seed{seed}, {.wavelength_m = 6000, .octaves = 8, .cell_m = frame.cell_m}, {});
  for (float& value : z.cells()) value = 1500 + 1200 * value;
  return z;
}

/// Exponent of a section: height over the floor ~ distance^b, fitted from 60 to 400 m.
double exponent(const HeightField& z, int row) {
  const auto line = z.row(row);
  const auto floor = std::min_element(line.begin() + z.width() / 4, line.begin() + 3 * z.width() / 4);
  const double middle = static_cast<double>(floor - line.begin());
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (int x = 0; x < z.width(); ++x) {
    const double distance = std::abs(x - middle) * z.cell_m(), over = z(x, row) - *floor;
    if (distance < 60 || distance > 400 || over <= 0.1) continue;
    const double a = std::log(distance), b = std::log(over);
    n += 1, sx += a, sy += b, sxx += a * a, sxy += a * b;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

TEST(Glacier, ValleysOfRiversBecomeTroughs) {
  const HeightField start = valley(151, 300, 30);
  const Carved carved = run(start, {}, {.years = 100000, .ela_m = 1200}, {});
  double before = 0, after = 0, count = 0;
  for (int y = 100; y < 280; y += 5) {
    before += exponent(start, y);
    after += exponent(carved.terrain, y);
    count += 1;
  }
  EXPECT_NEAR(before / count, 1.0, 0.1);
  EXPECT_GT(after / count, 1.5);
  EXPECT_LT(after / count, 3.0);
}

TEST(Glacier, CarvesWhereIceHasBeenAndNowhereElse) {
  const HeightField start = hills(200, 180, 1);
  const Carved carved = run(start, {}, {.years = 50000, .ela_m = 1500}, {});
  double all = 0;
  for (size_t i = 0; i < start.size(); ++i) {
    ASSERT_GE(carved.worn.data()[i], 0.0F);
    ASSERT_GE(carved.ice.data()[i], 0.0F);
    ASSERT_EQ(carved.worn.data()[i], start.data()[i] - carved.terrain.data()[i]);
    ASSERT_GE(carved.surface.data()[i], carved.terrain.data()[i]);
    if (start.data()[i] < 700) {
      ASSERT_EQ(carved.worn.data()[i], 0.0F);
    }
    all += carved.worn.data()[i];
  }
  EXPECT_GT(all / static_cast<double>(start.size()), 10);
}

TEST(Glacier, NoSnowNoCarving) {
  const HeightField start = hills(150, 140, 2);
  std::string said;
  const Carved carved = run(start, {}, {.ela_m = 5000}, {.note = [&](const std::string& line) { said = line; }});
  EXPECT_EQ(said, "no ground lies over the equilibrium line, ela_m: there is no ice");
  EXPECT_TRUE(carved.terrain == start);
  EXPECT_TRUE(carved.surface == start);
}

TEST(Glacier, ZeroYearsShowTheIceOfToday) {
  const HeightField start = hills(150, 140, 2);
  std::string said;
  const Carved carved =
      run(start, {}, {.years = 0, .ela_m = 1000}, {.note = [&](const std::string& line) { said = line; }});
  EXPECT_TRUE(carved.terrain == start);
  EXPECT_EQ(said, "ice reaches the border and leaves the map there");
  EXPECT_GT(*std::max_element(carved.ice.cells().begin(), carved.ice.cells().end()), 30);
}

TEST(Glacier, HardRockIsCarvedLess) {
  const HeightField start = hills(128, 128, 3);
  const auto worn = [&](float hardness) {
    const Carved carved = run(start, ScalarField(start.frame(), hardness), {.years = 20000, .ela_m = 1500}, {});
    return std::accumulate(carved.worn.cells().begin(), carved.worn.cells().end(), 0.0);
  };
  EXPECT_GT(worn(1), 2.5 * worn(10));
}

TEST(Glacier, AnyNumberOfThreadsMakesTheSameBytes) {
  const HeightField start = hills(280, 260, 4);
  const RunParams params{.years = 30000, .ela_m = 1500};
  const Carved one = run(start, {}, params, {.threads = 1}), more = run(start, {}, params, {.threads = 5});
  EXPECT_TRUE(one.terrain == more.terrain);
  EXPECT_TRUE(one.surface == more.surface);
}

TEST(Glacier, ACoarseGridIsAPreviewOfAFineOne) {
  const RunParams params{.years = 50000, .ela_m = 1500};
  const Carved coarse = run(hills(96, 96, 5), {}, params, {}), fine = run(hills(384, 384, 5), {}, params, {});
  const Grid<float> mean = geom::box_downsample(fine.worn, 4, {});
  double apart = 0, all = 0;
  for (size_t i = 0; i < mean.size(); ++i) {
    apart += std::abs(mean.data()[i] - coarse.worn.data()[i]);
    all += mean.data()[i];
  }
  EXPECT_LT(apart, 0.5 * all);
}

TEST(Glacier, OddShapesAndTheEndsOfEveryRange) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 9}, {2, 7}, {3, 3}, {5, 300}}) {
    const Carved carved = run(hills(width, height, 1), {}, {}, {});
    for (const float z : carved.terrain.cells()) ASSERT_TRUE(std::isfinite(z));
  }
  const HeightField start = hills(70, 66, 1);
  for (const RunParams& params :
       {RunParams{.years = 1e7, .ela_m = -12000, .balance_gradient_m_yr_km = 50, .max_accumulation_m_yr = 20},
        RunParams{.abrasion = 0.01, .widening_m = 5000, .wall_angle_deg = 10},
        RunParams{.ela_m = 1500, .widening_m = 0, .wall_angle_deg = 89}}) {
    const Carved carved = run(start, {}, params, {});
    for (const HeightField* z : {&carved.terrain, &carved.surface}) {
      for (const float value : z->cells()) ASSERT_TRUE(std::isfinite(value));
    }
  }
  EXPECT_THROW(run(start, {}, {.years = -1}, {}), InvalidArgument);
  EXPECT_THROW(run(start, ScalarField(GridFrame::centred(3, 3, 1), 1.0F), {}, {}), IncompatibleInputs);
}

}  // namespace
}  // namespace seamount::glacier
