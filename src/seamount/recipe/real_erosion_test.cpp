// Noise, the same noise eroded, and a real range: erosion brings every distance of hydrology.describe down, in the mean
// of a few noises, as the guide says (docs/guide/real_erosion.md).
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "seamount/geom/grid/resample.h"
#include "seamount/geom/solve/fill_voids.h"
#include "seamount/io/raster.h"
#include "seamount/ops/erosion/run.h"
#include "seamount/ops/hydrology/describe.h"
#include "seamount/ops/terrain/noise.h"
#include "seamount/recipe/test_dems.h"

namespace seamount::recipe {
namespace {

TEST(RealErosion, BringsNoiseNearerToTheSanGabrielMountains) {
  const std::optional<std::string> path = find_dem("sangabriel_bigtujunga_30m");
  if (!path) GTEST_SKIP() << "no sangabriel_bigtujunga_30m.tif; SEAMOUNT_DEM_DIR names the folder of elevation models";
  io::ReadOptions options;
  HeightField whole = io::read_heights(*path, options);
  geom::fill_voids(whole, {});
  const GridFrame frame = GridFrame::centred(640, 640, 30);
  GridFrame there = frame;
  there.west_m += 0.5 * (whole.frame().west_m + whole.frame().east_m());
  there.north_m += 0.5 * (whole.frame().south_m() + whole.frame().north_m);
  const HeightField real = geom::resample(whole, there, {});
  const erosion::RunParams params{.years = 1.6e6,
                                  .uplift_mm_yr = 0.75,
                                  .erodibility = 3.9e-6,
                                  .sea_m = -1000,
                                  .slopes = {.bedrock_angle_deg = 29, .creep_m2_yr = 0.045}};
  const std::set<std::string> always = {"slope",  "curvature",  "drainage_area", "slope_area",
                                        "ridges", "prominence", "roughness"};
  for (const uint64_t seed : {1, 2}) {
    const HeightField noise =
        terrain::noise({.kind = terrain::NoiseKind::smooth, .height_m = 1172, .wavelength_m = 12000, .base_m = 1080},
                       frame, Seed{seed}, {});
    const erosion::Eroded worn = erosion::run({noise, {}, {}}, {}, params, Seed{seed}, {});
    const Report before = hydrology::describe(noise, &real, {}, {}).report,
                 after = hydrology::describe(worn.terrain, &real, {}, {}).report;
    size_t compared = 0;
    for (size_t i = 0; i < before.descriptors.size(); ++i) {
      if (always.count(before.descriptors[i].name) == 0) continue;
      EXPECT_LT(after.descriptors[i].distance.value(), before.descriptors[i].distance.value())
          << before.descriptors[i].name;
      ++compared;
    }
    EXPECT_EQ(compared, always.size());
  }
}

}  // namespace
}  // namespace seamount::recipe
