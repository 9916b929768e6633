// Runs of erosion on beds: mesas, cuestas, benches.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "seamount/geom/grid/resample.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/ops/erosion/run.h"

namespace seamount::erosion {
namespace {

/// A plateau of about 500 m, cut by a gorge from west to east.
HeightField plateau(int width, int height, uint64_t seed, double domain_m = 6400) {
  const GridFrame frame = GridFrame::centred(width, height, domain_m / width);
  const geom::Fbm shape{.wavelength_m = 2500, .octaves = 8, .cell_m = frame.cell_m};
  HeightField z = geom::fbm_grid(frame, Seed{seed}, shape, {});
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double across = (frame.y(y) - 400 * std::sin(frame.x(x) / 900)) / 250;
      z(x, y) = static_cast<float>(500 + 20 * z(x, y) - 400 * std::exp(-across * across));
    }
  }
  return z;
}

RunParams with_beds(LithologyParams lithology) {
  RunParams params{.years = 60000,
                   .erodibility = 1e-5,
                   .hardness_variation = 0,
                   .sea_m = -1000,
                   .slopes = {.creep_m2_yr = 0.001, .weathering_mm_yr = 0.02}};
  params.lithology = std::move(lithology);
  return params;
}

const std::vector<BedParams> kCapAndShale = {{"cap", 60, 8}, {"shale", 600, 0.3}};

Eroded eroded(const HeightField& start, const RunParams& params, int threads = 0) {
  return run({start, {}, {}}, {}, params, Seed{11}, {.threads = threads});
}

TEST(LayeredRock, KeepsMassAndBytes) {
  const HeightField start = plateau(140, 131, 1);
  RunParams params = with_beds({.beds = kCapAndShale,
                                .top_m = 510,
                                .dip_deg = 4,
                                .strike_deg = 40,
                                .fold_height_m = 60,
                                .thickness_variation = 0.3,
                                .faults = {{{{0, 0}, {300, 1000}}, 60, 80}}});
  params.uplift_mm_yr = 0.4;
  const Eroded one = eroded(start, params, 1), more = eroded(start, params, 5);
  EXPECT_TRUE(one.terrain == more.terrain);
  EXPECT_TRUE(one.bed == more.bed);
  double lost = 0;
  for (size_t i = 0; i < start.size(); ++i) lost += start.data()[i] - one.terrain.data()[i];
  lost *= start.cell_m() * start.cell_m();
  EXPECT_GT(one.ledger.eroded, 0);
  EXPECT_NEAR(lost, one.ledger.exported - one.ledger.uplifted, 1e-4 * one.ledger.eroded);
  for (const float bed : one.bed.cells()) ASSERT_TRUE(bed == 1.0F || bed == 2.0F);
}

TEST(LayeredRock, WithoutBedsThereIsNone) {
  const Eroded worn = eroded(plateau(70, 66, 1), with_beds({}));
  for (const float bed : worn.bed.cells()) ASSERT_EQ(bed, 0.0F);
}

TEST(LayeredRock, ThickBedsAreAsAMapOfTheirHardness) {
  const HeightField start = plateau(128, 128, 2);
  RunParams params = with_beds({.beds = {{"", 10000, 3}}, .repeat = false});
  params.slopes.bedrock_angle_deg = 80;
  const Eroded beds = eroded(start, params);
  params.lithology = {};
  Maps site;
  site.hardness = ScalarField(start.frame(), 3.0F);
  const Eroded map = run({start, {}, {}}, site, params, Seed{11}, {});
  double apart = 0, moved = 0;
  for (size_t i = 0; i < start.size(); ++i) {
    apart += std::abs(beds.terrain.data()[i] - map.terrain.data()[i]);
    moved += std::abs(map.terrain.data()[i] - start.data()[i]);
  }
  EXPECT_LT(apart, 0.01 * moved);
}

/// Share of the land within so many metres of a height.
double share_near(const HeightField& z, float height, float within) {
  const auto near = [&](float here) { return std::abs(here - height) < within; };
  return static_cast<double>(std::count_if(z.cells().begin(), z.cells().end(), near)) / static_cast<double>(z.size());
}

TEST(LayeredRock, ACapLeavesMesas) {
  // Hills of marl on a cap, by a gorge: rivers strip the marl down to the cap, or down to where the cap would end.
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    HeightField start = plateau(160, 160, seed);
    for (float& z : start.cells()) z += 40 + 2 * std::max(0.0F, z - 490);
    const auto at_cap = [&](std::vector<BedParams> beds) {
      RunParams params = with_beds({.beds = std::move(beds), .repeat = false, .top_m = 540});
      params.years = 200000;
      return share_near(eroded(start, params).terrain, 490, 10);
    };
    const double with = at_cap({{"marl", 50, 0.03}, {"cap", 60, 20}, {"shale", 600, 1}});
    const double without = at_cap({{"marl", 50, 0.03}, {"marl", 60, 0.03}, {"shale", 600, 1}});
    EXPECT_GT(with, 2.5 * without) << seed;
    EXPECT_GT(with, 0.15) << seed;
  }
}

TEST(LayeredRock, CliffsStandAndSoftBedsLieBack) {
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    const Eroded worn =
        eroded(plateau(320, 320, seed, 4800), with_beds({.beds = {{"", 60, 6}, {"", 60, 0.25}}, .top_m = 500}));
    std::array<double, 3> steepest = {};
    std::array<std::vector<double>, 3> slopes;
    for (int y = 1; y < 319; ++y) {
      for (int x = 1; x < 319; ++x) {
        const HeightField& z = worn.terrain;
        const double slope = std::hypot(z(x + 1, y) - z(x - 1, y), z(x, y + 1) - z(x, y - 1)) / (2 * z.cell_m());
        slopes[static_cast<size_t>(worn.bed(x, y))].push_back(slope);
      }
    }
    for (const auto& [bed, share] : {std::pair{size_t{1}, 0.97}, {size_t{2}, 0.9}}) {  // much of a hard bed is its top
      const auto nth = slopes[bed].begin() + static_cast<ptrdiff_t>(share * static_cast<double>(slopes[bed].size()));
      std::nth_element(slopes[bed].begin(), nth, slopes[bed].end());
      steepest[bed] = std::atan(*nth) * 180 / std::numbers::pi;
    }
    EXPECT_GT(steepest[1], 45) << seed;  // sandstone stands at 60 to 90 degrees, a cell's mean is less
    EXPECT_LT(steepest[2], 36) << seed;  // shale 20 to 35
  }
}

TEST(LayeredRock, DipSlopesFaceDownDip) {
  for (const double strike : {20.0, 135.0, 250.0}) {
    const GridFrame frame = GridFrame::centred(200, 200, 60);
    HeightField start = geom::fbm_grid(frame, Seed{4}, {.wavelength_m = 4000, .octaves = 8, .cell_m = 60}, {});
    for (float& z : start.cells()) z = 100 + 20 * z;
    RunParams params{.years = 3e6,
                     .uplift_mm_yr = 0.15,
                     .erodibility = 2e-5,
                     .hardness_variation = 0,
                     .sea_m = -1000,
                     .slopes = {.creep_m2_yr = 0.01}};
    params.lithology = {.beds = {{"cap", 80, 15}, {"shale", 350, 0.4}}, .dip_deg = 10, .strike_deg = strike};
    const Eroded worn = eroded(start, params);
    double east = 0, north = 0, count = 0;
    for (int y = 10; y < 190; ++y) {
      for (int x = 10; x < 190; ++x) {
        if (worn.bed(x, y) != 1.0F) continue;
        east -= worn.terrain(x + 1, y) - worn.terrain(x - 1, y);
        north -= worn.terrain(x, y - 1) - worn.terrain(x, y + 1);
        count += 1;
      }
    }
    const double angle = strike * std::numbers::pi / 180;
    const double down_dip = (east * std::cos(angle) - north * std::sin(angle)) / (count * 2 * 60);
    const double along = (east * std::sin(angle) + north * std::cos(angle)) / (count * 2 * 60);
    EXPECT_GT(down_dip, 0.25 * std::tan(10 * std::numbers::pi / 180)) << strike;
    EXPECT_LT(std::abs(along), 0.35 * down_dip) << strike;
  }
}

TEST(LayeredRock, ACoarseGridIsAPreviewOfAFineOne) {
  const RunParams params = with_beds({.beds = {{"", 60, 6}, {"", 90, 0.3}}, .top_m = 500, .dip_deg = 2});
  const Eroded coarse = eroded(plateau(96, 96, 3), params), fine = eroded(plateau(384, 384, 3), params);
  const Grid<float> mean = geom::box_downsample(fine.terrain, 4, {});
  const double middle =
      std::accumulate(mean.cells().begin(), mean.cells().end(), 0.0) / static_cast<double>(mean.size());
  double error = 0, relief = 0;
  for (size_t i = 0; i < mean.size(); ++i) {
    error += std::pow(coarse.terrain.data()[i] - mean.data()[i], 2);
    relief += std::pow(mean.data()[i] - middle, 2);
  }
  EXPECT_LT(std::sqrt(error / relief), 0.3);
}

TEST(LayeredRock, TheEndsOfEveryRangeStayFinite) {
  const HeightField start = plateau(70, 66, 1);
  for (const LithologyParams& lithology :
       {LithologyParams{.beds = {{"", 0.1, 1000}, {"", 0.1, 0.01}}, .dip_deg = 85, .thickness_variation = 0.9},
        LithologyParams{.beds = {{"", 10000, 0.01}}, .top_m = 12000, .fold_height_m = 5000, .fold_wavelength_m = 10},
        LithologyParams{.beds = {{"", 0.1, 1000}, {"", 10000, 0.01}},
        .repeat = false,
        .top_x_m = 1e7,
        .dip_deg = 85,
        .faults = {{{{0, 0}, {1e-9, 0}}, 10, 10000}, {{{-1e7, 0}, {1e7, 1}}, 90, -10000}}}}) {
    RunParams params = with_beds(lithology);
    for (const double years : {1e5, 1e9}) {
      params.years = years;
      params.uplift_mm_yr = years > 1e6 ? 100 : 1;
      const Eroded worn = eroded(start, params);
      for (const float z : worn.terrain.cells()) ASSERT_TRUE(std::isfinite(z));
      for (const float bed : worn.bed.cells()) ASSERT_TRUE(std::isfinite(bed));
    }
  }
}

}  // namespace
}  // namespace seamount::erosion
