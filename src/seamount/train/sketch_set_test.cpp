#include "seamount/train/sketch_set.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "seamount/base/error.h"
#include "seamount/io/image_file.h"
#include "seamount/io/raster.h"
#include "seamount/train/sample_set.h"

namespace seamount::train {
namespace {

namespace fs = std::filesystem;

constexpr SketchSetParams kSmall{.size = 96};

/// Valleys that run north to south, with water in the west.
std::vector<GroundTile> valleys() {
  HeightField heights(GridFrame::centred(320, 260, 30));
  for (int y = 0; y < heights.height(); ++y) {
    for (int x = 0; x < heights.width(); ++x) {
      heights(x, y) = x < 120 ? std::numeric_limits<float>::quiet_NaN()
                              : static_cast<float>(900 + 150 * std::cos(x * 0.15) + 0.8 * y);
    }
  }
  return {{"valleys", std::move(heights)}};
}

class SketchSet : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = (fs::path(::testing::TempDir()) /
               ("seamount_sketch_set_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name())))
                  .string();
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  HeightField heights_of(uint64_t index, const SketchDraw& draw) const {
    io::ReadOptions options;
    options.range = io::HeightRange{draw.low_m, draw.high_m};
    options.cell_m = draw.cell_m;
    return io::read_heights(sample_file(folder_, index, "height"), options);
  }
  std::string folder_;
};

/// Where cell (x, y) of an example lies in its tile.
std::pair<int, int> in_tile(const SketchDraw& draw, int size, int x, int y) {
  int u = draw.flip_x ? size - 1 - x : x, v = draw.flip_y ? size - 1 - y : y;
  if (draw.transpose) std::swap(u, v);
  return {draw.left + u, draw.top + v};
}

TEST_F(SketchSet, ShowsTheGroundThatItsLineSaysAndNoWater) {
  const std::vector<GroundTile> tiles = valleys();
  int turned = 0, flipped = 0;
  for (uint64_t index = 0; index < 12; ++index) {
    const SketchExample made = make_sketch_files(tiles, kSmall, index, Seed{4}, folder_, {});
    EXPECT_EQ(made.tile, "valleys");
    EXPECT_GE(made.draw.left, 120);
    turned += made.draw.transpose;
    flipped += made.draw.flip_x;
    const HeightField heights = heights_of(index, made.draw);
    const double step = (made.draw.high_m - made.draw.low_m) / 65535;
    for (int y = 0; y < kSmall.size; ++y) {
      for (int x = 0; x < kSmall.size; ++x) {
        const auto [u, v] = in_tile(made.draw, kSmall.size, x, y);
        ASSERT_NEAR(heights(x, y), tiles[0].heights(u, v), 0.6 * step + 1e-3) << index;
      }
    }
  }
  EXPECT_GT(turned, 0);
  EXPECT_LT(turned, 12);
  EXPECT_GT(flipped, 0);
}

TEST_F(SketchSet, RiversLieInValleysAndTheLevelsetHigh) {
  const std::vector<GroundTile> tiles = valleys();
  int rivers = 0, ridges = 0;
  for (uint64_t index = 0; index < 12; ++index) {
    const SketchExample made = make_sketch_files(tiles, kSmall, index, Seed{4}, folder_, {});
    const Image sketch = io::read_image(sample_file(folder_, index, "sketch"));
    const Image levelset = io::read_image(sample_file(folder_, index, "levelset"));
    double inside = 0, outside = 0;
    int cells = 0;
    for (int y = 0; y < kSmall.size; ++y) {
      for (int x = 0; x < kSmall.size; ++x) {
        const auto [u, v] = in_tile(made.draw, kSmall.size, x, y);
        const Colour c = sketch.colour(x, y);
        const bool low = std::cos(u * 0.15) < 0;
        const bool edge = std::min({x, y, kSmall.size - 1 - x, kSmall.size - 1 - y}) < 16;
        if (c.b == 255 && !edge) rivers += low ? 1 : -9;
        if (c.r == 255 && !edge) ridges += low ? -9 : 1;
        const bool high = levelset.colour(x, y).r == 255;
        (high ? inside : outside) += static_cast<double>(tiles[0].heights(u, v));
        cells += high;
      }
    }
    ASSERT_GT(cells, 0);
    const int all = kSmall.size * kSmall.size;
    EXPECT_NEAR(100.0 * (all - cells) / all, made.draw.percentile, 1.0);
    EXPECT_GT(inside / cells, outside / (all - cells) + 20);
  }
  EXPECT_GT(rivers, 300);
  EXPECT_GT(ridges, 300);
}

TEST_F(SketchSet, AnExampleIsAFunctionOfItsNumberOnAnyThreads) {
  const std::vector<GroundTile> tiles = valleys();
  const auto make = [&](uint64_t index, uint64_t seed, int threads) {
    return make_sketch_files(tiles, kSmall, index, Seed{seed}, folder_, {.threads = threads}).digests;
  };
  const std::vector<std::string> first = make(5, 1, 4);
  EXPECT_EQ(make(5, 1, 1), first);
  EXPECT_NE(make(6, 1, 1)[0], first[0]);
  EXPECT_NE(make(5, 2, 1)[0], first[0]);
}

TEST_F(SketchSet, GroundWithoutReliefIsAnErrorAndNoEndlessSearch) {
  std::vector<GroundTile> tiles = valleys();
  for (float& z : tiles[0].heights.cells()) z = 5;
  EXPECT_THROW(make_sketch_files(tiles, kSmall, 0, Seed{1}, folder_, {}), InvalidArgument);
}

TEST(GroundDigest, TellsGroundsApart) {
  std::vector<GroundTile> tiles = valleys();
  const Digest digest = ground_digest(tiles);
  EXPECT_EQ(ground_digest(valleys()), digest);
  tiles[0].heights(200, 7) += 1;
  EXPECT_NE(ground_digest(tiles), digest);
  tiles = valleys();
  tiles[0].name = "hills";
  EXPECT_NE(ground_digest(tiles), digest);
}

}  // namespace
}  // namespace seamount::train
