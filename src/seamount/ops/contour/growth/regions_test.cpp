#include "seamount/ops/contour/growth/regions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "seamount/base/error.h"
#include "seamount/base/rng.h"
#include "seamount/geom/polygon/polygon.h"

namespace seamount::contour {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const GridFrame kDomain = GridFrame::centred(100, 80, 10);

Ring square(double half, Vec2 centre = {}) {
  return {centre + Vec2{-half, -half}, centre + Vec2{half, -half}, centre + Vec2{half, half},
          centre + Vec2{-half, half}};
}

Ring circle(double radius, Vec2 centre = {}, int points = 64) {
  Ring ring;
  for (int i = 0; i < points; ++i) {
    const double a = 2.0 * std::numbers::pi * i / points;
    ring.push_back(centre + Vec2{radius * std::cos(a), radius * std::sin(a)});
  }
  return ring;
}

std::string message(const std::vector<RegionOutline>& outlines) {
  try {
    regions_from_outlines(outlines, kDomain, "regions");
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

const GrowthRegion& named(const RegionTree& tree, const std::string& name) {
  for (const GrowthRegion& region : tree.regions) {
    if (region.name == name) return region;
  }
  throw Error("no region " + name);
}

std::string parent_name(const RegionTree& tree, const std::string& name) {
  const int parent = named(tree, name).parent;
  return parent < 0 ? "" : tree.regions[static_cast<size_t>(parent)].name;
}

TEST(Regions, DrawnOutlinesNestInAnyOrderAndDirection) {
  Ring clockwise = square(50, {-100, 0});
  std::reverse(clockwise.begin(), clockwise.end());
  Ring repeated = square(300);
  repeated.push_back(repeated.front());
  const RegionTree tree = regions_from_outlines({{"west", clockwise, 200.0, false},
                                                 {"east", square(60, {100, 0}), {}, false},
                                                 {"crater", square(20, {100, 0}), 100.0, true},
                                                 {"isle", repeated, 0.0, false}},
                                                kDomain, "regions");
  ASSERT_EQ(tree.regions.size(), 4U);
  EXPECT_EQ(parent_name(tree, "isle"), "");
  EXPECT_EQ(parent_name(tree, "west"), "isle");
  EXPECT_EQ(parent_name(tree, "east"), "isle");
  EXPECT_EQ(parent_name(tree, "crater"), "east");
  EXPECT_TRUE(named(tree, "crater").basin);
  for (size_t i = 0; i < tree.regions.size(); ++i) {
    EXPECT_LT(tree.regions[i].parent, static_cast<int>(i));
    EXPECT_GT(geom::signed_area(tree.regions[i].outline), 0.0);
    EXPECT_EQ(tree.regions[i].outline.size(), 4U);
  }
}

TEST(Regions, MessagesNameRegionsAndPlaces) {
  EXPECT_THAT(message({}), HasSubstr("no regions"));
  EXPECT_THAT(message({{"a", {{0, 0}, {1, 1}}, {}, false}}), AllOf(HasSubstr("'a'"), HasSubstr("needs at least 3")));
  EXPECT_THAT(message({{"bow", {{0, 0}, {100, 100}, {100, 0}, {0, 100}}, {}, false}}),
              AllOf(HasSubstr("'bow'"), HasSubstr("of the outline"), HasSubstr("(50, 50)")));
  EXPECT_THAT(message({{"a", square(100), {}, false}, {"b", square(100, {150, 40}), {}, false}}),
              AllOf(HasSubstr("'a' and 'b' overlap without nesting"), HasSubstr("at (")));
  EXPECT_THAT(message({{"a", square(100), {}, false}, {"b", square(50, {50, 0}), {}, false}}),
              HasSubstr("cross or touch at (100"));
  EXPECT_THAT(message({{"", square(10, {600, 0}), {}, false}}),
              AllOf(HasSubstr("'region 0' lies wholly outside the domain"), HasSubstr("(500, 400)")));
  EXPECT_THAT(message({{"low", square(100), 300.0, false}, {"high", square(50), 200.0, false}}),
              AllOf(HasSubstr("'high' at 200 m"), HasSubstr("not higher than 'low' at 300 m"), HasSubstr("basin")));
  EXPECT_THAT(message({{"a", square(10), std::nan(""), false}}), HasSubstr("is outside [-20000, 20000]"));
  EXPECT_THAT(message({{"a", square(100), 300.0, false, 250.0}}),
              HasSubstr("its peak at 250 m is not higher than its outline at 300 m"));
  EXPECT_EQ(message({{"rim", square(100), 300.0, false}, {"floor", square(50), 200.0, true}}), "");
  EXPECT_THAT(
      message({{"land", square(200), 0.0, false}, {"a", square(100), 300.0, true}, {"b", square(50), 300.0, true}}),
      HasSubstr("not lower"));
  EXPECT_THAT(message({{"pit", square(100), {}, true}}), HasSubstr("'pit' (near (-100, -100)) lies in no region"));
  // A region may reach beyond the domain, or hold all of it.
  EXPECT_EQ(message({{"a", square(2000), {}, false}, {"b", square(300, {400, 0}), {}, false}}), "");
}

TEST(Regions, HeightsAreComparedAcrossRegionsWithoutOne) {
  EXPECT_THAT(
      message({{"a", square(100), 300.0, false}, {"b", square(60), {}, false}, {"c", square(20), 250.0, false}}),
      HasSubstr("'c' at 250 m"));
}

TEST(Regions, DrawingsGiveHolesAndDepressions) {
  Drawing drawing;
  drawing.areas.push_back({"land", {{square(300), {square(40, {-200, 0})}}}});
  drawing.lines.push_back({square(200, {90, 0}), 100.0, true});
  drawing.lines.push_back({square(100, {90, 0}), 100.0, true});
  drawing.lines.push_back({square(50, {90, 0}), 80.0, true});
  const RegionTree tree = regions_from_drawing(drawing, kDomain, "regions");
  EXPECT_EQ(parent_name(tree, "land (hole 0)"), "land");
  EXPECT_TRUE(named(tree, "land (hole 0)").basin);
  EXPECT_FALSE(named(tree, "line 0").basin);
  EXPECT_TRUE(named(tree, "line 1").basin);
  EXPECT_TRUE(named(tree, "line 2").basin);
  EXPECT_EQ(named(tree, "line 2").height_m, 80.0);
}

TEST(Regions, AreasCarryTheirHeightsPeaksAndBasins) {
  Drawing drawing;
  drawing.areas = {{"land", {{square(300), {}}}, {{"height_m", 5}}},
                   {"hill", {{square(80, {-100, 0}), {}}}, {{"HEIGHT_M", 120}, {"Peak_m", 300}}},
                   {"crater", {{square(80, {100, 0}), {}}}, {{"basin", 1}, {"height_m", 4}}}};
  const RegionTree tree = regions_from_drawing(drawing, kDomain, "regions");
  ASSERT_EQ(tree.regions.size(), 3U);
  EXPECT_EQ(tree.regions[0].height_m, 5.0);
  EXPECT_EQ(tree.regions[1].height_m, 120.0);
  EXPECT_EQ(tree.regions[1].peak_m, 300.0);
  EXPECT_FALSE(tree.regions[1].basin);
  EXPECT_TRUE(tree.regions[2].basin);
}

TEST(Regions, AHoleMayTouchItsShell) {
  Drawing drawing;
  drawing.areas = {{"land", {{square(300), {{{-300, 0}, {-200, -50}, {-200, 50}}}}}}};
  const RegionTree tree = regions_from_drawing(drawing, kDomain, "regions");
  ASSERT_EQ(tree.regions.size(), 2U);
  EXPECT_EQ(tree.regions[1].parent, 0);
  EXPECT_TRUE(tree.regions[1].basin);
}

TEST(Regions, LinesThatMeetEndToEndEnclose) {
  Drawing drawing;
  drawing.lines = {{{{-100, -100}, {100, -100}, {100, 100}}, 7, false, {}},
                   {{{-100, -100}, {-100, 100}, {100, 100}}, 7, false, {}}};
  const RegionTree tree = regions_from_drawing(drawing, kDomain, "regions");
  ASSERT_EQ(tree.regions.size(), 1U);
  EXPECT_EQ(std::abs(geom::signed_area(tree.regions[0].outline)), 40000.0);
  EXPECT_EQ(tree.regions[0].height_m, 7.0);
}

TEST(Regions, OpenLinesAreRefusedWithTheirEnds) {
  Drawing drawing;
  drawing.lines.push_back({{{0, 0}, {50, 0}, {50, 70}}, 10.0, false});
  try {
    regions_from_drawing(drawing, kDomain, "regions");
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("line 0 is open"), HasSubstr("(0, 0)"), HasSubstr("(50, 70)")));
  }
}

TEST(Regions, ContoursKeepTheirHeightsAndBasins) {
  ContourSet set{kDomain, {{100.0, square(300), -1}, {200.0, square(200), 0}, {200.0, square(100), 1}}};
  std::reverse(set.contours[2].ring.begin(), set.contours[2].ring.end());
  const RegionTree tree = regions_from_contours(set, kDomain, "contours");
  ASSERT_EQ(tree.regions.size(), 3U);
  EXPECT_EQ(tree.regions[2].parent, 1);
  EXPECT_TRUE(tree.regions[2].basin);
  EXPECT_EQ(tree.regions[1].height_m, 200.0);
}

TEST(Regions, SummitsOfContoursStayBelowTheNextLevelAndWiderOnesRiseHigher) {
  ContourSet set{kDomain,
                 {{100.0, square(400), -1},
                  {200.0, square(30, {-250, 0}), 0},
                  {200.0, square(90, {0, 0}), 0},
                  {200.0, square(90, {250, 0}), 0},
                  {300.0, square(60, {250, 0}), 3},
                  {100.0, square(20, {0, 300}), 0}}};
  std::reverse(set.contours[5].ring.begin(), set.contours[5].ring.end());
  const RegionTree tree = regions_from_contours(set, kDomain, "contours");
  std::map<double, std::vector<std::optional<double>>> peaks;  // by height, widest first
  for (const GrowthRegion& r : tree.regions) {
    if (r.basin) {
      EXPECT_FALSE(r.peak_m) << "nothing bounds a floor under the lowest level";
    } else {
      peaks[*r.height_m].push_back(r.peak_m);
    }
  }
  EXPECT_FALSE(peaks[100.0][0]);
  EXPECT_FALSE(peaks[300.0][0]) << "the highest level";
  ASSERT_EQ(peaks[200.0].size(), 3U);
  std::vector<double> known;
  for (const std::optional<double>& peak : peaks[200.0]) {
    if (peak) known.push_back(*peak);
  }
  ASSERT_EQ(known.size(), 2U) << "a summit has a peak, what has a hill in it none";
  EXPECT_GT(known[0], known[1]);
  EXPECT_GT(known[1], 200.0);
  EXPECT_LT(known[0], 285.0);
}

TEST(Regions, LookupAgreesWithBruteForce) {
  std::vector<RegionOutline> outlines;
  for (int i = 0; i < 12; ++i) outlines.push_back({"", circle(30.0 * (i + 1), {2.0 * i, -1.0 * i}, 30 + i), {}, false});
  outlines.push_back({"", circle(7, {0, 0}, 5), {}, false});
  outlines.push_back({"", circle(7, {15, 0}, 9), {}, false});
  const RegionTree tree = regions_from_outlines(outlines, kDomain, "regions");
  Rng rng(Seed{3});
  std::vector<Vec2> points;
  for (int i = 0; i < 5000; ++i) points.push_back({rng.uniform(-600, 600), rng.uniform(-600, 600)});
  for (const GrowthRegion& region : tree.regions)
    points.insert(points.end(), region.outline.begin(), region.outline.end());
  const std::vector<int32_t> found = regions_at(tree, points, {});
  for (size_t i = 0; i < points.size(); ++i) ASSERT_EQ(found[i], region_at(tree, points[i])) << i;
}

/// Discs of grey on black, with soft edges and noise.
Image painted(double softness, double noise) {
  Image image(200, 160);
  Rng rng(Seed{9});
  const auto disc = [&](int x, int y, Vec2 centre, double radius) {
    const double d = radius - std::hypot(x + 0.5 - centre.x, y + 0.5 - centre.y);
    return softness > 0.0 ? std::clamp(d / softness + 0.5, 0.0, 1.0) : (d >= 0.0 ? 1.0 : 0.0);
  };
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      double grey = 90.0 * disc(x, y, {100, 80}, 60);
      grey += (180.0 - grey) * disc(x, y, {85, 80}, 35);
      grey += (250.0 - grey) * disc(x, y, {75, 80}, 10);
      grey += (90.0 - grey) * disc(x, y, {100, 80}, 8);   // a basin
      grey += (250.0 - grey) * disc(x, y, {140, 80}, 9);  // two levels up at once
      const auto g = static_cast<uint8_t>(std::clamp(std::lround(grey + noise * rng.uniform(-1, 1)), 0L, 255L));
      for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = g;
    }
  }
  return image;
}

TEST(RegionPicture, GreyLevelsAreNestedRegions) {
  for (const auto& [softness, noise] : {std::pair{0.0, 0.0}, {2.0, 0.0}, {2.0, 5.0}}) {
    const RegionTree tree = regions_from_image(painted(softness, noise), kDomain, {}, "mask", {});
    // The isle, the hill, its summit and basin, and the steep hill as two outlines.
    ASSERT_EQ(tree.regions.size(), 6U) << softness << " " << noise;
    // 200 x 160 pixels over 1000 x 800 m: 5 m a pixel, x east and y north of the middle.
    const auto at = [&](double px, double py) { return region_at(tree, {5.0 * (px - 100), 5.0 * (80 - py)}); };
    EXPECT_EQ(at(2, 2), -1);
    const int isle = at(100, 130);
    const int hill = at(85, 60);
    const int summit = at(75, 80);
    const int basin = at(100, 80);
    const int steep = at(140, 80);
    EXPECT_EQ(tree.regions[static_cast<size_t>(isle)].parent, -1);
    EXPECT_EQ(tree.regions[static_cast<size_t>(hill)].parent, isle);
    EXPECT_EQ(tree.regions[static_cast<size_t>(summit)].parent, hill);
    EXPECT_EQ(tree.regions[static_cast<size_t>(basin)].parent, hill);
    EXPECT_TRUE(tree.regions[static_cast<size_t>(basin)].basin);
    const int foot = tree.regions[static_cast<size_t>(steep)].parent;
    EXPECT_EQ(tree.regions[static_cast<size_t>(foot)].parent, isle);
    // Outlines lie within two pixels of the painted ones.
    for (const Vec2 p : tree.regions[static_cast<size_t>(isle)].outline) EXPECT_NEAR(std::hypot(p.x, p.y), 300, 10);
  }
}

TEST(RegionPicture, LandAtTheEdgeContinuesBeyondTheDomain) {
  Image image(60, 40, {200, 200, 200});
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 20; ++x) std::fill_n(image.pixel(x, y), 3, uint8_t{0});
    for (int x = 40; x < 60; ++x) std::fill_n(image.pixel(x, y), 3, uint8_t{255});
  }
  const RegionTree tree = regions_from_image(image, kDomain, {}, "mask", {});
  ASSERT_EQ(tree.regions.size(), 2U);
  for (const GrowthRegion& region : tree.regions) {
    const geom::Box box = geom::bounding_box(region.outline);
    EXPECT_GT(box.high.x, kDomain.east_m());
    EXPECT_GT(box.high.y, kDomain.north_m);
    EXPECT_LT(box.low.y, kDomain.south_m());
  }
  const RegionTree land = regions_from_image(image, kDomain, {.darkest_is_land = true}, "mask", {});
  ASSERT_EQ(land.regions.size(), 3U);
  EXPECT_EQ(region_at(land, {-499, -399}), 0);
}

TEST(RegionPicture, MasksAreReadInTheirOwnFrame) {
  ScalarField mask(GridFrame::centred(50, 50, 4), 0.2F);
  for (int y = 20; y < 30; ++y) {
    for (int x = 20; x < 30; ++x) mask(x, y) = 7.5F;
  }
  const RegionTree tree = regions_from_mask(mask, kDomain, {}, "mask", {});
  ASSERT_EQ(tree.regions.size(), 1U);
  EXPECT_NEAR(geom::signed_area(tree.regions[0].outline), 1600, 200);
}

TEST(RegionPicture, HeightMapsAreCutIntoAFewZones) {
  Image image(200, 160);
  for (int y = 0; y < 160; ++y)
    for (int x = 0; x < 200; ++x) {
      const double r = std::hypot(x - 100, y - 80);
      const auto grey = static_cast<uint8_t>(std::clamp(255.0 - 3.5 * r, 0.0, 255.0));
      for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = grey;
    }
  std::vector<std::string> notes;
  RunContext run;
  run.note = [&](const std::string& line) { notes.push_back(line); };
  const RegionTree tree = regions_from_image(image, kDomain, {}, "regions", run);
  EXPECT_EQ(tree.regions.size(), 6U);
  for (size_t i = 0; i < tree.regions.size(); ++i) EXPECT_EQ(tree.regions[i].parent, static_cast<int>(i) - 1);
  EXPECT_THAT(notes, ::testing::ElementsAre(HasSubstr("it is cut into 6 zones")));
}

TEST(RegionPicture, PicturesWithoutRegionsAreRefused) {
  EXPECT_THROW(regions_from_image(Image(40, 40, {90, 90, 90}), kDomain, {}, "mask", {}), InvalidArgument);
  EXPECT_THROW(regions_from_image(Image(1, 1), kDomain, {}, "mask", {}), InvalidArgument);
  EXPECT_THROW(regions_from_mask(ScalarField(kDomain, 1.0F), kDomain, {}, "mask", {}), InvalidArgument);
}

}  // namespace
}  // namespace seamount::contour
