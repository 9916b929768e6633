// P0 eq. 1.8 to 1.15 against values by hand, and the laws of subsidence and reef growth.
#include "seamount/ops/island/coral.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>

#include <array>
#include <cmath>
#include <numbers>

#include "seamount/geom/scalar/blend.h"
#include "seamount/ops/island/build.h"
#include "seamount/ops/island/reef_passes.h"

namespace seamount::island {
namespace {

TEST(Subside, ScalesHeightsOverTheSeaFloor) {
  EXPECT_DOUBLE_EQ(subside(1000, -500, 0.0), 1000);
  EXPECT_DOUBLE_EQ(subside(1000, -500, 0.2), 700);   // -500 + 0.8 * 1500
  EXPECT_DOUBLE_EQ(subside(-500, -500, 0.7), -500);  // the sea floor does not rise, as scaling z itself would make it
  EXPECT_DOUBLE_EQ(subside(1000, -500, 1.0), -500);
}

TEST(Transition, IsEquation1_10) {
  EXPECT_DOUBLE_EQ(transition(-20, -2, 0.5, 0.75, 0.5), -20);
  EXPECT_DOUBLE_EQ(transition(-20, -2, 0.5, 0.75, 0.75), -2);
  EXPECT_DOUBLE_EQ(transition(-20, -2, 0.5, 0.75, 0.625), -11);                    // smoothstep(1/2) = 1/2
  EXPECT_NEAR(transition(-20, -2, 0.5, 0.75, 0.5625), -20 + 18 * 0.15625, 1e-12);  // smoothstep(1/4) = 3/16 - 2/64
}

TEST(CoralProfile, IsEquation1_11) {
  const ReefSection p;
  for (const auto& [x, z] : {std::pair{0.0, -20.0},
                             {0.3, -20.0},
                             {0.5, -20.0},
                             {0.625, -11.0},
                             {0.75, -2.0},
                             {0.78, -2.0},
                             {0.8, -2.0},
                             {0.9, -51.0},
                             {1.0, -100.0},
                             {1.5, -100.0}}) {
    EXPECT_NEAR(coral_profile(p, x), z, 1e-9) << x;
  }
  EXPECT_NEAR(coral_profile(p, 0.85), -2 - 98 * 0.15625, 1e-9);
}

TEST(CoralProfile, RefusesBreakpointsOutOfOrder) {
  const LabelMap labels(GridFrame::centred(4, 4, 10), Region::reef);
  const HeightField flat(labels.frame(), -5.0F);
  try {
    coral(flat, labels, nullptr, {.section = {.back_end = 0.9}}, {}, {});
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_STREQ(error.what(), "section.crest_start: 0.75 does not follow back_end = 0.9");
  }
}

Island small_island(int size = 160) {
  const GridFrame frame = GridFrame::centred(size, size, 12800.0 / size);
  const Plan plan = plan_from_polar({{{3000, 3400, 2900, 3300}}}, {},
                                    {.beach_m = 120, .lagoon_m = 700, .reef_m = 700, .slope_m = 1500});
  return build(plan, {.peak_m = 700.0, .floor_m = -500.0}, frame, Seed{5}, {});
}

/// Only what the paper has: no talus, passes, islets or uneven floor.
CoralParams paper_only(double subsidence) {
  return {.subsidence = subsidence,
          .exposure = 0,
          .passes = 0,
          .lagoon_relief_m = 0,
          .islets = 0,
          .section = {.fore_reef_slope_deg = 0}};
}

TEST(Coral, IsAlgorithm2OnEveryCell) {
  const Island isle = small_island();
  const CoralParams p = paper_only(0.35);
  const Reefed out = coral(isle.terrain, isle.labels, &isle.coordinate, p, Seed{1}, {});
  const double floor = *std::min_element(isle.terrain.cells().begin(), isle.terrain.cells().end());
  for (size_t c = 0; c < out.terrain.size(); ++c) {
    const double x = std::clamp(isle.coordinate.cells()[c] - 3.0, 0.0, 1.0);
    const double expected = geom::smax(subside(isle.terrain.cells()[c], floor, 0.35), coral_profile(p.section, x), 0.5);
    ASSERT_NEAR(out.terrain.cells()[c], expected, 0.02);
  }
}

TEST(Coral, NeverLiesBelowTheSunkenIslandOrTheReef) {
  const Island isle = small_island();
  for (const double lambda : {0.0, 0.2, 0.6, 1.0}) {
    const Reefed out = coral(isle.terrain, isle.labels, &isle.coordinate, {.subsidence = lambda}, Seed{1}, {});
    const double floor = *std::min_element(isle.terrain.cells().begin(), isle.terrain.cells().end());
    for (size_t c = 0; c < out.terrain.size(); ++c)
      ASSERT_GE(out.terrain.cells()[c], subside(isle.terrain.cells()[c], floor, lambda) - 0.01);
  }
}

/// Land, and water that the reef shuts in, by flood from the frame's border over what lies deeper than `sill`.
struct Census {
  int land = 0;
  double deepest_lagoon = 0;
};

Census census(const Reefed& r) {
  Census c;
  for (size_t i = 0; i < r.terrain.size(); ++i) {
    const Region label = r.labels.cells()[i];
    if (r.terrain.cells()[i] > 0 && label == Region::mountain) ++c.land;
    if (label == Region::lagoon)
      c.deepest_lagoon = std::min(c.deepest_lagoon, static_cast<double>(r.terrain.cells()[i]));
  }
  return c;
}

TEST(Coral, OneRecipeGivesFringingReefBarrierReefAndAtoll) {
  const Island isle = small_island();
  const auto at = [&](double lambda) {
    return coral(isle.terrain, isle.labels, &isle.coordinate, {.subsidence = lambda}, Seed{1}, {});
  };
  const Census fringing = census(at(0.0)), barrier = census(at(0.25)), atoll = census(at(0.75));
  EXPECT_GT(fringing.land, 1000);
  EXPECT_GT(fringing.deepest_lagoon, -10.5);  // a moat behind the crest, no lagoon
  EXPECT_LT(barrier.deepest_lagoon, -12);     // a lagoon between island and reef
  EXPECT_GT(barrier.land, fringing.land / 20);
  EXPECT_LT(barrier.land, fringing.land);
  EXPECT_EQ(atoll.land, 0);  // only the reef is left
  EXPECT_LT(atoll.deepest_lagoon, -12);
  // The crest keeps up with the sea at every stage.
  for (const double lambda : {0.0, 0.25, 0.75, 1.0}) {
    const Reefed r = at(lambda);
    float crest = -1000;
    for (size_t i = 0; i < r.terrain.size(); ++i) {
      if (isle.labels.cells()[i] == Region::reef) crest = std::max(crest, r.terrain.cells()[i]);
    }
    EXPECT_GT(crest, -2.5) << lambda;
  }
}

TEST(Coral, GrowsOnAnyTerrainWithLabels) {
  const Island isle = small_island();
  const Reefed from_labels = coral(isle.terrain, isle.labels, nullptr, paper_only(0.4), Seed{1}, {});
  const Reefed from_coordinate = coral(isle.terrain, isle.labels, &isle.coordinate, paper_only(0.4), Seed{1}, {});
  double difference = 0;
  for (size_t c = 0; c < from_labels.terrain.size(); ++c)
    difference += std::abs(from_labels.terrain.cells()[c] - from_coordinate.terrain.cells()[c]);
  EXPECT_LT(difference / static_cast<double>(from_labels.terrain.size()), 1.5);
}

TEST(Coral, RefusesRastersOfDifferentSize) {
  const HeightField terrain(GridFrame::centred(8, 8, 10), 0.0F);
  EXPECT_THROW(coral(terrain, LabelMap(GridFrame::centred(8, 9, 10), Region::reef), nullptr, {}, {}, {}),
               IncompatibleInputs);
}

TEST(Coral, WindwardReefsAreNarrowerAndHigherThanLeewardOnes) {
  const GridFrame frame = GridFrame::centred(200, 200, 64);
  const Plan plan = plan_from_polar({{{2500}}}, {}, {.lagoon_m = 900, .reef_m = 1200, .slope_m = 1500});
  BuildParams even{.peak_m = 500.0, .floor_m = -500.0};
  even.detail.width_variation = 0.0;
  const Island isle = build(plan, even, frame, Seed{5}, {});
  for (const double from : {0.0, 90.0, 230.0}) {
    const Reefed reef = coral(isle.terrain, isle.labels, &isle.coordinate,
                              {.subsidence = 0.2,
                               .swell_from_deg = from,
                               .exposure = 1,
                               .passes = 0,
                               .lagoon_relief_m = 0,
                               .islets = 0,
                               .section = {.back_end = 0.2, .crest_start = 0.4, .crest_end = 0.8}},
                              Seed{1}, {});
    std::array<int, 2> flat{};
    std::array<float, 2> crest = {-1e9F, -1e9F};
    for (int y = 0; y < frame.height; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        const double towards = (frame.x(x) * std::sin(from * std::numbers::pi / 180) +
                                frame.y(y) * std::cos(from * std::numbers::pi / 180)) /
                               std::hypot(frame.x(x), frame.y(y));
        if (std::abs(towards) < 0.8 || isle.labels(x, y) != Region::reef) continue;
        const size_t side = towards > 0 ? 0 : 1;
        flat[side] += reef.terrain(x, y) > -4.0F ? 1 : 0;
        crest[side] = std::max(crest[side], reef.terrain(x, y));
      }
    }
    EXPECT_LT(flat[0], 0.95 * flat[1]) << from;
    EXPECT_GT(crest[0], crest[1] + 0.8F) << from;
    EXPECT_LT(crest[0], 0.0F);
  }
}

TEST(ReefPasses, TheFirstLiesOffTheLargestRiver) {
  for (const uint64_t seed : {1U, 2U, 3U, 4U}) {
    const GridFrame frame = GridFrame::centred(200, 200, 64);
    const Plan plan = plan_from_polar({{{3000, 3400, 2900, 3300}}}, {}, {.lagoon_m = 700, .reef_m = 600});
    const Island isle = build(plan, {}, frame, Seed{seed}, {});
    const std::vector<RiverMouth> mouths = river_mouths(isle.terrain, 0.0F, {});
    ASSERT_GT(mouths.size(), 3U);
    EXPECT_GE(mouths[0].catchment_m2, mouths[1].catchment_m2);
    const ReefPasses passes(isle.coordinate, 4, 200, mouths, Seed{seed}, {});
    ASSERT_EQ(passes.count(), 4);
    const Vec2 d = passes.place(0) - mouths[0].place;
    EXPECT_LT(std::sqrt(dot(d, d)), 1400) << seed;
    const ReefPasses many(isle.coordinate, -1, 200, mouths, Seed{seed}, {});
    EXPECT_EQ(many.count(), 2);  // a reef of 26 km
  }
}

/// Elevation models of land give the sea as 0 m: it has no floor, so no reef grows, and none of it becomes land.
TEST(Coral, ASeaWithoutAFloorStaysAsItIs) {
  for (const double subsidence : {0.0, 0.3, 0.8}) {
    HeightField terrain(GridFrame::centred(96, 96, 40.0));
    LabelMap labels(terrain.frame(), Region::abyss);
    for (int y = 0; y < 96; ++y) {
      for (int x = 0; x < 96; ++x) {
        const double r = std::hypot(x - 48, y - 48);
        terrain(x, y) = r < 20 ? static_cast<float>(20 * (20 - r)) : 0.0F;
        labels(x, y) = r < 18   ? Region::mountain
                       : r < 20 ? Region::beach
                       : r < 26 ? Region::lagoon
                       : r < 30 ? Region::reef
                                : Region::abyss;
      }
    }
    std::string said;
    RunContext run;
    run.note = [&](const std::string& line) { said = line; };
    const Reefed out = coral(terrain, labels, nullptr, {.subsidence = subsidence}, Seed{3}, run);
    EXPECT_NE(said.find("terrain.sea_floor"), std::string::npos);
    for (size_t i = 0; i < terrain.size(); ++i)
      ASSERT_TRUE(terrain.cells()[i] != 0.0F || out.terrain.cells()[i] == 0.0F) << subsidence << " cell " << i;
  }
}

}  // namespace
}  // namespace seamount::island
