// The splat output of a terrain: the layers of terrain.layers, in 8 bits that still sum to all.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "seamount/io/png_codec.h"
#include "seamount/ops/terrain/layers.h"
#include "seamount/recipe/outputs.h"

namespace seamount::recipe {
namespace {

io::PngSamples written(const HeightField& terrain, const Json& params) {
  const OutputFormat& format = *find_output_format("splat");
  const std::string path = ::testing::TempDir() + "seamount_layers.png";
  Diagnostics diagnostics;
  const Json complete = format.complete(params, {"", diagnostics});
  EXPECT_TRUE(diagnostics.empty());
  const Value value = Value::terrain(terrain);
  format.write(complete, {.value = value, .path = path, .provenance = {}, .run = {}});
  std::ifstream file(path, std::ios::binary);
  const std::vector<uint8_t> bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  return io::decode_png_samples(bytes, path, 1 << 20);
}

TEST(SplatOfTerrain, IsItsLayersInBytesThatSumToAll) {
  HeightField terrain(GridFrame::centred(40, 30, 25.0));
  for (size_t i = 0; i < terrain.size(); ++i) terrain.cells()[i] = static_cast<float>(i % 613) - 100.0F;
  const io::PngSamples image = written(terrain, Json::object());
  ASSERT_EQ(image.channels, 4);
  const geom::Layers layers = terrain::layers(terrain, {}, {});
  for (size_t i = 0; i < terrain.size(); ++i) {
    const uint8_t* share = &image.bytes8[4 * i];
    ASSERT_EQ(share[0] + share[1] + share[2], 255);
    ASSERT_EQ(share[3], 0);
    ASSERT_NEAR(share[0], 255 * layers.low.cells()[i], 1.0);
    ASSERT_NEAR(share[1], 255 * layers.middle.cells()[i], 1.0);
    ASSERT_NEAR(share[2], 255 * layers.high.cells()[i], 1.0);
  }
  EXPECT_NE(written(terrain, {{"style", "great_barrier_reef"}}).bytes8, image.bytes8);
  EXPECT_NE(written(terrain, {{"layers", {{"low_m", 0}, {"high_m", 20}}}}).bytes8, image.bytes8);
}

}  // namespace
}  // namespace seamount::recipe
