// Samples from sets on disk: what a sample shows is what the set holds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "seamount/base/error.h"
#include "seamount/io/image_file.h"
#include "seamount/io/test_files.h"
#include "seamount/ops/learned/island.h"
#include "seamount/ops/learned/sketch_planes.h"
#include "seamount/train/island_set.h"
#include "seamount/train/sample_set.h"
#include "seamount/train/stored_islands.h"
#include "seamount/train/stored_sketches.h"

namespace seamount::train {
namespace {

/// Two regions of ridges and valleys.
std::vector<GroundTile> tiles() {
  std::vector<GroundTile> all;
  for (const char* name : {"alps_a", "andes_b", "atlas_c", "urals_d"}) {
    HeightField heights(GridFrame::centred(200, 200, 30));
    const double phase = static_cast<double>(all.size());
    for (int y = 0; y < 200; ++y) {
      for (int x = 0; x < 200; ++x)
        heights(x, y) = static_cast<float>(900 + 250 * std::cos(x * 0.1 + phase) + 120 * std::sin(y * 0.07) + 2 * y);
    }
    all.push_back({name, std::move(heights)});
  }
  return all;
}

std::vector<StoredSketch> write_sketches(const std::string& folder, int count) {
  std::vector<StoredSketch> examples;
  for (int i = 0; i < count; ++i) {
    const auto index = static_cast<uint64_t>(i);
    const SketchExample made = make_sketch_files(tiles(), {.size = 128}, index, Seed{4}, folder, {});
    examples.push_back({index, made.tile, made.draw});
  }
  return examples;
}

TEST(StoredSketches, SamplesShowTheHeightsAndTheLinesOfTheirExamples) {
  const io::TestFolder folder;
  const StoredSketchTask task(folder("."), 128, write_sketches(folder("."), 12), Seed{7});
  int rivers = 0, ridges = 0;
  for (uint64_t n = 0; n < 24; ++n) {
    const Sample sample = task.training(n);
    ASSERT_EQ(sample.size, 128);
    ASSERT_EQ(sample.planes.size(), 128U * 128U * learned::kSketchPlanes);
    const auto [low, high] = std::minmax_element(sample.target.begin(), sample.target.end());
    EXPECT_GT(*high - *low, 0.5F) << "heights are shares of the relief";
    EXPECT_LT(*high, 1.6F);
    const auto drawn = [&](int plane) {
      int cells = 0;
      for (size_t i = static_cast<size_t>(plane); i < sample.planes.size(); i += learned::kSketchPlanes)
        cells += sample.planes[i] > 0.99F;
      return cells > 20;
    };
    rivers += drawn(0);
    ridges += drawn(2);
    EXPECT_EQ(task.training(n).planes, sample.planes) << "a function of the number alone";
  }
  EXPECT_GT(rivers, 10);
  EXPECT_LT(rivers, 24) << "kinds are left out at times";
  EXPECT_GT(ridges, 10);
}

TEST(StoredSketches, ARegionIsLearnedFromOrItIsNot) {
  const io::TestFolder folder;
  const std::vector<StoredSketch> examples = write_sketches(folder("."), 16);
  const StoredSketchTask task(folder("."), 128, examples, Seed{7});
  const auto heights = [](const Sample& sample) {
    return std::multiset<float>(sample.target.begin(), sample.target.end());
  };
  EXPECT_NE(heights(task.training(0)), heights(task.held_out(0)));
  const Split split = split_samples(1000, Seed{1}, [](size_t i) { return static_cast<uint64_t>(i / 4); });
  EXPECT_NEAR(static_cast<double>(split.held_out.size()), 200, 60);
  for (const size_t i : split.held_out)
    EXPECT_EQ(std::count(split.learned.begin(), split.learned.end(), i / 4 * 4), 0) << "groups stay together";
  EXPECT_THROW(split_samples(0, Seed{1}, [](size_t i) { return static_cast<uint64_t>(i); }), InvalidArgument);
}

TEST(StoredSketches, FilesThatAreMissingOrOfAnotherSizeAreErrorsWithTheirName) {
  const io::TestFolder folder;
  std::vector<StoredSketch> examples = write_sketches(folder("."), 12);
  io::write_png(Image(64, 64), sample_file(folder("."), 3, "sketch"));
  std::filesystem::remove(sample_file(folder("."), 5, "height"));
  const StoredSketchTask task(folder("."), 128, examples, Seed{7});
  std::set<std::string> said;
  for (uint64_t n = 0; n < 80; ++n) {
    try {
      task.training(n);
    } catch (const IoError& error) {
      said.insert(error.what());
    }
  }
  EXPECT_LE(said.size(), 2U);
  EXPECT_TRUE(std::any_of(said.begin(), said.end(), [](const std::string& s) {
    return s.find("000003_sketch") != std::string::npos && s.find("64 x 64") != std::string::npos;
  }));
  EXPECT_THROW(StoredSketchTask(folder("."), 48, examples, Seed{7}), InvalidArgument);
}

TEST(StoredIslands, SamplesShowTheHeightsOfTheirMaps) {
  const io::TestFolder folder;
  const IslandSetParams params{.size = 64};
  constexpr size_t kCount = 24;
  for (uint64_t i = 0; i < kCount; ++i) {
    IslandSample sample = draw_island_sample(params, i, Seed{3});
    make_island_files(params, sample, Seed{3}, folder("."), {});
  }
  const StoredIslandTask task(folder("."), params, kCount, Seed{5});
  int land = 0;
  for (uint64_t n = 0; n < 12; ++n) {
    const Sample sample = task.training(n);
    ASSERT_EQ(sample.size, 64);
    ASSERT_EQ(sample.planes.size(), 64U * 64U * learned::kIslandPlanes);
    EXPECT_TRUE(std::all_of(sample.target.begin(), sample.target.end(), [](float z) { return std::isfinite(z); }));
    land += std::any_of(sample.target.begin(), sample.target.end(), [](float z) { return z > 0; });
  }
  EXPECT_GT(land, 2);
  EXPECT_NE(task.training(0).target, task.held_out(0).target);
}

}  // namespace
}  // namespace seamount::train
