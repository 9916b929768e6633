#include "seamount/ops/erosion/run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "seamount/geom/grid/resample.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/ops/erosion/drainage.h"

namespace seamount::erosion {
namespace {

HeightField hills(int width, int height, double base_m = 300, double domain_m = 5120) {
  const GridFrame frame = GridFrame::centred(width, height, domain_m / width);
  HeightField z = geom::fbm_grid(frame, Seed{3}, {.wavelength_m = 2500, .octaves = 8, .cell_m = frame.cell_m}, {});
  for (float& value : z.cells()) value = static_cast<float>(base_m + 500 * value);
  return z;
}

Eroded eroded(const HeightField& start, const RunParams& params = {}, Maps site = {}, int threads = 0) {
  return run({start, {}, {}}, std::move(site), params, Seed{11}, {.threads = threads});
}

double volume(const HeightField& z) {
  return std::accumulate(z.cells().begin(), z.cells().end(), 0.0) * z.cell_m() * z.cell_m();
}

/// Cells of land without a way down, lakes aside: greedy descent by the filled surface (brute force).
int undrained(const Eroded& result) {
  const HeightField& z = result.terrain;
  int count = 0;
  for (int y = 1; y + 1 < z.height(); ++y) {
    for (int x = 1; x + 1 < z.width(); ++x) {
      if (z(x, y) < 0 || result.lake(x, y) > 0) continue;
      bool drains = false;
      for (int d = 0; d < 8; ++d) {
        const float water =
            z(x + geom::kFlowDx[d], y + geom::kFlowDy[d]) + result.lake(x + geom::kFlowDx[d], y + geom::kFlowDy[d]);
        drains = drains || water <= z(x, y);
      }
      count += drains ? 0 : 1;
    }
  }
  return count;
}

TEST(Erosion, ConservesMassUpToWhatLeavesTheMap) {
  for (const auto& [base_m, uplift_mm_yr] : {std::pair{400.0, 0.0}, {20.0, 0.5}}) {
    for (const auto& [width, height] : {std::pair{131, 129}, {70, 40}}) {
      {
        const HeightField start = hills(width, height, base_m);
        const Eroded result = eroded(start, {.uplift_mm_yr = uplift_mm_yr});
        const double lost = volume(start) - volume(result.terrain);
        const double expected = result.ledger.exported - result.ledger.uplifted;
        EXPECT_GT(result.ledger.eroded, 0);
        EXPECT_NEAR(lost, expected, 1e-4 * result.ledger.eroded) << width << " " << base_m << " " << uplift_mm_yr;
      }
    }
  }
}

TEST(Erosion, LayersAreNeverNegativeAndValleysDrain) {
  for (const double base_m : {400.0, 20.0}) {
    const Eroded result = eroded(hills(128, 140, base_m));
    for (const ScalarField* layer : {&result.debris, &result.sediment, &result.lake, &result.flow}) {
      for (const float value : layer->cells()) ASSERT_GE(value, 0.0F);
    }
    EXPECT_EQ(undrained(result), 0);
  }
}

TEST(Erosion, ZeroYearsChangeNothing) {
  const HeightField start = hills(140, 150, 0);
  EXPECT_TRUE(eroded(start, {.years = 0}).terrain == start);
}

TEST(Erosion, AnyNumberOfThreadsMakesTheSameBytes) {
  for (const Method method : {Method::hydraulic, Method::stream_power}) {
    const HeightField start = hills(300, 280, 20);
    const RunParams params{.method = method, .uplift_mm_yr = 0.2};
    const Eroded one = eroded(start, params, {}, 1), more = eroded(start, params, {}, 5);
    EXPECT_TRUE(one.terrain == more.terrain);
    EXPECT_TRUE(one.sediment == more.sediment);
    EXPECT_EQ(one.ledger.exported, more.ledger.exported);
  }
}

TEST(Erosion, FlatGroundStaysFlat) {
  for (const float level : {0.0F, 120.0F, -30.0F}) {
    const HeightField flat(GridFrame::centred(150, 130, 20), level);
    EXPECT_TRUE(eroded(flat).terrain == flat) << level;
  }
}

TEST(Erosion, MaskedGroundStaysAsItWas) {
  const HeightField start = hills(192, 160, 30);
  Maps site{.hardness = {}, .mask = Mask(start.frame(), 1.0F), .uplift = {}, .rain = {}};
  for (int y = 37; y < 101; ++y) {
    for (int x = 51; x < 120; ++x) site.mask(x, y) = 0.0F;
  }
  const Eroded result = eroded(start, {.uplift_mm_yr = 0.3}, site);
  double changed = 0;
  for (int y = 0; y < start.height(); ++y) {
    for (int x = 0; x < start.width(); ++x) {
      if (site.mask(x, y) == 0.0F) {
        ASSERT_EQ(result.terrain(x, y), start(x, y)) << x << " " << y;
      } else {
        changed += std::abs(result.terrain(x, y) - start(x, y));
      }
    }
  }
  EXPECT_GT(changed, 1e4);
}

TEST(Erosion, NothingStaysSteeperThanItsMaterialCanStand) {
  HeightField start = hills(96, 96, 500, 960);
  for (int y = 40; y < 60; ++y) {
    for (int x = 40; x < 60; ++x) start(x, y) += 300;  // a tower
  }
  const RunParams params{.years = 200000,
                         .erodibility = 0,
                         .hardness_variation = 0,
                         .slopes = {.bedrock_angle_deg = 45, .creep_m2_yr = 0, .weathering_mm_yr = 0}};
  const Eroded result = eroded(start, params);
  const double allowed = std::tan((45 + 2.0) * 3.14159265 / 180) * start.cell_m();
  for (int y = 0; y < start.height(); ++y) {
    for (int x = 0; x + 1 < start.width(); ++x) {
      ASSERT_LT(std::abs(result.terrain(x, y) - result.terrain(x + 1, y)), allowed) << x << " " << y;
    }
  }
}

TEST(Erosion, HardRockStandsAndSoftRockGoes) {
  const HeightField start = hills(128, 128, 500);
  const auto loss = [&](float hardness) {
    return volume(start) -
           volume(eroded(start, {},
                         {.hardness = ScalarField(start.frame(), hardness), .mask = {}, .uplift = {}, .rain = {}})
                      .terrain);
  };
  EXPECT_GT(loss(0.5F), loss(1.0F));
  EXPECT_GT(loss(1.0F), 1.5 * loss(10.0F));
}

TEST(Erosion, RiversBuildAnApronWhereTheyLeaveTheMountains) {
  // A block of hills over a plain to the south that falls by half a degree.
  HeightField start = hills(160, 160, 700, 8000);
  for (int y = 80; y < 160; ++y) {
    for (int x = 0; x < 160; ++x) start(x, y) = static_cast<float>(300 - 0.4 * (y - 80)) + 0.002F * start(x, y);
  }
  const auto apron = [&](double fan_m) {
    const Eroded result = eroded(start, {.years = 60000, .sea_m = -1000, .rivers = {.deposition = 2, .fan_m = fan_m}});
    double volume_m3 = 0;
    for (int y = 80; y < 110; ++y) {
      for (int x = 10; x < 150; ++x) volume_m3 += (result.terrain(x, y) - start(x, y)) * 2500.0;
    }
    return volume_m3;
  };
  EXPECT_GT(apron(800), 1.5 * std::max(0.0, apron(0)));
  EXPECT_GT(apron(800), 1e6);
}

TEST(Erosion, ValleysGrowWhereItRains) {
  const HeightField start = hills(160, 160, 600);
  Maps site{.hardness = {}, .mask = {}, .uplift = {}, .rain = ScalarField(start.frame(), 0.0F)};
  for (int y = 0; y < 160; ++y) {
    for (int x = 80; x < 160; ++x) site.rain(x, y) = 2.0F;
  }
  const Eroded result = eroded(start, {.years = 30000, .slopes = {.creep_m2_yr = 0, .weathering_mm_yr = 0}}, site);
  double dry = 0, wet = 0;
  for (int y = 0; y < 160; ++y) {
    for (int x = 0; x < 160; ++x) (x < 80 ? dry : wet) += std::abs(result.terrain(x, y) - start(x, y));
  }
  EXPECT_GT(wet, 2.5 * dry);
}

TEST(Erosion, UpliftMakesARangeWhoseRiversFlattenDownstream) {
  HeightField start = hills(128, 128, 0, 12800);
  for (float& z : start.cells()) z *= 0.002F;
  const RunParams params{.method = Method::stream_power,
                         .years = 3e6,
                         .uplift_mm_yr = 0.5,
                         .erodibility = 1e-5,
                         .hardness_variation = 0,
                         .sea_m = -1000};
  const Eroded result = eroded(start, params);
  const HeightField& z = result.terrain;
  // Steady state: uplift = K sqrt(discharge) slope, so a hundred times the water makes a tenth of the slope.
  std::array<double, 2> slope = {}, count = {};
  for (int y = 4; y < 124; ++y) {
    for (int x = 4; x < 124; ++x) {
      float fall = 0;
      for (int d = 0; d < 8; d += 2) fall = std::max(fall, z(x, y) - z(x + geom::kFlowDx[d], y + geom::kFlowDy[d]));
      const int big = result.flow(x, y) > 5e6F ? 1 : 0;
      if (big == 0 && (result.flow(x, y) < 5e4F || result.flow(x, y) > 1e5F)) continue;
      slope[big] += fall / z.cell_m();
      count[big] += 1;
    }
  }
  EXPECT_GT(count[1], 50);
  EXPECT_LT(slope[1] / count[1], 0.3 * slope[0] / count[0]);
  EXPECT_GT(*std::max_element(z.cells().begin(), z.cells().end()), 200);
}

/// Shares of the length of large rivers by direction, from 0 to pi in `bins` (the first about the x axis), measured
/// over `chord` cells along their course.
std::vector<double> river_directions(const Eroded& result, float min_flow, int chord, int bins) {
  const HeightField& z = result.terrain;
  const auto below = [&](int& x, int& y) {
    int best = -1;
    for (int d = 0; d < 8; ++d) {
      const int nx = x + geom::kFlowDx[d], ny = y + geom::kFlowDy[d];
      if (!z.contains(nx, ny) || result.flow(nx, ny) <= result.flow(x, y)) continue;
      if (best < 0 || z(nx, ny) < z(x + geom::kFlowDx[best], y + geom::kFlowDy[best])) best = d;
    }
    if (best < 0) return false;
    x += geom::kFlowDx[best], y += geom::kFlowDy[best];
    return true;
  };
  std::vector<double> share(static_cast<size_t>(bins));
  double all = 0;
  for (int y = 0; y < z.height(); ++y) {
    for (int x = 0; x < z.width(); ++x) {
      if (result.flow(x, y) < min_flow) continue;
      int ex = x, ey = y, steps = 0;
      while (steps < chord && below(ex, ey)) ++steps;
      if (steps < chord) continue;
      const double turn = std::atan2(ey - y, ex - x) / 3.14159265 * bins + 0.5;
      share[static_cast<size_t>(turn + 2 * bins) % static_cast<size_t>(bins)] += 1;
      all += 1;
    }
  }
  for (double& one : share) one *= bins / all;
  return share;
}

TEST(Erosion, ValleysRunInAllDirections) {
  std::vector<double> sum(8);
  for (uint64_t seed = 1; seed <= 4; ++seed) {
    const GridFrame frame = GridFrame::centred(192, 192, 100);
    HeightField z =
        geom::fbm_grid(frame, Seed{seed}, {.wavelength_m = 12000, .octaves = 8, .cell_m = frame.cell_m}, {});
    for (float& value : z.cells()) value = 1080 + 1172 * value;
    const RunParams params{.years = 1.5e6,
                           .uplift_mm_yr = 0.95,
                           .erodibility = 8.5e-6,
                           .sea_m = -1000,
                           .slopes = {.bedrock_angle_deg = 29, .creep_m2_yr = 0.026}};
    const Eroded result = run({std::move(z), {}, {}}, {}, params, Seed{seed}, {});
    const std::vector<double> share = river_directions(result, 2e5F, 8, 8);
    for (size_t i = 0; i < sum.size(); ++i) sum[i] += share[i] / 4;
  }
  for (size_t i = 0; i < sum.size(); ++i) {
    EXPECT_LT(sum[i], 1.25) << i;
    EXPECT_GT(sum[i], 0.8) << i;
  }
}

/// Straight crests along a row, a column or a diagonal, ten cells long and more, for every 1000 cells of crests: of
/// what stands higher than both neighbours across one of these directions, on steep ground.
double straight_crests(const HeightField& z) {
  const std::array<std::pair<int, int>, 4> along = {{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};
  const auto is_steep = [&](int x, int y) {
    float low = INFINITY, high = -INFINITY;
    for (int j = -2; j <= 2; ++j) {
      for (int i = -2; i <= 2; ++i)
        low = std::min(low, z.clamped(x + i, y + j)), high = std::max(high, z.clamped(x + i, y + j));
    }
    return high - low > 0.75 * z.cell_m();
  };
  Grid<uint8_t> crest(z.frame(), 0);
  int straight = 0;
  for (const auto& [dx, dy] : along) {
    Grid<int> run(z.frame(), 0);
    for (int y = 1; y + 1 < z.height(); ++y) {
      for (int k = 1; k + 1 < z.width(); ++k) {
        const int x = k;
        if (z(x, y) <= z(x - dy, y + dx) || z(x, y) <= z(x + dy, y - dx) || !is_steep(x, y)) continue;
        crest(x, y) = 1;
        const int bx = dx == 1 && dy == -1 ? x + 1 : x - dx, by = dx == 1 && dy == -1 ? y - 1 : y - dy;
        run(x, y) = run(bx, by) + 1;
        straight += run(x, y) == 10 ? 1 : 0;
      }
    }
  }
  return 1000.0 * straight / std::accumulate(crest.cells().begin(), crest.cells().end(), 1.0);
}

TEST(Erosion, CrestsAreNotStraight) {
  // Land that rises so fast over hard rock that nearly all of it stands as steeply as it can.
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    HeightField start = hills(256, 256, 60);
    for (float& z : start.cells()) z = 60 + 0.05F * (z - 60);
    const RunParams params{.method = Method::stream_power, .years = 5e6, .uplift_mm_yr = 1, .erodibility = 5e-6};
    const HeightField z = run({std::move(start), {}, {}}, {}, params, Seed{seed}, {}).terrain;
    EXPECT_LT(straight_crests(z), 6.0) << seed;
  }
}

TEST(Erosion, AHollowBelowTheSeaIsNoSea) {
  // A basin 300 m below the sea behind a rim, on land that falls to a coast in the west.
  HeightField start(GridFrame::centred(140, 120, 100));
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 140; ++x) {
      const double basin = std::exp(-(std::pow((x - 90) / 16.0, 2) + std::pow((y - 60) / 20.0, 2)));
      start(x, y) = static_cast<float>(std::min(200.0, 12.0 * (x - 20)) - 520 * basin);
    }
  }
  ASSERT_LT(start(90, 60), -300);
  const Eroded result = eroded(start, {.years = 20000});
  EXPECT_GT(result.lake(90, 60), 250);  // water climbs over the rim
  EXPECT_EQ(result.lake(5, 60), 0);     // the sea
  const double lost = volume(start) - volume(result.terrain);
  EXPECT_NEAR(lost, result.ledger.exported, 1e-4 * result.ledger.eroded);
}

TEST(Erosion, OddShapesAndTinyMaps) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 9}, {9, 1}, {2, 2}, {2, 7}, {3, 3}, {5, 300}, {300, 5}}) {
    const HeightField start = hills(width, height, 50, 40.0 * width);
    const Eroded result = eroded(start);
    for (const float z : result.terrain.cells()) ASSERT_TRUE(std::isfinite(z)) << width << "x" << height;
  }
}

TEST(Erosion, YearsThatRiseMakeFramesThatBelongTogether) {
  const HeightField start = hills(160, 160);
  const auto change = [&](double years) {
    ScalarField by = eroded(start, {.years = years}).terrain;
    for (size_t i = 0; i < by.size(); ++i) by.data()[i] -= start.data()[i];
    return by;
  };
  const ScalarField first = change(50000), second = change(55000);
  double both = 0, one = 0, other = 0;
  for (size_t i = 0; i < first.size(); ++i) {
    both += first.data()[i] * second.data()[i];
    one += first.data()[i] * first.data()[i];
    other += second.data()[i] * second.data()[i];
  }
  EXPECT_GT(both / std::sqrt(one * other), 0.97);
}

TEST(Erosion, ACoarseGridIsAPreviewOfAFineOne) {
  const auto difference = [](const HeightField& coarse, const HeightField& fine) {
    const Grid<float> mean = geom::box_downsample(fine, fine.width() / coarse.width(), {});
    const double middle = std::accumulate(mean.cells().begin(), mean.cells().end(), 0.0) / mean.size();
    double error = 0, relief = 0;
    for (size_t i = 0; i < mean.size(); ++i) {
      error += std::pow(coarse.data()[i] - mean.data()[i], 2);
      relief += std::pow(mean.data()[i] - middle, 2);
    }
    return std::sqrt(error / relief);
  };
  const Eroded coarse = eroded(hills(128, 128)), fine = eroded(hills(512, 512));
  EXPECT_LT(difference(coarse.terrain, fine.terrain), 0.3);
  const double loss_coarse = coarse.ledger.exported, loss_fine = fine.ledger.exported;
  EXPECT_NEAR(loss_coarse, loss_fine, 0.25 * loss_fine);
}

TEST(Erosion, TheEndsOfEveryRangeStayFinite) {
  const HeightField start = hills(70, 66, 20);
  for (const RunParams& params :
       {RunParams{.years = 1e9, .uplift_mm_yr = 100, .slopes = {.creep_m2_yr = 10}},
        RunParams{.years = 1e9, .erodibility = 0.1},
        RunParams{.erodibility = 1e-37,
        .rivers = {.deposition = 10, .sediment_ease = 0.01},
        .slopes = {.weathering_mm_yr = 100}},
        RunParams{.uplift_mm_yr = 1, .runoff_mm_yr = 1, .rivers = {.deposition = 10, .evaporation_per_km = 1}},
        RunParams{.runoff_mm_yr = 20000, .rivers = {.debris_ease = 1000, .sediment_ease = 1000, .channel_m2 = 1e8}},
        RunParams{
            .slopes = {.bedrock_angle_deg = 89, .debris_angle_deg = 1, .sediment_angle_deg = 1, .creep_m2_yr = 10}},
        RunParams{.sea_m = 9000, .slopes = {.bedrock_angle_deg = 1}},
        RunParams{.coast = {.retreat_mm_yr = 10000, .settling_m = 1e6}}}) {
    const Eroded result = eroded(start, params);
    for (const ScalarField* field : {&result.terrain, &result.debris, &result.sediment, &result.flow, &result.lake}) {
      for (const float value : field->cells()) ASSERT_TRUE(std::isfinite(value));
    }
  }
}

TEST(Erosion, RefusesWhatDoesNotFit) {
  const HeightField start = hills(20, 20);
  EXPECT_THROW(eroded(start, {.years = -1}), InvalidArgument);
  EXPECT_THROW(
      eroded(start, {}, {.hardness = {}, .mask = Mask(GridFrame::centred(3, 3, 1), 1.0F), .uplift = {}, .rain = {}}),
      IncompatibleInputs);
}

}  // namespace
}  // namespace seamount::erosion
