// Worlds are read back as Gazebo reads them: the elements of the text, the codes of the picture.
#include "seamount/io/gazebo.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "seamount/io/image_file.h"
#include "seamount/io/png_codec.h"
#include "seamount/io/projection.h"
#include "seamount/io/raster.h"
#include "seamount/io/test_files.h"
#include "seamount/io/texture_part.h"

namespace seamount::io {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string text_of(const std::string& path) {
  const auto bytes = read_file(path);
  return {bytes.begin(), bytes.end()};
}

/// What stands in the first <name> after `from`.
std::string element(const std::string& text, const std::string& name, const std::string& from = "<sdf") {
  const size_t begin = text.find("<" + name + ">", text.find(from)) + name.size() + 2;
  return text.substr(begin, text.find("</" + name + ">", begin) - begin);
}

std::vector<double> numbers(const std::string& text) {
  std::istringstream stream(text);
  std::vector<double> all;
  for (double number; stream >> number;) all.push_back(number);
  return all;
}

TEST(Gazebo, ReadsTheTerrainBackAtRandomPlaces) {
  const TestFolder folder;
  Rng rng(Seed{3}.derive("places"));
  for (const int bits : {16, 8}) {
    const HeightField heights = test_terrain(GridFrame::centred(65, 65, 12.5), 7);
    write_gazebo(heights, folder("reef.sdf"), {.bits = bits});
    const std::string text = text_of(folder("reef.sdf"));
    const auto size = numbers(element(text, "size", "<heightmap>")), pos = numbers(element(text, "pos"));
    ASSERT_EQ(size.size(), 3U);
    EXPECT_DOUBLE_EQ(size[0], 64 * 12.5);
    EXPECT_DOUBLE_EQ(size[1], 64 * 12.5);
    EXPECT_EQ(numbers(element(text, "pose", "<collision")), (std::vector<double>{0, 0, pos[2], 0, 0, 0}));
    EXPECT_EQ(numbers(element(text, "pos", "<collision")), (std::vector<double>{0, 0, 0}));
    const PngSamples png = decode_png_samples(read_file(folder(element(text, "uri"))), "height.png", 10000);
    const double top = bits == 16 ? 65535 : 255, half_step = 0.5 * size[2] / top;
    const auto z = [&](int x, int y) {
      const auto i = static_cast<size_t>(y) * 65 + static_cast<size_t>(x);
      return pos[2] + size[2] * (bits == 16 ? png.words16[i] : png.bytes8[i]) / top;
    };
    for (int k = 0; k < 500; ++k) {
      // A sample of the terrain at its place, x east and y north of the middle.
      const int column = rng.integer(0, 64), row = rng.integer(0, 64);
      const double x = heights.frame().x(column), y = heights.frame().y(row);
      const auto px = static_cast<int>(std::lround((x + size[0] / 2) / size[0] * 64));
      const auto py = static_cast<int>(std::lround((size[1] / 2 - y) / size[1] * 64));
      EXPECT_NEAR(z(px, py), heights(column, row), half_step + 1e-4);
    }
    EXPECT_LE(largest_difference(read_heights(folder("reef/height.png")), heights), half_step + 1e-3);
    if (bits == 16) {
      EXPECT_EQ(*std::max_element(png.words16.begin(), png.words16.end()), 65535)
          << "Gazebo stretches the highest code to the full height";
    }
  }
}

TEST(Gazebo, KnowsWhereItsOriginIs) {
  const TestFolder folder;
  const GridFrame frame{33, 33, 50, 700000, 6900000, "EPSG:32633"};
  std::vector<std::string> said;
  RunContext run;
  run.note = [&](const std::string& line) { said.push_back(line); };
  write_gazebo(test_terrain(frame), folder("x.sdf"), {}, run);
  const std::string text = text_of(folder("x.sdf"));
  const double latitude = std::stod(element(text, "latitude_deg")),
               longitude = std::stod(element(text, "longitude_deg"));
  const Vec2 middle = from_lonlat({{longitude, latitude}}, frame.crs)[0];
  EXPECT_NEAR(middle.x, frame.x(16), 0.01);
  EXPECT_NEAR(middle.y, frame.y(16), 0.01);
  // East of the zone's middle the grid's north lies east of true north: turned clockwise.
  const double angle = std::stod(element(text, "heading_deg"));
  constexpr double kRadians = 3.14159265358979323846 / 180;
  EXPECT_NEAR(angle, -std::atan(std::tan((longitude - 15) * kRadians) * std::sin(latitude * kRadians)) / kRadians,
              1e-3);
  EXPECT_THAT(said.at(0), HasSubstr("x 700825.00 m, y 6899175.00 m of the terrain, at sea level (latitude 62."));
  write_gazebo(test_terrain(GridFrame::centred(33, 33, 50)), folder("y.sdf"));
  EXPECT_THAT(text_of(folder("y.sdf")), Not(HasSubstr("spherical_coordinates")));
}

TEST(Gazebo, ShowsASeaOnlyWhereThereIsOne) {
  const TestFolder folder;
  HeightField heights = test_terrain(GridFrame::centred(33, 33, 5));
  write_gazebo(heights, folder("sea.sdf"), {.buoyancy = true});
  EXPECT_THAT(text_of(folder("sea.sdf")), HasSubstr("<model name=\"sea\">"));
  EXPECT_THAT(text_of(folder("sea.sdf")), HasSubstr("gz-sim-buoyancy-system"));
  write_gazebo(heights, folder("dry.sdf"), {.water = false});
  EXPECT_THAT(text_of(folder("dry.sdf")), Not(HasSubstr("<model name=\"sea\">")));
  for (float& z : heights.cells()) z = 12.5F;
  write_gazebo(heights, folder("flat.sdf"));
  EXPECT_THAT(text_of(folder("flat.sdf")), Not(HasSubstr("<model name=\"sea\">")));
  EXPECT_LE(largest_difference(read_heights(folder("flat/height.png")), heights), 1e-4F);
}

TEST(Gazebo, OfAMeshStandsUpright) {
  const TestFolder folder;
  Mesh mesh;
  mesh.parts.emplace_back();
  mesh.parts[0].positions = {0, 0, -5, 10, 0, 3, 0, 10, 4};
  mesh.parts[0].normals = {0, 0, 1, 0, 0, 1, 0, 0, 1};
  mesh.parts[0].indices = {0, 1, 2};
  write_gazebo(mesh, GridFrame::centred(2, 2, 10), folder("m.world"));
  const std::string text = text_of(folder("m.world")), model = text_of(folder("m/model.sdf"));
  EXPECT_THAT(text, HasSubstr("<model name=\"sea\">"));
  EXPECT_EQ(element(text, "uri"), "m/ground.obj");
  EXPECT_EQ(element(model, "uri"), "model://m/ground.obj");
  EXPECT_NEAR(numbers(element(text, "pose", "<visual"))[3], 1.5707963, 1e-6) << "OBJ's y is up";
  EXPECT_THAT(text_of(folder("m/model.config")), HasSubstr("<sdf version=\"1.7\">model.sdf</sdf>"));
}

TEST(Gazebo, RefusesSizesThatItCannotRead) {
  const TestFolder folder;
  const auto refusal = [&](int width, int height) {
    return error_of([&] { write_gazebo(test_terrain(GridFrame::centred(width, height, 1)), folder("x.sdf")); });
  };
  EXPECT_THAT(refusal(64, 64), HasSubstr("64 x 64 is not a size that Gazebo reads; allowed are squares of: 33, 65"));
  EXPECT_THAT(refusal(65, 33), HasSubstr("65 x 33"));
  EXPECT_EQ(folder.files(), 0U);
}

TEST(Gazebo, LaysTheTextureBetweenTheOuterSamples) {
  const GridFrame of{100, 50, 2, 0, 100, ""};
  Image picture(100, 50);
  for (int y = 0; y < 50; ++y)
    for (int x = 0; x < 100; ++x)
      picture.pixel(x, y)[0] = static_cast<uint8_t>(2 * x), picture.pixel(x, y)[1] = static_cast<uint8_t>(4 * y);
  const GridFrame samples{33, 33, 98.0 / 32, 51 - 98.0 / 64, 99 + 98.0 / 64, ""};
  const Image part = texture_between(picture, of, samples);
  EXPECT_EQ(part.width, 49);
  for (int y = 0; y < 49; ++y) {
    for (int x = 0; x < 49; ++x) {
      EXPECT_NEAR(part.pixel(x, y)[0], 2 * ((51 + 2 * (x + 0.5)) / 2 - 0.5), 1.01);
      EXPECT_NEAR(part.pixel(x, y)[1], 4 * ((1 + 2 * (y + 0.5)) / 2 - 0.5), 1.01);
    }
  }
}

}  // namespace
}  // namespace seamount::io
