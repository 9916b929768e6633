// What erosion and uplift agree on in the end, beside an independent model and the law of its channels.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "seamount/geom/scalar/noise.h"
#include "seamount/ops/erosion/run.h"
#include "seamount/ops/erosion/test_fastscape.h"

namespace seamount::erosion {
namespace {

/// A plain with noise whose border is level.
HeightField plain(int side, double width_m, uint64_t seed) {
  const GridFrame frame = GridFrame::centred(side, side, width_m / side);
  HeightField z =
      geom::fbm_grid(frame, Seed{seed}, {.wavelength_m = 0.25 * width_m, .octaves = 8, .cell_m = frame.cell_m}, {});
  for (float& value : z.cells()) value = 10.0F + 8.0F * value;
  for (int k = 0; k < side; ++k) z(k, 0) = z(0, k) = z(k, side - 1) = z(side - 1, k) = 0.0F;
  return z;
}

Grid<uint8_t> border(const GridFrame& frame) {
  Grid<uint8_t> cells(frame, 0);
  for (int k = 0; k < frame.width; ++k) cells(k, 0) = cells(k, frame.height - 1) = 1;
  for (int k = 0; k < frame.height; ++k) cells(0, k) = cells(frame.width - 1, k) = 1;
  return cells;
}

double mean(const HeightField& z) {
  return std::accumulate(z.cells().begin(), z.cells().end(), 0.0) / static_cast<double>(z.size());
}
double highest(const HeightField& z) { return *std::max_element(z.cells().begin(), z.cells().end()); }

/// Median of slope times the root of drainage area, over cells that drain more than `least_m2`: U / K.
double steepness(const HeightField& z, double least_m2) {
  const Ways ways = fastscape_ways(z, border(z.frame()));
  const std::vector<double> cells = fastscape_area(ways);
  std::vector<double> all;
  for (size_t i = 0; i < cells.size(); ++i) {
    const double area = cells[i] * z.cell_m() * z.cell_m();
    if (area < least_m2 || ways.distance_m[i] == 0.0) continue;
    all.push_back((z.data()[i] - z.data()[ways.receiver[i]]) / ways.distance_m[i] * std::sqrt(area));
  }
  std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2), all.end());
  return all[all.size() / 2];
}

/// Nothing but K sqrt(A) slope.
RunParams bare() {
  return {.method = Method::stream_power,
          .years = 2e7,
          .uplift_mm_yr = 1,
          .erodibility = 2e-5,
          .hardness_variation = 0,
          .sea_m = -1000,
          .rivers = {.deposition = 0, .channel_m2 = 0},
          .slopes = {.bedrock_angle_deg = 89, .creep_m2_yr = 0, .weathering_mm_yr = 0}};
}

TEST(SteadyState, IsThatOfFastScape) {
  for (const auto& [side, seed] : {std::pair{96, 1}, {96, 2}, {128, 3}, {160, 4}}) {
    const HeightField start = plain(side, 25600, static_cast<uint64_t>(seed));
    const HeightField judge =
        fastscape(start, border(start.frame()), {.erodibility = 2e-5, .uplift_m_yr = 1e-3, .years = 2e7, .steps = 100});
    for (const Method method : {Method::stream_power, Method::hydraulic}) {
      RunParams params = bare();
      params.method = method;
      const HeightField z = run({start, {}, {}}, {}, params, Seed{7}, {}).terrain;
      EXPECT_NEAR(mean(z), mean(judge), 0.15 * mean(judge)) << side << " " << seed;
      EXPECT_NEAR(highest(z), highest(judge), 0.15 * highest(judge)) << side << " " << seed;
      EXPECT_NEAR(steepness(z, 2e5), 50.0, 5.0) << side << " " << seed;
    }
  }
}

TEST(SteadyState, KeepsTheSteepnessOfChannelsBelowSlopesThatCreep) {
  // Cells as wide as hillslopes are long, and half of that.
  for (const int side : {200, 400}) {
    RunParams params = bare();
    params.years = 4e6;
    params.uplift_mm_yr = 0.5;
    params.erodibility = 5e-5;
    params.rivers.channel_m2 = 1000;
    params.slopes.creep_m2_yr = 0.005;
    params.slopes.bedrock_angle_deg = 40;
    const HeightField z = run({plain(side, 6400, 5), {}, {}}, {}, params, Seed{7}, {}).terrain;
    EXPECT_NEAR(steepness(z, 2e4), 10.0, 1.0) << side;
  }
}

TEST(SteadyState, IsPreviewedByCoarseCells) {
  for (const auto& [erodibility, width_m] : {std::pair{1e-5, 10240.0}, {5e-5, 10240.0}}) {
    const auto land = [&](int side) {
      const RunParams params{.method = Method::stream_power,
                             .years = 4e6,
                             .uplift_mm_yr = 0.5,
                             .erodibility = erodibility,
                             .hardness_variation = 0,
                             .sea_m = -1000};
      return mean(run({plain(side, width_m, 5), {}, {}}, {}, params, Seed{7}, {}).terrain);
    };
    const double fine = land(512);
    for (const int side : {128, 256}) EXPECT_NEAR(land(side), fine, 0.15 * fine) << side << " " << erodibility;
  }
}

}  // namespace
}  // namespace seamount::erosion
