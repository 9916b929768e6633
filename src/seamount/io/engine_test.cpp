#include "seamount/io/engine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "seamount/base/rng.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/info.h"
#include "seamount/io/png_codec.h"
#include "seamount/io/raster.h"
#include "seamount/io/splat.h"
#include "seamount/io/test_files.h"

namespace seamount::io {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Pair;

HeightField square(int size, double cell_m = 8.0) { return test_terrain(GridFrame::centred(size, size, cell_m)); }

uint16_t code_at(const std::vector<uint8_t>& raw, int size, int x, int y) {
  uint16_t code = 0;
  std::memcpy(&code, raw.data() + 2 * (static_cast<size_t>(y) * static_cast<size_t>(size) + static_cast<size_t>(x)), 2);
  return code;
}

double typed(const std::string& path, const std::string& place) {
  const Sidecar sidecar = *read_sidecar(path);
  for (const auto& [name, value] : sidecar.import)
    if (name == place) return std::stod(value);
  ADD_FAILURE() << place;
  return 0;
}

/// Names of the channels of an EXR file, one after the other, from its header's attribute "channels".
std::string exr_channels(const std::vector<uint8_t>& file) {
  const std::string bytes(file.begin(), file.end()), attribute("channels\0chlist\0", 16);
  std::string names;
  size_t at = bytes.find(attribute) + attribute.size() + 4;
  while (bytes[at] != 0) {
    const std::string name = bytes.c_str() + at;
    names += name;
    at += name.size() + 1 + 16;
  }
  return names;
}

/// What Unreal makes of the codes with the numbers that the side-car says to type in.
TEST(Unreal, HeightsComeBackFromTheTypedNumbers) {
  const TestFolder folder;
  const HeightField heights = square(127);
  const std::string path = folder("land.r16");
  write_for_engine(heights, Engine::unreal, path);
  const std::vector<uint8_t> raw = read_file(path);
  const double z_scale = typed(path, "Scale Z"), location = typed(path, "Location Z");
  uint16_t low = 65535, high = 0;
  for (int y = 0; y < 127; ++y) {
    for (int x = 0; x < 127; ++x) {
      const uint16_t code = code_at(raw, 127, x, y);
      const double centimetres = location + (code - 32768.0) / 128.0 * z_scale;
      EXPECT_NEAR(centimetres / 100.0, heights(x, y), 0.5 * z_scale / 12800.0 + 1e-4);
      low = std::min(low, code), high = std::max(high, code);
    }
  }
  EXPECT_NEAR((high - low) / 65536.0, 0.75, 0.01) << "room to sculpt beyond";
  EXPECT_DOUBLE_EQ(typed(path, "Scale X"), 800.0);
  EXPECT_LE(read_sidecar(path)->import[2].second.size(), 6U) << "a number that one can type";
  EXPECT_LE(largest_difference(read_heights(path), heights), 0.5 * z_scale / 12800.0 + 2e-4);
}

TEST(Unreal, PngHoldsTheSameCodes) {
  const TestFolder folder;
  const HeightField heights = square(253);
  write_for_engine(heights, Engine::unreal, folder("land.r16"));
  write_for_engine(heights, Engine::unreal, folder("land.png"));
  const PngSamples png = decode_png_samples(read_file(folder("land.png")), "land.png", 100000);
  const std::vector<uint8_t> raw = read_file(folder("land.r16"));
  ASSERT_EQ(png.words16.size() * 2, raw.size());
  EXPECT_EQ(std::memcmp(png.words16.data(), raw.data(), raw.size()), 0);
}

TEST(Engines, RefuseWrongSizesFormatsAndRanges) {
  const TestFolder folder;
  EXPECT_THAT(error_of([&] { write_for_engine(square(128), Engine::unreal, folder("x.r16")); }),
              HasSubstr("allowed are squares of: 127, 253, 505, 1009, 2017, 4033, 8129"));
  EXPECT_THAT(error_of([&] { write_for_engine(square(128), Engine::unity, folder("x.raw")); }),
              HasSubstr("33, 65, 129, 257, 513, 1025, 2049, 4097"));
  EXPECT_THAT(error_of([&] {
                write_for_engine(test_terrain(GridFrame::centred(127, 65, 1)), Engine::unreal, folder("x.r16"));
              }),
              HasSubstr("127 x 65"));
  EXPECT_THAT(error_of([&] { write_for_engine(square(65), Engine::unity, folder("x.png")); }), HasSubstr("'.png'"));
  EXPECT_THAT(error_of([&] {
                write_for_engine(square(65), Engine::unity, folder("x.raw"), {.range = HeightRange{0, 10}});
              }),
              HasSubstr("[0, 10] does not hold the heights"));
  EXPECT_EQ(folder.files(), 0U);
}

TEST(Unity, SouthernRowComesFirst) {
  const TestFolder folder;
  const HeightField heights = square(65);
  const std::string path = folder("land.raw");
  write_for_engine(heights, Engine::unity, path);
  const std::vector<uint8_t> raw = read_file(path);
  const double height = typed(path, "Terrain Height"), position = typed(path, "Position Y");
  for (int y = 0; y < 65; ++y)
    for (int x = 0; x < 65; ++x)
      EXPECT_NEAR(position + code_at(raw, 65, x, 64 - y) / 65535.0 * height, heights(x, y),
                  0.5 * height / 65535 + 1e-4);
  EXPECT_DOUBLE_EQ(typed(path, "Terrain Width"), 64 * 8.0);
  EXPECT_LE(largest_difference(read_heights(path), heights), 0.5 * height / 65535 + 2e-4);
}

TEST(Engines, AskedRangesAreKept) {
  const TestFolder folder;
  const HeightRange range{-4096, 4096};
  for (const Engine engine : {Engine::unreal, Engine::unity, Engine::godot}) {
    const std::string path = folder("land.r16");
    write_for_engine(square(engine == Engine::unreal ? 127 : 65), engine, path, {.range = range});
    EXPECT_NEAR(read_sidecar(path)->range->low_m, range.low_m, 1e-6);
    EXPECT_NEAR(read_sidecar(path)->range->high_m, range.high_m, 1e-6);
  }
}

TEST(Engines, FlatTerrainHasARange) {
  const TestFolder folder;
  for (const Engine engine : {Engine::unreal, Engine::unity}) {
    const int size = engine == Engine::unreal ? 127 : 33;
    write_for_engine(HeightField(GridFrame::centred(size, size, 1), -7.25F), engine, folder("flat.r16"));
    EXPECT_NEAR(read_heights(folder("flat.r16"))(5, 5), -7.25, 1e-4);
  }
}

TEST(Engines, FloatTargetsHoldMetres) {
  const TestFolder folder;
  const HeightField heights = test_terrain(GridFrame::centred(70, 50, 4));
  for (const Engine engine : {Engine::godot, Engine::blender}) {
    write_for_engine(heights, engine, folder("land.exr"));
    EXPECT_EQ(read_heights(folder("land.exr")), heights);
    EXPECT_EQ(exr_channels(read_file(folder("land.exr"))), engine == Engine::godot ? "R" : "Y");
  }
  EXPECT_THAT(*describe_raster(folder("land.exr")), Contains(Pair("  Displace strength", "1")));
  EXPECT_THAT(*describe_raster(folder("land.exr")), Contains(Pair("  texture Clamp", "off")));
  EXPECT_DOUBLE_EQ(typed(folder("land.exr"), "plane size X"), 70 * 4.0);
  EXPECT_DOUBLE_EQ(typed(folder("land.exr"), "plane size Y"), 50 * 4.0);
}

std::vector<GroundLayer> random_layers(const GridFrame& frame, uint64_t seed) {
  Rng rng(Seed{seed}.derive("weights"));
  std::vector<GroundLayer> layers;
  for (const char* name : {"sand", "grass", "rock", "snow", "mud", "reef"}) {
    layers.push_back({name, Mask(frame)});
    for (float& w : layers.back().weights.cells()) w = rng.chance(0.4) ? 0.0F : static_cast<float>(rng.uniform(0, 3));
    layers.back().weights(3, 3) = 0;
  }
  return layers;
}

std::vector<std::string> names_of(const std::vector<GroundLayer>& layers) {
  std::vector<std::string> names;
  for (const GroundLayer& layer : layers) names.push_back(layer.name);
  return names;
}

TEST(Splat, WeightsSumTo255OverAllFilesAndTheListNamesThem) {
  const TestFolder folder;
  for (const uint64_t seed : {1, 2}) {
    for (const SplatFiles kind : {SplatFiles::grey, SplatFiles::rgba}) {
      const bool grey = kind == SplatFiles::grey;
      const auto layers = random_layers(GridFrame::centred(23, 7, 1), seed);
      const std::vector<std::string> files = splat_files(names_of(layers), folder("s.png"), kind);
      ASSERT_EQ(files.size(), grey ? 7U : 3U);
      write_splat(layers, folder("s.png"), {.files = kind});
      std::map<std::string, PngSamples> pictures;
      for (size_t f = 0; f + 1 < files.size(); ++f) {
        pictures[std::filesystem::path(files[f]).filename().string()] =
            decode_png_samples(read_file(files[f]), files[f], 1000);
      }
      const auto list = nlohmann::json::parse(std::ifstream(files.back()));
      ASSERT_EQ(list["layers"].size(), 6U);
      for (size_t i = 0; i < layers[0].weights.size(); ++i) {
        double total = 0;
        int sum = 0;
        for (const GroundLayer& layer : layers) total += layer.weights.cells()[i];
        for (size_t m = 0; m < 6; ++m) {
          const auto& row = list["layers"][m];
          ASSERT_EQ(row["name"], layers[m].name);
          const PngSamples& picture = pictures.at(row["file"]);
          const std::string channel = row["channel"];
          const size_t at = channel == "green" ? 1 : channel == "blue" ? 2 : 0;
          ASSERT_EQ(picture.channels, grey ? 1 : 4);
          const int share = picture.bytes8[i * (grey ? 1 : 4) + at];
          if (total > 0) {
            ASSERT_NEAR(share, 255 * layers[m].weights.cells()[i] / total, 1.0);
          }
          if (!grey) {
            ASSERT_EQ(picture.bytes8[4 * i + 3], 255) << "alpha is opaque";
          }
          sum += share;
        }
        ASSERT_EQ(sum, 255);
      }
    }
  }
}

TEST(Splat, RefusesNonsense) {
  const TestFolder folder;
  const GridFrame frame = GridFrame::centred(2, 2, 1);
  std::vector<GroundLayer> layers = {{"a", Mask(frame, 1.0F)}, {"b", Mask(frame, 1.0F)}};
  EXPECT_THROW(write_splat(layers, folder("s.tif")), IoError);
  layers[1].weights(0, 0) = -1;
  EXPECT_THROW(write_splat(layers, folder("s.png")), InvalidArgument);
  layers[1].weights = Mask(GridFrame::centred(3, 2, 1), 1.0F);
  EXPECT_THROW(write_splat(layers, folder("s.png")), IncompatibleInputs);
  EXPECT_THROW(write_splat({}, folder("s.png")), InvalidArgument);
}

}  // namespace
}  // namespace seamount::io
