#include "seamount/io/engine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

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

TEST(Splat, WeightsSumTo255OverAllFiles) {
  const TestFolder folder;
  const GridFrame frame = GridFrame::centred(23, 7, 1);
  Rng rng(Seed{1}.derive("weights"));
  std::vector<Mask> weights(6, Mask(frame));
  for (Mask& mask : weights)
    for (float& w : mask.cells()) w = rng.chance(0.4) ? 0.0F : static_cast<float>(rng.uniform(0, 3));
  for (Mask& mask : weights) mask(3, 3) = 0;
  const std::vector<std::string> files = write_splat(weights, folder("s.png"));
  ASSERT_EQ(files.size(), 2U);
  const PngSamples a = decode_png_samples(read_file(files[0]), files[0], 1000);
  const PngSamples b = decode_png_samples(read_file(files[1]), files[1], 1000);
  for (size_t i = 0; i < weights[0].size(); ++i) {
    int sum = 0;
    double total = 0;
    for (const Mask& mask : weights) total += mask.cells()[i];
    for (size_t m = 0; m < 8; ++m) {
      const int share = (m < 4 ? a : b).bytes8[4 * i + m % 4];
      sum += share;
      if (total > 0 && m < 6) {
        EXPECT_NEAR(share, 255 * weights[m].cells()[i] / total, 1.0);
      }
    }
    EXPECT_EQ(sum, 255);
  }
  EXPECT_EQ(a.bytes8[4 * (3 * 23 + 3)], 255) << "no weight at all: the first material";
}

TEST(Splat, RefusesNonsense) {
  const TestFolder folder;
  std::vector<Mask> masks(2, Mask(GridFrame::centred(2, 2, 1), 1.0F));
  EXPECT_THROW(write_splat(masks, folder("s.tif")), IoError);
  masks[1](0, 0) = -1;
  EXPECT_THROW(write_splat(masks, folder("s.png")), InvalidArgument);
  masks[1] = Mask(GridFrame::centred(3, 2, 1), 1.0F);
  EXPECT_THROW(write_splat(masks, folder("s.png")), IncompatibleInputs);
  EXPECT_EQ(write_splat(LabelMap(GridFrame::centred(3, 3, 1), Region::reef), folder("l.png")).size(), 2U);
}

}  // namespace
}  // namespace seamount::io
