#include <gtest/gtest.h>

#include <cmath>

#include "seamount/base/error.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/io/weights.h"
#include "seamount/ops/learned/island_planes.h"
#include "seamount/ops/learned/sketch_planes.h"
#include "seamount/ops/learned/test_network.h"
#include "seamount/train/island_measures.h"
#include "seamount/train/sketch_measures.h"

namespace seamount::train {
namespace {

/// A network that adds nothing.
learned::Network silent(int planes) {
  Weights weights = learned::random_weights({planes, {8, 16, 24}});
  for (const char* name : {"outer.weight", "outer.bias"})
    for (float& w : weights.tensors[name].values) w = 0;
  return learned::Network(weights, learned::Precision::f32);
}

std::vector<GroundTile> hills() {
  HeightField heights =
      geom::ridged_grid(GridFrame::centred(300, 280, 30), Seed{5}, {.wavelength_m = 3000, .octaves = 7}, {});
  for (float& z : heights.cells()) z = 500 + 800 * z;
  return {{"hills", std::move(heights)}};
}

TEST(SketchMeasures, WithoutANetworkItIsTheDiffusionAndRealGroundIsItself) {
  const ComparedMeasures all = measure_sketches(silent(learned::kSketchPlanes), hills(), {}, 3, 128, Seed{1}, {});
  EXPECT_EQ(all.made.pieces, 3);
  EXPECT_NEAR(all.made.distances.at("slope"), all.diffused.distances.at("slope"),
              0.05 * all.diffused.distances.at("slope"));
  EXPECT_GT(all.made.distances.at("slope"), 0.5);
  EXPECT_EQ(all.real.distances.at("slope"), 0);
  EXPECT_DOUBLE_EQ(all.real.grid, 1);
  EXPECT_GT(all.real.rivers, 0.8);
  EXPECT_GT(all.real.ridges, 0.7);
  EXPECT_LT(all.diffused.rivers, all.real.rivers - 0.2) << "lines are not met by chance";
  EXPECT_LT(all.diffused.ridges, all.real.ridges - 0.2);
  EXPECT_GT(all.real.pits_km2, all.diffused.pits_km2);
}

TEST(SketchMeasures, GroundTooSmallIsSaid) {
  EXPECT_THROW(measure_sketches(silent(learned::kSketchPlanes), hills(), {}, 1, 512, Seed{1}, {}), InvalidArgument);
  EXPECT_THROW(measure_sketches(silent(learned::kSketchPlanes), hills(), {}, 1, 200, Seed{1}, {}), InvalidArgument);
}

TEST(IslandMeasures, ANetworkThatAddsNothingIsFarOffAndItsCoastsAreStillMet) {
  const IslandMeasures all = measure_islands(silent(learned::kIslandPlanes), 2, Seed{1}, {});
  EXPECT_EQ(all.maps, 2);
  for (const double off : all.off) {
    EXPECT_GT(off, 0.1);
    EXPECT_LT(off, 1);
  }
  EXPECT_GT(all.coast_iou, 0.97);
}

}  // namespace
}  // namespace seamount::train
