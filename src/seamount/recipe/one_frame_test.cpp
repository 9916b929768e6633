// Inputs in any coordinate system, brought to one frame before an operator sees them.
#include "seamount/recipe/one_frame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/io/projection.h"
#include "seamount/io/raster.h"
#include "seamount/io/reproject.h"
#include "seamount/io/test_files.h"
#include "seamount/io/vector.h"
#include "seamount/recipe/executor.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kZone = "EPSG:32627";
const Vec2 kMiddle{620000, 7100000};

GridFrame frame_at(Vec2 middle, int width, int height, double cell_m, const std::string& crs = kZone) {
  GridFrame frame = GridFrame::centred(width, height, cell_m);
  frame.west_m += middle.x;
  frame.north_m += middle.y;
  frame.crs = crs;
  return frame;
}

HeightField hill(const GridFrame& frame) {
  HeightField heights(frame);
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x)
      heights(x, y) = static_cast<float>(500 - 0.05 * std::hypot(frame.x(x) - kMiddle.x, frame.y(y) - kMiddle.y));
  return heights;
}

Drawing disc(Vec2 middle, double radius, const std::string& crs = kZone) {
  Ring ring;
  for (int i = 0; i < 90; ++i)
    ring.push_back(
        {middle.x + radius * std::cos(i * 4 * M_PI / 180), middle.y + radius * std::sin(i * 4 * M_PI / 180)});
  return {{{"disc", {{ring, {}}}}}, {}, crs};
}

/// Runs one step of one operator on files in a folder of their own.
class OneFrame : public testing::Test {
 protected:
  Value run(const std::string& op, const std::string& in, const std::string& params, const std::string& port,
            const std::string& domain = "{}") {
    const std::string text = R"({"seamount": 1, "domain": )" + domain + R"(, "steps": [{"id": "s", "op": ")" + op +
                             R"(", "in": )" + in + R"(, "params": )" + params + "}]}";
    notes_.clear();
    RunContext context;
    context.note = [this](const std::string& line) { notes_.push_back(line); };
    const Recipe recipe = parse_recipe(text, "recipe.json", folder_(""));
    return evaluate(recipe, {{"s", port, ""}}, {.out_folder = {}, .cache_folder = ""}, context)[0];
  }
  static double area_of(const ScalarField& mask) {
    double sum = 0;
    for (const float w : mask.cells()) sum += static_cast<double>(w);
    return sum * mask.cell_m() * mask.cell_m();
  }

  io::TestFolder folder_;
  std::vector<std::string> notes_;
};

/// Snow lies as low as it does at the terrain's latitude; a terrain without a place is at that of its setting.
TEST_F(OneFrame, PicturesTakeTheLatitudeOfThePlace) {
  const auto whiteness = [&](const std::string& crs, double northing, const std::string& params) {
    GridFrame frame = frame_at({500000, northing}, 60, 60, 100, crs);
    HeightField heights(frame);
    for (int y = 0; y < frame.height; ++y)
      for (int x = 0; x < frame.width; ++x) heights(x, y) = 3400.0F + 10.0F * static_cast<float>((x * 3 + y * 5) % 7);
    io::write_heights(heights, folder_("high.tif"));
    const Value made = run("render.texture", R"({"terrain": {"file": "high.tif"}})", params, "image");
    const Image& image = made.get<kinds::Image>();
    double sum = 0;
    for (const uint8_t byte : image.rgb) sum += byte;
    return sum / static_cast<double>(image.rgb.size());
  };
  const std::string size = R"({"size_px": 64)";
  const double lapland = whiteness("EPSG:32633", 7500000, size + "}"),
               alps = whiteness("EPSG:32632", 5150000, size + "}"), kenya = whiteness("EPSG:32637", 0, size + "}"),
               nowhere = whiteness("", 0, size + "}");
  EXPECT_GT(lapland, 1.5 * kenya);
  EXPECT_GT(alps, 1.5 * kenya);
  EXPECT_NEAR(nowhere, alps, 0.2 * alps);
  EXPECT_EQ(whiteness("EPSG:32637", 0, size + R"(, "climate": {"latitude_deg": 67.6}})"),
            whiteness("EPSG:32632", 5150000, size + R"(, "climate": {"latitude_deg": 67.6}})"));
}

/// A polygon in longitude and latitude, in another zone, or in the terrain's own system: the same mask.
TEST_F(OneFrame, AMaskIsWhereTheDrawingLies) {
  io::write_heights(hill(frame_at(kMiddle, 120, 100, 30)), folder_("hill.tif"));
  const Drawing drawn = disc(kMiddle, 500);
  io::write_drawing(drawn, folder_("lonlat.geojson"));
  io::write_drawing(drawn, folder_("own.gpkg"));
  io::write_drawing(io::in_system(drawn, "EPSG:32628"), folder_("zone28.gpkg"));
  for (const char* file : {"lonlat.geojson", "own.gpkg", "zone28.gpkg"}) {
    const Value mask =
        run("terrain.mask", R"({"terrain": {"file": "hill.tif"}, "drawing": {"file": ")" + std::string(file) + R"("}})",
            R"({"criteria": [{"tool": "area", "falloff_m": 0}]})", "mask");
    EXPECT_NEAR(area_of(mask.get<kinds::Field>()), M_PI * 500 * 500, 12000) << file;
    EXPECT_THAT(notes_, IsEmpty()) << file;
  }
  io::write_drawing(disc({kMiddle.x + 50000, kMiddle.y}, 500), folder_("far.gpkg"));
  EXPECT_THAT(io::error_of([&] {
                run("terrain.mask", R"({"terrain": {"file": "hill.tif"}, "drawing": {"file": "far.gpkg"}})",
                    R"({"criteria": [{"tool": "area", "falloff_m": 0}]})", "mask");
              }),
              HasSubstr("drawing: lies nowhere on 'terrain': x 669500 to 670500 m"));
}

TEST_F(OneFrame, RastersComeOntoTheCellsOfTheFirst) {
  io::write_heights(hill(frame_at(kMiddle, 120, 100, 30)), folder_("hill.tif"));
  io::write_heights(hill(frame_at({kMiddle.x + 300, kMiddle.y - 200}, 300, 260, 20)), folder_("finer.tif"));
  const HeightField other = io::in_system(hill(frame_at(kMiddle, 200, 180, 30)), "EPSG:32628", {});
  io::write_heights(other, folder_("zone28.tif"));
  const HeightField wanted = hill(frame_at(kMiddle, 120, 100, 30));
  for (const char* file : {"finer.tif", "zone28.tif"}) {
    const Value mixed =
        run("terrain.blend", R"({"terrain": {"file": "hill.tif"}, "with": {"file": ")" + std::string(file) + R"("}})",
            "{}", "terrain");
    const HeightField& got = mixed.get<kinds::Terrain>();
    ASSERT_EQ(got.frame(), wanted.frame()) << file;
    for (size_t i = 0; i < got.size(); ++i) ASSERT_NEAR(got.cells()[i], wanted.cells()[i], 1.5) << file << " " << i;
  }
}

/// A document that says nothing of a place lies where its inputs do.
TEST_F(OneFrame, TilesAreComposedSideBySide) {
  const GridFrame whole = frame_at(kMiddle, 160, 100, 30);
  GridFrame west = whole, east = whole;
  west.width = 90;
  east.width = 70;
  east.west_m += 90 * 30.0;
  io::write_heights(hill(west), folder_("west.tif"));
  io::write_heights(hill(east), folder_("east.tif"));
  const std::string in = R"({"terrain": {"file": "west.tif"}, "terrain_2": {"file": "east.tif"}})";
  const HeightField joined = run("terrain.compose", in, "{}", "terrain").get<kinds::Terrain>();
  ASSERT_EQ(joined.frame(), whole);
  const HeightField wanted = hill(whole);
  for (size_t i = 0; i < joined.size(); ++i) ASSERT_NEAR(joined.cells()[i], wanted.cells()[i], 1e-3);
  const HeightField larger =
      run("terrain.compose", in, "{}", "terrain", R"({"width_m": 6000, "height_m": 3600, "cell_m": 30})")
          .get<kinds::Terrain>();
  EXPECT_EQ(larger.frame().crs, kZone);
  const auto known =
      std::count_if(larger.cells().begin(), larger.cells().end(), [](float z) { return !std::isnan(z); });
  EXPECT_EQ(known, 160 * 100);
  EXPECT_NEAR(std::fmod(larger.frame().west_m - whole.west_m, 30.0), 0, 1e-6) << "on the lattice of the tiles";
}

TEST_F(OneFrame, ADomainWithASystemIsWhereThingsAreBrought) {
  io::write_heights(hill(frame_at(kMiddle, 120, 100, 30)), folder_("hill.tif"));
  const Vec2 there = io::from_lonlat(io::to_lonlat({kMiddle}, kZone), "EPSG:32628")[0];
  const std::string domain = R"({"width_m": 2000, "height_m": 1500, "cell_m": 25, "crs": "EPSG:32628", "x_m": )" +
                             std::to_string(there.x) + R"(, "y_m": )" + std::to_string(there.y) + "}";
  const HeightField brought =
      run("terrain.resample", R"({"terrain": {"file": "hill.tif"}})", R"({"centre": false})", "terrain", domain)
          .get<kinds::Terrain>();
  EXPECT_EQ(brought.frame().crs, "EPSG:32628");
  for (int y = 0; y < brought.height(); ++y) {
    for (int x = 0; x < brought.width(); ++x) {
      const double away = std::hypot(brought.frame().x(x) - there.x, brought.frame().y(y) - there.y);
      ASSERT_NEAR(brought(x, y), 500 - 0.05 * away, 1.5) << x << " " << y;
    }
  }
  EXPECT_THAT(io::error_of([&] { run("terrain.noise", "{}", "{}", "terrain", R"({"crs": "EPSG:4326"})"); }),
              HasSubstr("'EPSG:4326' is not in metres"));
  EXPECT_THAT(
      io::error_of([&] { run("terrain.noise", "{}", "{}", "terrain", R"({"crs": "EPSG:3857", "y_m": 8800000})"); }),
      HasSubstr("lengths in 'EPSG:3857' are off by up to 111"));
}

TEST_F(OneFrame, AnIslandLiesWhereItsCoastDoes) {
  io::write_drawing(disc(kMiddle, 5000), folder_("coast.gpkg"));
  for (const char* domain : {"{}", R"({"width_m": 30000, "height_m": 30000, "cell_m": 60})"}) {
    const HeightField island =
        run("island.build", "{}", R"({"coast": "coast.gpkg", "detail": {"coast_m": 0}})", "terrain", domain)
            .get<kinds::Terrain>();
    double land = 0, x = 0, y = 0;
    for (int j = 0; j < island.height(); ++j) {
      for (int i = 0; i < island.width(); ++i) {
        if (!(island(i, j) > 0)) continue;
        land += 1, x += island.frame().x(i), y += island.frame().y(j);
      }
    }
    EXPECT_NEAR(land * island.cell_m() * island.cell_m(), M_PI * 25e6, 2e6) << domain;
    EXPECT_NEAR(x / land, kMiddle.x, 60) << domain;
    EXPECT_NEAR(y / land, kMiddle.y, 60) << domain;
    EXPECT_EQ(island.frame().crs, kZone);
  }
}

TEST_F(OneFrame, UnknownCellsAreFilledForThoseWhoNeedThem) {
  HeightField holes = hill(frame_at(kMiddle, 60, 50, 30));
  for (int y = 20; y < 25; ++y)
    for (int x = 10; x < 30; ++x) holes(x, y) = std::nanf("");
  io::write_heights(holes, folder_("holes.tif"));
  const Value filled = run("terrain.layers", R"({"terrain": {"file": "holes.tif"}})", "{}", "low");
  EXPECT_THAT(notes_, ElementsAre(HasSubstr("100 of 3000 cells have no value"),
                                  HasSubstr("terrain: 100 of 3000 cells have no value and are filled")));
  for (const float w : filled.get<kinds::Field>().cells()) ASSERT_TRUE(std::isfinite(w));
  const Value flow = run("hydrology.flow", R"({"terrain": {"file": "holes.tif"}})", R"({"sea": false})", "cells");
  const ScalarField& cells = flow.get<kinds::Field>();
  float most = 0;
  for (size_t i = 0; i < cells.size(); ++i) {
    ASSERT_EQ(std::isnan(cells.cells()[i]), std::isnan(holes.cells()[i]));
    if (!std::isnan(cells.cells()[i])) most = std::max(most, cells.cells()[i]);
  }
  EXPECT_LE(most, 2900.0F);
}

}  // namespace
}  // namespace seamount::recipe
