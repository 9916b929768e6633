// The splat output of a terrain: the layers of its style, in 8 bits that still sum to all.
#include <gtest/gtest.h>

#include "seamount/io/atomic_file.h"
#include "seamount/io/png_codec.h"
#include "seamount/io/raster.h"
#include "seamount/ops/terrain/layers.h"
#include "seamount/recipe/executor.h"

namespace seamount::recipe {
namespace {

/// A terrain written by a recipe with these members of its output.
io::PngSamples written(const HeightField& terrain, Json output) {
  const std::string folder = ::testing::TempDir() + "seamount_splat";
  io::write_heights(terrain, folder + "/in.tif");
  output["from"] = "t.terrain";
  output["path"] = "layers.png";
  output["as"] = "splat";
  const Json document = {{"seamount", 1},
                         {"steps", {{{"id", "t"}, {"op", "terrain.import"}, {"params", {{"file", "in.tif"}}}}}},
                         {"outputs", {output}}};
  execute(parse_recipe(document.dump(), "splat.json", folder), {folder, ""}, {});
  return io::decode_png_samples(io::read_file(folder + "/layers.png"), "layers.png", 1 << 20);
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
