#include "seamount/ops/contour/convert/extract.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "seamount/geom/contour/nesting.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/tin/test_tin.h"

namespace seamount::contour {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Two hills, one with a crater, falling to the west.
double hills(Vec2 p) {
  const double a = 80 * std::exp(-(dot(p - Vec2{-30, 0}, p - Vec2{-30, 0})) / 300);
  const double r = std::hypot(p.x - 30, p.y - 5);
  return a + 60 * std::exp(-(r - 12) * (r - 12) / 60) + 0.1 * p.x;
}

HeightField raster() {
  const GridFrame frame = GridFrame::centred(60, 40, 2.0);
  HeightField field(frame);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 60; ++x) field(x, y) = static_cast<float>(hills({frame.x(x), frame.y(y)}));
  return field;
}

Tin network() { return geom::lattice_tin(61, 41, 2.0, Seed{2}, hills); }

std::vector<double> heights_of(const ContourSet& set) {
  std::vector<double> heights;
  for (const Contour& c : set.contours) heights.push_back(c.height_m);
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  return heights;
}

void expect_sound(const ContourSet& set) {
  EXPECT_FALSE(geom::find_contour_crossing(set.contours));
  std::vector<Contour> turned = set.contours;
  geom::orient_contours(turned);
  for (size_t i = 0; i < turned.size(); ++i) {
    EXPECT_LT(set.contours[i].parent, static_cast<int>(i));
    EXPECT_EQ(geom::is_hill(turned[i]), geom::is_hill(set.contours[i])) << "heights alone say the same";
  }
}

template <class Call>
std::string message_of(Call&& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(ContourExtract, NestsAndOrientsNetworksAndTerrainsAlike) {
  ExtractParams params;
  params.interval_m = 10.0;
  const ContourSet from_tin = extract(network(), params, {});
  const ContourSet from_raster = extract(raster(), params, {});
  for (const ContourSet* set : {&from_tin, &from_raster}) {
    expect_sound(*set);
    EXPECT_THAT(heights_of(*set), ElementsAre(0, 10, 20, 30, 40, 50, 60, 70));
    const auto basins =
        std::count_if(set->contours.begin(), set->contours.end(), [](const Contour& c) { return !geom::is_hill(c); });
    EXPECT_GE(basins, 4) << "the crater";
  }
  EXPECT_EQ(from_tin.frame, network().frame);
}

TEST(ContourExtract, LevelsByListIntervalAndCount) {
  const Tin tin = network();
  ExtractParams params;
  params.levels_m = {40, 20, 40};
  EXPECT_THAT(heights_of(extract(tin, params, {})), ElementsAre(20, 40));
  params.levels_m = {};
  params.interval_m = 30;
  params.base_m = 5;
  EXPECT_THAT(heights_of(extract(tin, params, {})), ElementsAre(5, 35, 65));
  params.interval_m = std::nullopt;
  params.count = 7;
  EXPECT_EQ(heights_of(extract(tin, params, {})).size(), 7U);
}

TEST(ContourExtract, TheLowestHeightEnclosesEverything) {
  HeightField field = raster();
  const float low = *std::min_element(field.cells().begin(), field.cells().end());
  ExtractParams params;
  params.levels_m = {low};
  const ContourSet set = extract(field, params, {});
  ASSERT_EQ(set.contours.size(), 1U);
  EXPECT_GT(geom::signed_area(set.contours[0].ring), 120.0 * 80.0);
}

TEST(ContourExtract, FlatAndTinyTerrains) {
  EXPECT_EQ(extract(HeightField({1, 1, 5, 0, 0, {}}, 7.0F), {}, {}).contours.size(), 1U);
  EXPECT_EQ(extract(HeightField({9, 1, 5, 0, 0, {}}, 7.0F), {}, {}).contours.size(), 1U);
}

TEST(ContourExtract, LeavesOutTheSmallWithAllInside) {
  ExtractParams params;
  params.interval_m = 5.0;
  const ContourSet all = extract(raster(), params, {});
  params.min_area_m2 = 400;
  params.min_length_m = 90;
  const ContourSet some = extract(raster(), params, {});
  EXPECT_LT(some.contours.size(), all.contours.size());
  expect_sound(some);
  for (const Contour& c : some.contours) {
    EXPECT_GE(std::abs(geom::signed_area(c.ring)), 400);
    EXPECT_GE(geom::ring_length(c.ring), 90);
  }
}

TEST(ContourExtract, SimplifiesWithoutCrossings) {
  ExtractParams params;
  params.interval_m = 2.0;
  params.simplify_m = 1.0;
  const ContourSet set = extract(raster(), params, {});
  expect_sound(set);
}

/// A level of a rounded summit or a coast is not worth an error, but said.
TEST(ContourExtract, LevelsJustOutsideAreLeftOutAndSaid) {
  const HeightField terrain = raster();
  const auto [low, high] = std::minmax_element(terrain.cells().begin(), terrain.cells().end());
  const double relief = *high - *low;
  std::string said;
  RunContext run;
  run.note = [&](const std::string& line) { said += line; };
  ExtractParams params;
  params.levels_m = {*low + 0.5 * relief};
  const ContourSet plain = extract(terrain, params, run);
  EXPECT_EQ(said, "");
  params.levels_m = {*low - 0.009 * relief, *low + 0.5 * relief, *high + 0.009 * relief};
  const ContourSet set = extract(terrain, params, run);
  EXPECT_EQ(set.contours.size(), plain.contours.size());
  EXPECT_THAT(said, HasSubstr("there are no contours at "));
  EXPECT_THAT(said, HasSubstr("just outside the heights"));
  params.levels_m = {*low + 0.5 * relief, *high + 0.011 * relief};
  EXPECT_THAT(message_of([&] { extract(terrain, params, run); }), HasSubstr("is outside the heights"));
  params.levels_m = {*high + 0.005 * relief};
  EXPECT_THAT(message_of([&] { extract(terrain, params, run); }), HasSubstr("is outside the heights"));
}

TEST(ContourExtract, SaysWhatIsWrong) {
  ExtractParams params;
  params.levels_m = {20, 900};
  EXPECT_THAT(message_of([&] { extract(raster(), params, {}); }),
              HasSubstr("levels_m: 900 m is outside the heights, which are -5.87 m to"));
  params.levels_m = {};
  params.interval_m = 5000;
  params.base_m = 2000;
  EXPECT_THAT(message_of([&] { extract(raster(), params, {}); }), HasSubstr("interval_m: no multiple of 5000 m"));
  params.interval_m = 0.01;
  EXPECT_THAT(message_of([&] { extract(raster(), params, {}); }), HasSubstr("at most 5000 are allowed"));
  Tin bare = network();
  bare.height_m.clear();
  EXPECT_THAT(message_of([&] { extract(bare, {}, {}); }), HasSubstr("tin: has no heights yet"));
  EXPECT_THAT(message_of([&] { extract(Tin{}, {}, {}); }), HasSubstr("tin: has no triangles"));
  HeightField broken = raster();
  broken(3, 3) = std::numeric_limits<float>::infinity();
  EXPECT_THAT(message_of([&] { extract(broken, {}, {}); }), HasSubstr("terrain: has an infinite height"));
}

/// Contours close along the rim of a hole, and no level lies beyond what is known.
TEST(ContourExtract, HolesAreOutside) {
  HeightField terrain(GridFrame::centred(60, 60, 10.0));
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 60; ++x)
      terrain(x, y) = std::hypot(x - 30, y - 30) < 8 ? std::nanf("") : static_cast<float>(10 * x);
  ExtractParams params;
  params.interval_m = 50;
  const ContourSet set = extract(terrain, params, {});
  ASSERT_FALSE(set.contours.empty());
  for (const Contour& contour : set.contours) {
    EXPECT_GE(contour.height_m, 0);
    EXPECT_LE(contour.height_m, 590);
    for (const Vec2 p : contour.ring) EXPECT_GT(std::hypot(p.x - 5, p.y + 5), 60) << contour.height_m;
  }
}

}  // namespace
}  // namespace seamount::contour
