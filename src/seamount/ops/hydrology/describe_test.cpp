#include "seamount/ops/hydrology/describe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/rng.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/water/flow.h"
#include "seamount/ops/hydrology/comparison.h"
#include "seamount/ops/hydrology/local_relief.h"
#include "seamount/ops/hydrology/network.h"
#include "seamount/ops/hydrology/peaks.h"

namespace seamount::hydrology {
namespace {

HeightField hills(int width, int height, uint64_t seed, float base = 300.0F, float relief = 300.0F) {
  HeightField terrain =
      geom::fbm_grid(GridFrame::centred(width, height, 30), Seed{seed}, {.wavelength_m = 900, .octaves = 6}, {});
  for (float& z : terrain.cells()) z = base + relief * z;
  return terrain;
}

const Descriptor& find(const Report& report, std::string_view name) {
  for (const Descriptor& descriptor : report.descriptors)
    if (descriptor.name == name) return descriptor;
  ADD_FAILURE() << "no " << name;
  return report.descriptors.front();
}

double value(const Report& report, std::string_view descriptor, std::string_view name, size_t subject = 0) {
  for (const Measure& measure : find(report, descriptor).measures)
    if (measure.name == name) return measure.values[subject];
  ADD_FAILURE() << "no " << name;
  return NAN;
}

TEST(LocalRelief, IsTheRangeOverTheSquare) {
  for (const auto& [width, height, radius] : {std::tuple{23, 17, 3}, {1, 9, 2}, {9, 1, 2}, {5, 6, 20}, {8, 8, 0}}) {
    const HeightField terrain = hills(width, height, 4);
    const ScalarField relief = local_relief(terrain, radius, {});
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        float low = INFINITY, high = -INFINITY;
        for (int v = std::max(0, y - radius); v <= std::min(height - 1, y + radius); ++v) {
          for (int u = std::max(0, x - radius); u <= std::min(width - 1, x + radius); ++u) {
            low = std::min(low, terrain(u, v));
            high = std::max(high, terrain(u, v));
          }
        }
        ASSERT_EQ(relief(x, y), high - low) << x << ' ' << y;
      }
    }
  }
}

/// Cells that can be reached from a cell without going below `level`.
bool reaches_higher(const HeightField& terrain, int32_t from, double level) {
  std::vector<int32_t> stack{from};
  std::vector<bool> seen(terrain.size());
  seen[static_cast<size_t>(from)] = true;
  while (!stack.empty()) {
    const int32_t cell = stack.back();
    stack.pop_back();
    if (terrain.data()[cell] > terrain.data()[from]) return true;
    for (size_t k = 0; k < 8; ++k) {
      const int x = cell % terrain.width() + geom::kFlowDx[k], y = cell / terrain.width() + geom::kFlowDy[k];
      if (!terrain.contains(x, y) || static_cast<double>(terrain(x, y)) < level) continue;
      const int32_t other = y * terrain.width() + x;
      if (seen[static_cast<size_t>(other)]) continue;
      seen[static_cast<size_t>(other)] = true;
      stack.push_back(other);
    }
  }
  return false;
}

TEST(Peaks, ProminenceAndIsolationAsDefined) {
  for (const uint64_t seed : {1, 2, 3}) {
    HeightField terrain = hills(40, 33, seed);
    terrain(20, 16) = 900.0F;
    const std::vector<Peak> peaks = find_peaks(terrain, geom::kNoSea, 1.0, {});
    ASSERT_GT(peaks.size(), 3U);
    EXPECT_EQ(peaks.front().height_m, 900.0);
    for (size_t i = 1; i < peaks.size(); ++i) {
      const Peak& peak = peaks[i];
      // A little below the key pass higher ground is reached, at it too, and above it not.
      EXPECT_TRUE(reaches_higher(terrain, peak.cell, peak.height_m - peak.prominence_m - 1e-3));
      EXPECT_FALSE(reaches_higher(terrain, peak.cell, peak.height_m - peak.prominence_m + 1e-3));
      double nearest = INFINITY;
      for (int y = 0; y < terrain.height(); ++y)
        for (int x = 0; x < terrain.width(); ++x)
          if (static_cast<double>(terrain(x, y)) > peak.height_m)
            nearest = std::min(nearest, std::hypot(x - peak.cell % terrain.width(), y - peak.cell / terrain.width()));
      EXPECT_NEAR(peak.isolation_m, 30 * nearest, 1e-9);
    }
    EXPECT_NEAR(peaks.front().isolation_m, std::hypot(40 * 30.0, 33 * 30.0), 1e-9);
  }
}

TEST(Peaks, OfIslandsStandOverTheSea) {
  HeightField terrain(GridFrame::centred(20, 9, 10), -50.0F);
  terrain(4, 4) = 30.0F;
  terrain(5, 4) = 10.0F;
  terrain(14, 4) = 80.0F;
  const std::vector<Peak> peaks = find_peaks(terrain, 0.0F, 1.0, {});
  ASSERT_EQ(peaks.size(), 2U);
  EXPECT_EQ(peaks[0].prominence_m, 80.0);
  EXPECT_EQ(peaks[1].prominence_m, 30.0);
  EXPECT_EQ(peaks[1].isolation_m, 100.0);
}

TEST(Peaks, OnTheFrameAreNotKnown) {
  const HeightField terrain = hills(128, 128, 5);
  const std::vector<Peak> peaks = find_peaks(terrain, geom::kNoSea, 1.0, {});
  EXPECT_GT(peaks.size(), 10U);
  for (const Peak& peak : peaks) {
    const int x = peak.cell % 128, y = peak.cell / 128;
    EXPECT_TRUE(x > 0 && y > 0 && x < 127 && y < 127) << x << ' ' << y;
  }
  // A table that the frame cuts, and one that it does not.
  HeightField tables(GridFrame::centred(20, 9, 10), 0.0F);
  for (int y = 2; y < 6; ++y) {
    for (int x = 0; x < 8; ++x) tables(x, y) = 80.0F;
    for (int x = 11; x < 19; ++x) tables(x, y) = 60.0F;
  }
  const std::vector<Peak> whole = find_peaks(tables, geom::kNoSea, 1.0, {});
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_EQ(whole[0].height_m, 60.0);
}

TEST(Describe, ATerrainIsNoDistanceFromItself) {
  const HeightField terrain = hills(128, 96, 6);
  const Report report = describe(terrain, &terrain, {}, {}).report;
  EXPECT_EQ(report.subjects.size(), 2U);
  EXPECT_EQ(report.descriptors.size(), 13U);
  for (const Descriptor& descriptor : report.descriptors) {
    ASSERT_TRUE(descriptor.distance.has_value()) << descriptor.name;
    EXPECT_NEAR(*descriptor.distance, 0.0, 1e-12) << descriptor.name;
    EXPECT_EQ(descriptor.plot.lines.size(), 2U);
    for (const Measure& measure : descriptor.measures) EXPECT_EQ(measure.values.size(), 2U);
  }
}

TEST(Describe, DistancesMeanWhatTheySay) {
  const HeightField terrain = hills(128, 128, 6);
  HeightField raised = terrain, steeper = terrain;
  for (float& z : raised.cells()) z += 100.0F;
  for (float& z : steeper.cells()) z = 300.0F + 3.0F * (z - 300.0F);
  const Report lift = describe(raised, &terrain, {.sea = false}, {}).report;
  EXPECT_NEAR(*find(lift, "elevation").distance, 100.0 / value(lift, "elevation", "deviation", 1), 0.02);
  for (const char* name :
       {"slope", "curvature", "aspect", "drainage_area", "prominence", "isolation", "roughness", "strahler"})
    EXPECT_NEAR(*find(lift, name).distance, 0.0, 0.02) << name;
  const Report stretch = describe(steeper, &terrain, {.sea = false}, {}).report;
  EXPECT_NEAR(*find(stretch, "roughness").distance, std::log10(3.0), 1e-3);
  EXPECT_NEAR(*find(stretch, "aspect").distance, 0.0, 1e-2);
  EXPECT_NEAR(*find(stretch, "hypsometry").distance, 0.0, 1e-2);
  EXPECT_GT(*find(stretch, "slope").distance, 1.0);
}

TEST(Describe, APlaneHasOneSlope) {
  HeightField terrain(GridFrame::centred(64, 64, 10));
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) terrain(x, y) = 1000.0F - 10.0F * static_cast<float>(x);
  const Report report = describe(terrain, nullptr, {}, {}).report;
  EXPECT_NEAR(value(report, "slope", "median"), 45.0, 0.1);
  EXPECT_NEAR(value(report, "curvature", "deviation"), 0.0, 1e-6);
  EXPECT_NEAR(value(report, "roughness", "hurst_exponent"), 1.0, 1e-3);
  for (const Descriptor& descriptor : report.descriptors) EXPECT_FALSE(descriptor.distance.has_value());
}

TEST(Describe, MeasuresDoNotDependOnTheReference) {
  const HeightField terrain = hills(128, 128, 6), rough = hills(128, 128, 9, 2000.0F, 1500.0F);
  HeightField smooth(terrain.frame(), 5.0F);
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x) smooth(x, y) += 0.001F * static_cast<float>(x * x + y);
  const DescribeParams params{.channel_m2 = 20000, .min_prominence_m = 3};
  const Report alone = describe(terrain, nullptr, params, {}).report;
  for (const HeightField& reference : {rough, smooth}) {
    const Report compared = describe(terrain, &reference, params, {}).report;
    for (const Descriptor& descriptor : alone.descriptors)
      for (const Measure& measure : descriptor.measures)
        EXPECT_EQ(value(compared, descriptor.name, measure.name), measure.values[0])
            << descriptor.name << ' ' << measure.name;
  }
}

TEST(Describe, HowFarValuesMoveIsTheSameBothWays) {
  const HeightField terrain = hills(128, 128, 6, 300.0F, 20.0F), rough = hills(128, 128, 9, 300.0F, 200.0F);
  const Report there = describe(terrain, &rough, {.sea = false}, {}).report,
               back = describe(rough, &terrain, {.sea = false}, {}).report;
  for (const char* name : {"elevation", "slope", "curvature", "local_relief"}) {
    const double moved = *find(there, name).distance * value(there, name, "deviation", 1);
    EXPECT_NEAR(*find(back, name).distance * value(back, name, "deviation", 1), moved, 1e-9 * moved) << name;
  }
  // Ten times the curvature is not cut off.
  EXPECT_GT(*find(back, "curvature").distance, 4.0);
}

TEST(Describe, GentleAndLevelGroundIsWhatItIs) {
  const HeightField plane(GridFrame::centred(32, 32, 10), 40.0F);
  const Report level = describe(plane, nullptr, {}, {}).report;
  for (const char* name : {"slope", "curvature", "local_relief"})
    for (const char* what : {"mean", "deviation", "p05", "median", "p95"}) EXPECT_EQ(value(level, name, what), 0.0);
  for (const char* what : {"mean", "p05", "median", "p95"}) EXPECT_EQ(value(level, "elevation", what), 40.0);
  HeightField ramp(GridFrame::centred(64, 16, 10), 3000.0F);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 64; ++x) ramp(x, y) += 0.125F * static_cast<float>(x);
  const Report gentle = describe(ramp, nullptr, {.relief_window_m = 20}, {}).report;
  const double slope = std::atan(0.0125) * 180.0 / std::numbers::pi;
  for (const char* what : {"mean", "p05", "median", "p95"}) EXPECT_NEAR(value(gentle, "slope", what), slope, 1e-4);
  EXPECT_NEAR(value(gentle, "local_relief", "median"), 0.25, 1e-6);
  EXPECT_NEAR(value(gentle, "elevation", "mean"), 3000.0 + 0.125 * 31.5, 1e-9);
}

TEST(Describe, WhatALandlessTerrainLacksIsNull) {
  const HeightField sea(GridFrame::centred(60, 60, 30), -200.0F), land = hills(60, 60, 1);
  for (const bool first : {true, false}) {
    const Report report = describe(first ? sea : land, first ? &land : &sea, {}, {}).report;
    for (const Descriptor& descriptor : report.descriptors) {
      EXPECT_FALSE(descriptor.distance.has_value()) << descriptor.name;
      for (const Measure& measure : descriptor.measures)
        EXPECT_TRUE(std::isnan(measure.values[first ? 0 : 1])) << descriptor.name << ' ' << measure.name;
    }
  }
}

TEST(Describe, LevelLandHasNoAspectAndNoHypsometry) {
  const HeightField level(GridFrame::centred(60, 60, 30), 20.0F), land = hills(60, 60, 1);
  const Report report = describe(level, &land, {}, {}).report;
  for (const char* name : {"aspect", "hypsometry", "slope_area", "isolation", "roughness"})
    EXPECT_FALSE(find(report, name).distance.has_value()) << name;
  EXPECT_TRUE(std::isnan(value(report, "aspect", "facing_north")));
  EXPECT_GT(*find(report, "slope").distance, 0.0);
  EXPECT_GT(*find(describe(land, &level, {}, {}).report, "slope").distance, 0.0);
}

TEST(Describe, ComparesAtTheCoarserCell) {
  HeightField fine = hills(256, 256, 6);
  GridFrame frame = fine.frame();
  frame.cell_m = 15.0;
  fine.set_frame(frame);
  const HeightField coarse = hills(128, 128, 6);
  const Report report = describe(fine, &coarse, {}, {}).report;
  EXPECT_EQ(find(report, "roughness").plot.lines[0].x.front(), 30.0);
}

double setting(const Report& report, std::string_view name, size_t subject = 0) {
  for (const Measure& measure : report.settings)
    if (measure.name == name) return measure.values[subject];
  ADD_FAILURE() << "no " << name;
  return NAN;
}

TEST(Describe, SaysWhatItsNumbersRestOn) {
  HeightField terrain = hills(128, 96, 6), reference = hills(64, 64, 7);
  for (int y = 0; y < 96; ++y) terrain(0, y) = -5.0F;
  GridFrame coarse = reference.frame();
  coarse.cell_m = 60.0;
  reference.set_frame(coarse);
  const Report report = describe(terrain, &reference, {.relief_window_m = 500, .min_prominence_m = 12}, {}).report;
  for (const size_t subject : {size_t{0}, size_t{1}}) {
    EXPECT_EQ(setting(report, "cell", subject), 60.0);
    EXPECT_EQ(setting(report, "relief_window", subject), 9 * 60.0);
    EXPECT_EQ(setting(report, "min_prominence", subject), 12.0);
  }
  EXPECT_EQ(setting(report, "land", 1), 64 * 64 * 3600.0);
  EXPECT_EQ(setting(report, "channel"), setting(report, "land") / 2000.0);
  // With them the same numbers come again.
  const Report again = describe(reference, nullptr,
                                {.relief_window_m = setting(report, "relief_window"),
                                 .channel_m2 = setting(report, "channel"),
                                 .min_prominence_m = setting(report, "min_prominence")},
                                {})
                           .report;
  EXPECT_EQ(value(again, "prominence", "peaks"), value(report, "prominence", "peaks", 1));
  EXPECT_EQ(value(again, "strahler", "streams_of_order_1"), value(report, "strahler", "streams_of_order_1", 1));
  EXPECT_GT(value(report, "strahler", "streams_of_order_1"), value(report, "strahler", "streams_of_order_2"));
}

TEST(Describe, KnowsTheWayThatSlopesFace) {
  HeightField east(GridFrame::centred(64, 64, 10)), cone = east;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      east(x, y) = 1000.0F - 10.0F * static_cast<float>(x);
      cone(x, y) = 1000.0F - static_cast<float>(std::hypot(x - 31.5, y - 31.5));
    }
  }
  const Report report = describe(east, &cone, {}, {}).report;
  EXPECT_NEAR(value(report, "aspect", "mean_direction"), 90.0, 1e-3);
  EXPECT_NEAR(value(report, "aspect", "direction_strength"), 1.0, 1e-6);
  EXPECT_NEAR(value(report, "aspect", "direction_strength", 1), 0.0, 1e-3);
}

TEST(Describe, DrawsThePeaksOfTheTerrain) {
  const HeightField terrain = hills(128, 96, 6), reference = hills(64, 64, 7);
  const Described described = describe(terrain, &reference, {.min_prominence_m = 5}, {});
  ASSERT_EQ(static_cast<double>(described.peaks.points.size()), value(described.report, "prominence", "peaks"));
  ASSERT_FALSE(described.peaks.points.empty());
  EXPECT_TRUE(described.peaks.heights);
  const GridFrame& frame = terrain.frame();
  for (const ValuedPoint& peak : described.peaks.points) {
    const int x = static_cast<int>(std::lround(frame.column(peak.place.x))),
              y = static_cast<int>(std::lround(frame.row(peak.place.y)));
    EXPECT_EQ(peak.value, static_cast<double>(terrain(x, y)));
    ASSERT_EQ(peak.attributes.size(), 2U);
    EXPECT_EQ(peak.attributes[0].name, "prominence_m");
    EXPECT_GE(peak.attributes[0].value, 5.0);
    EXPECT_EQ(peak.attributes[1].name, "isolation_m");
  }
}

TEST(Describe, RefusesCellsFinerThanTheData) {
  const HeightField terrain = hills(20, 20, 6);  // cells of 30 m
  HeightField fine = terrain;
  fine.set_frame(GridFrame::centred(20, 20, 10));
  try {
    describe(fine, &terrain, {.cell_m = 15}, {});
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_EQ(error.field(), "cell_m");
    EXPECT_STREQ(error.what(), "cell_m: 15 is finer than the cells of the coarser input, 30 m");
  }
  EXPECT_THROW(describe(fine, nullptr, {.cell_m = 0.01}, {}), InvalidArgument);
  EXPECT_NO_THROW(describe(fine, nullptr, {.cell_m = 15}, {}));
  EXPECT_NO_THROW(describe(fine, &terrain, {.cell_m = 30.0 * (1.0 - 1e-12)}, {}));
}

TEST(Comparison, CellsAreFewEnoughToBeNumbered) {
  EXPECT_EQ(frame_at(GridFrame::centred(46000, 46000, 1), 2.0).width, 23000);
  EXPECT_EQ(frame_at(GridFrame::centred(3, 700, 1), 10.0).width, 1);
  EXPECT_NO_THROW(frame_at(GridFrame::centred(46338, 46338, 1), 1.0));
  EXPECT_THROW(frame_at(GridFrame::centred(46339, 46339, 1), 1.0), InvalidArgument);
  EXPECT_THROW(frame_at(GridFrame::centred(2000000, 2000000, 1), 2.0), InvalidArgument);
}

TEST(Comparison, AnIslandIsMeasuredAsOneHoweverWideTheSea) {
  HeightField island = hills(40, 40, 3), sea(GridFrame::centred(120, 120, 30), -100.0F);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x) sea(x + 40, y + 40) = island(x, y);
  const SurveyPlan near = make_plan({find_land(island, 0.0F)}, 0.0F, 500.0, {}, {}),
                   far = make_plan({find_land(sea, 0.0F)}, 0.0F, 500.0, {}, {});
  EXPECT_NEAR(near.channel_m2, 1600 * 900 / 2000.0, 1e-9);
  EXPECT_EQ(near.channel_m2, far.channel_m2);
  EXPECT_EQ(near.min_prominence_m, far.min_prominence_m);
  const HeightField water(GridFrame::centred(10, 10, 30), -5.0F);
  EXPECT_EQ(make_plan({find_land(sea, 0.0F), find_land(water, 0.0F)}, 0.0F, 500.0, {}, {}).min_prominence_m,
            far.min_prominence_m);
  EXPECT_EQ(make_plan({find_land(water, 0.0F)}, 0.0F, 500.0, {}, {}).channel_m2, 100 * 900 / 2000.0);
  EXPECT_EQ(make_plan({find_land(water, 0.0F)}, 0.0F, 500.0, 7.0, 8.0).channel_m2, 7.0);
}

TEST(Describe, BearsWhatHasNothingToMeasure) {
  const HeightField reference = hills(60, 60, 1);
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 12}, {12, 1}, {3, 4}}) {
    for (const float z : {-20.0F, 5.0F}) {
      const HeightField terrain(GridFrame::centred(width, height, 30), z);
      const Report report = describe(terrain, &reference, {}, {}).report;
      for (const Descriptor& descriptor : report.descriptors) {
        EXPECT_TRUE(std::isfinite(descriptor.distance.value_or(0.0))) << descriptor.name;
        for (const PlotLine& line : descriptor.plot.lines)
          for (const double y : line.y) EXPECT_TRUE(std::isfinite(y)) << descriptor.name;
      }
      EXPECT_EQ(describe(reference, &terrain, {}, {}).report.descriptors.size(), 13U);
    }
  }
}

TEST(Network, StreamsCountLinksOfOneOrderOnce) {
  // A river of order 2 that takes in two more heads on its way: three links, one stream.
  std::vector<Link> links(7);
  for (size_t i = 0; i < 4; ++i) links[i].order = 1;
  for (size_t i = 4; i < 7; ++i) links[i].order = 2;
  links[0].next = links[1].next = 4;
  links[2].next = links[4].next = 5;
  links[3].next = links[5].next = 6;
  EXPECT_THAT(streams_by_order(links), ::testing::ElementsAre(4, 1));
}

/// Half of a terrain without heights: what is measured on the rest is what the rest has, no cliffs along the rim.
TEST(Describe, UnknownCellsAreNoLand) {
  HeightField plane(GridFrame::centred(100, 80, 30.0));
  for (int y = 0; y < 80; ++y)
    for (int x = 0; x < 100; ++x) plane(x, y) = static_cast<float>(500 + 6 * x);
  HeightField half = plane;
  for (int y = 0; y < 80; ++y)
    for (int x = 60; x < 100; ++x) half(x, y) = std::numeric_limits<float>::quiet_NaN();
  const Described out = describe(half, nullptr, {}, {});
  std::vector<double> slopes;
  for (const Descriptor& descriptor : out.report.descriptors) {
    if (descriptor.name != "slope") continue;
    for (const Measure& measure : descriptor.measures)
      if (measure.name == "mean") slopes = measure.values;
  }
  ASSERT_EQ(slopes.size(), 1U);
  EXPECT_NEAR(slopes[0], std::atan(0.2) * 180 / 3.14159265358979, 0.1);
}

}  // namespace
}  // namespace seamount::hydrology
