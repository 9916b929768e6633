#include "seamount/ops/render/land_cover.h"

#include <gtest/gtest.h>

#include <string_view>

namespace seamount::render {
namespace {

/// Mean albedo of many places that are alike.
Rgb mean_albedo(SurfacePoint point, const Climate& climate) {
  Rgb sum;
  for (int i = 0; i < 900; ++i) {
    point.x = 331.0F * static_cast<float>(i % 30);
    point.y = 357.0F * static_cast<float>(i / 30);
    sum += natural_land(point, climate).albedo;
  }
  return (1.0F / 900.0F) * sum;
}

Climate at(double latitude_deg, std::optional<double> rain_mm = {}, Rock rock = Rock::granite) {
  return climate_of({.latitude_deg = latitude_deg, .rain_mm_yr = rain_mm}, {}, {}, rock, {.in_sea = false});
}

SurfacePoint hillside(float z, float slope = 0.2F) { return {.z = z, .slope = slope, .footprint = 8.0F}; }

TEST(Climate, SnowAndTreesEndLowerTowardsThePoles) {
  for (double latitude = 30.0; latitude < 88.0; latitude += 2.0) {
    EXPECT_GE(snow_line_at(latitude), snow_line_at(latitude + 2.0));
    EXPECT_GE(tree_line_at(latitude), tree_line_at(latitude + 2.0));
  }
  for (double latitude = 0.0; latitude <= 90.0; latitude += 1.0) {
    EXPECT_GT(snow_line_at(latitude) + 2.0F, tree_line_at(latitude));
    EXPECT_EQ(snow_line_at(latitude), snow_line_at(-latitude));
  }
  // Places of NATURE's kind: the Alps, the Himalaya's south side, Spitsbergen.
  EXPECT_NEAR(snow_line_at(47.0), 2850.0F, 350.0F);
  EXPECT_NEAR(snow_line_at(28.0), 5700.0F, 300.0F);
  EXPECT_NEAR(snow_line_at(78.0), 450.0F, 150.0F);
}

TEST(Climate, WhatIsStatedHolds) {
  const Climate climate = climate_of({.latitude_deg = 10, .rain_mm_yr = 123, .wind_from_deg = 90}, 1500.0, 2600.0,
                                     Rock::sandstone, {.in_sea = true});
  EXPECT_EQ(climate.rain_mm, 123.0F);
  EXPECT_EQ(climate.tree_line, 1500.0F);
  EXPECT_EQ(climate.snow_line, 2600.0F);
  EXPECT_EQ(climate.rock, Rock::sandstone);
  EXPECT_NEAR(climate.wind_from, 1.5708F, 1e-4F);
}

Climate preset_climate(std::string_view name) {
  ClimateParams params;
  for (const auto& row : ClimateParams::presets())
    if (row.name == name) row.set(params);
  return climate_of(params, {}, {}, Rock::granite, {.in_sea = true});
}

TEST(ClimatePresets, LookLikeTheirWords) {
  const auto ground = [](std::string_view name, float z) { return mean_albedo(hillside(z), preset_climate(name)); };
  for (const float z : {100.0F, 400.0F}) {
    const Rgb tropical = ground("tropical", z), temperate = ground("temperate", z), arid = ground("arid", z);
    EXPECT_GT(tropical.g, tropical.r) << z;
    EXPECT_GT(temperate.g, temperate.r) << z;
    EXPECT_GT(arid.r, arid.g) << z;
    EXPECT_LT(luminance(tropical), luminance(temperate)) << z;
    EXPECT_LT(luminance(temperate), luminance(arid)) << z;
  }
  EXPECT_GT(luminance(ground("polar", 900.0F)), 0.55F) << "snow";
  EXPECT_LT(luminance(ground("polar", 30.0F)), 0.35F) << "tundra";
  EXPECT_LT(luminance(ground("temperate", 900.0F)), 0.3F) << "no snow";
  EXPECT_GT(luminance(ground("temperate", 4200.0F)), 0.55F) << "snow on high mountains";
}

TEST(LandCover, SnowLiesAboveTheSnowLineOfTheLatitude) {
  for (const double latitude : {-75.0, -50.0, -20.0, 0.0, 28.0, 46.0, 65.0}) {
    const Climate climate = at(latitude);
    EXPECT_GT(luminance(mean_albedo(hillside(climate.snow_line + 900.0F), climate)), 0.55F) << latitude;
    EXPECT_LT(luminance(mean_albedo(hillside(climate.snow_line - 900.0F), climate)), 0.30F) << latitude;
  }
}

TEST(LandCover, DesertsArePaleAndRedForestsDarkAndGreen) {
  for (const double latitude : {5.0, 25.0, 38.0}) {
    const Rgb desert = mean_albedo(hillside(300.0F), at(latitude, 80.0)),
              steppe = mean_albedo(hillside(300.0F), at(latitude, 500.0)),
              forest = mean_albedo(hillside(300.0F), at(latitude, 3500.0));
    EXPECT_GT(luminance(desert), 1.2F * luminance(steppe));
    EXPECT_GT(luminance(steppe), 1.5F * luminance(forest));
    EXPECT_GT(desert.r, 1.2F * desert.g);
    EXPECT_GT(forest.g, 1.1F * forest.r);
  }
}

TEST(LandCover, RockShowsOnWallsAndPlantsOnSlopesThatHoldThem) {
  const Climate alps = at(46.0, 1200.0);
  const float wood = luminance(mean_albedo(hillside(900.0F, 0.4F), alps)),
              wall = luminance(mean_albedo(hillside(900.0F, 2.2F), alps));
  EXPECT_GT(wall, 1.8F * wood);
  // The wet tropics hold steeper ground.
  const Climate wet = at(5.0, 4000.0);
  const Rgb cliff = mean_albedo(hillside(300.0F, 1.05F), wet), dry = mean_albedo(hillside(300.0F, 1.05F), alps);
  EXPECT_GT(cliff.g / cliff.r, 1.15F);
  EXPECT_LT(dry.g / dry.r, 1.05F);
}

TEST(LandCover, BeachesAreNarrow) {
  const Climate climate = at(10.0, 3000.0);
  SurfacePoint flat = {.z = 1.5F, .slope = 0.01F, .footprint = 4.0F};
  flat.shore_m = 10.0F;
  const float at_sea = luminance(mean_albedo(flat, climate));
  flat.shore_m = 300.0F;  // a plain behind it that lies as low
  EXPECT_GT(at_sea, 2.0F * luminance(mean_albedo(flat, climate)));
}

TEST(LandCover, AlbedosArePhysicalAndEdgesSoft) {
  for (const Rock rock : {Rock::granite, Rock::basalt, Rock::limestone, Rock::sandstone})
    for (const double latitude : {0.0, 45.0, 80.0})
      for (float z = 1.0F; z < 7000.0F; z += 83.0F)
        for (const float slope : {0.0F, 0.7F, 3.0F}) {
          const Climate climate = at(latitude, {}, rock);
          const SurfacePoint p{.x = 3.1F * z, .y = z, .z = z, .slope = slope};
          SurfacePoint next = p;
          next.z += 0.05F;
          const Rgb a = natural_land(p, climate).albedo, b = natural_land(next, climate).albedo;
          for (const float channel : {a.r, a.g, a.b}) {
            EXPECT_GT(channel, 0.0F);
            EXPECT_LT(channel, 1.0F);
          }
          EXPECT_NEAR(a.g, b.g, 0.02F);
        }
}

}  // namespace
}  // namespace seamount::render
