// Algorithm 3 of P0: what is drawn (eq. 1.16 to 1.18), what augmentation keeps, and sets that survive a kill.
#include "seamount/train/island_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "seamount/geom/scalar/curve.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/train/island_set.h"
#include "seamount/train/sample_set.h"

namespace seamount::train {
namespace {

namespace fs = std::filesystem;

IslandSetParams small() { return {.size = 64}; }

TEST(DrawIslandSample, OutlinesStayOrderedAtEveryAngle) {
  for (uint64_t index = 0; index < 80; ++index) {
    for (const IslandDraw& island : draw_island_sample(small(), index, Seed{1}).islands) {
      for (size_t i = 0; i + 1 < island.outlines.size(); ++i) {
        for (size_t a = 0; a < island.outlines[i].radii_m.size(); ++a) {
          ASSERT_LT(island.outlines[i].radii_m[a], island.outlines[i + 1].radii_m[a]) << index;
        }
      }
    }
  }
}

TEST(TimesNoise, IsEquations1_17And1_18) {
  const Curve profile{{{0, 900}, {1, 20}, {2, 0}, {5, -700}}};
  const geom::CurveFunction base(profile);
  const Curve noisy = times_noise(profile, 0.25, -600, 950, Seed{4});
  ASSERT_EQ(noisy.knots.size(), 51U);
  for (const Knot& knot : noisy.knots) {
    const double expected = base(knot.x) * (1.0 + 0.25 * geom::fbm1(Seed{4}, 1.3 * knot.x, 2));
    EXPECT_NEAR(knot.y, std::clamp(expected, -600.0, 950.0), 0.0006) << knot.x;
  }
}

TEST(DrawIslandSample, ProfilesKeepTheCoastAndTheirSign) {
  for (uint64_t index = 0; index < 40; ++index) {
    const IslandDraw island = draw_island_sample(small(), 4 * index, Seed{2}).islands.front();
    const bool atoll = island.outlines[1].radii_m[0] < 10;  // no land, so no coast to keep
    for (const Knot& knot : island.profile.knots) {
      if (atoll) continue;
      EXPECT_TRUE(knot.x > 1.95 || knot.y >= 0) << index;  // a product with noise around 1 does not move where it is 0
      EXPECT_TRUE(std::abs(knot.x - 2.0) > 1e-9 || std::abs(knot.y) < 1e-9);
      EXPECT_TRUE(knot.x < 2.05 || knot.y <= 0);
    }
    for (const Knot& knot : island.resistance.knots) EXPECT_TRUE(knot.y >= 0 && knot.y <= 1);
  }
}

TEST(DrawIslandSample, LevelsOfOneIslandDifferInSubsidenceOnly) {
  IslandSetParams params = small();
  params.several = 0;
  for (uint64_t level = 0; level < 4; ++level) {
    const IslandSample sample = draw_island_sample(params, 20 + level, Seed{3});
    EXPECT_EQ(sample.islands[0].outlines, draw_island_sample(params, 20, Seed{3}).islands[0].outlines);
    EXPECT_GE(sample.subsidence, static_cast<double>(level) / 4);
    EXPECT_LE(sample.subsidence, static_cast<double>(level + 1) / 4);
  }
  EXPECT_NE(draw_island_sample(params, 24, Seed{3}).islands[0].outlines,
            draw_island_sample(params, 20, Seed{3}).islands[0].outlines);
}

TEST(DrawIslandSample, HoldsElongatedIslandsRemnantsAndAtolls) {
  int elongated = 0, remnants = 0, atolls = 0;
  constexpr int kIslands = 120;
  for (uint64_t index = 0; index < kIslands; ++index) {
    const IslandDraw island = draw_island_sample(small(), 4 * index, Seed{9}).islands.front();
    const std::vector<double>&coast = island.outlines[1].radii_m, &lagoon = island.outlines[2].radii_m;
    double xx = 0, yy = 0, xy = 0, land = 0, within = 0;
    for (size_t a = 0; a < coast.size(); ++a) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(a) / static_cast<double>(coast.size());
      const double fourth = std::pow(lagoon[a], 4);
      xx += fourth * std::cos(angle) * std::cos(angle);
      yy += fourth * std::sin(angle) * std::sin(angle);
      xy += fourth * std::cos(angle) * std::sin(angle);
      land += coast[a] * coast[a];
      within += lagoon[a] * lagoon[a];
    }
    const double middle = 0.5 * (xx + yy), spread = std::hypot(0.5 * (xx - yy), xy);
    elongated += std::sqrt((middle + spread) / (middle - spread)) > 1.5 ? 1 : 0;
    remnants += land < 0.3 * within && land > 0.001 * within ? 1 : 0;
    atolls += land < 1e-4 * within ? 1 : 0;
  }
  EXPECT_GT(elongated, kIslands / 8);
  EXPECT_GT(remnants, kIslands / 14);
  EXPECT_GT(atolls, kIslands / 20);
}

TEST(MakeIslandPair, AnAtollHasALagoonWithoutLandInIt) {
  IslandSetParams params = small();
  params.several = 0;
  int seen = 0;
  for (uint64_t index = 0; index < 160 && seen < 3; ++index) {
    IslandSample sample = draw_island_sample(params, index, Seed{9});
    if (sample.islands[0].outlines[1].radii_m[0] > 10) continue;
    ++seen;
    const IslandPair pair = make_island_pair(params, sample, Seed{9}, {});
    int lagoon = 0;
    for (size_t c = 0; c < pair.labels.size(); ++c) {
      EXPECT_GE(pair.labels.cells()[c], Region::lagoon);
      if (pair.labels.cells()[c] != Region::lagoon) continue;
      ++lagoon;
      EXPECT_LT(pair.terrain.cells()[c], 0.0F);
    }
    EXPECT_GT(lagoon, 20);
  }
  EXPECT_EQ(seen, 3);
}

TEST(MakeIslandPair, IsTheSameAloneAndOnAnyNumberOfThreads) {
  const auto make = [](int threads) {
    IslandSample sample = draw_island_sample(small(), 17, Seed{5});
    return make_island_pair(small(), sample, Seed{5}, {.threads = threads});
  };
  const IslandPair one = make(1), two = make(2);
  EXPECT_EQ(one.terrain, two.terrain);
  EXPECT_EQ(one.labels, two.labels);
}

TEST(MakeIslandPair, SeveralIslandsOverlapByATenthAtMost) {
  IslandSetParams params = small();
  params.several = 1;
  int with_several = 0;
  for (uint64_t index = 0; index < 24; ++index) {
    IslandSample sample = draw_island_sample(params, index, Seed{6});
    make_island_pair(params, sample, Seed{6}, {});
    ASSERT_GE(sample.islands.size(), 1U);
    ASSERT_EQ(sample.islands.size(), sample.augmentation.places.size());
    with_several += sample.islands.size() > 1 ? 1 : 0;
    // Each pair of islands alone, placed as recorded: the record must describe the picture.
    std::vector<LabelMap> alone;
    for (size_t i = 0; i < sample.islands.size(); ++i) {
      IslandSample one = sample;
      one.islands = {sample.islands[i]};
      one.augmentation.places = {sample.augmentation.places[i]};
      one.augmentation.turns_deg = {sample.augmentation.turns_deg[i]};
      one.augmentation.scales = {sample.augmentation.scales[i]};
      alone.push_back(make_island_pair(params, one, Seed{6}, {}).labels);
      for (size_t j = 0; j < i; ++j) EXPECT_LE(overlap(alone[i], alone[j]), 0.1) << index;
    }
  }
  EXPECT_GT(with_several, 8);
}

TEST(MakeIslandPair, HeightsFitTheRangeOfTheImagesUncut) {
  for (uint64_t index = 0; index < 60; ++index) {
    IslandSample sample = draw_island_sample(small(), index, Seed{8});
    const IslandPair pair = make_island_pair(small(), sample, Seed{8}, {});
    for (const float z : pair.terrain.cells()) {
      ASSERT_TRUE(z > static_cast<float>(small().low_m) && z < static_cast<float>(small().high_m))
          << index << ": " << z;
    }
  }
}

TEST(MakeIslandPair, WrappingMovesCellsAndLosesNone) {
  IslandSample sample = draw_island_sample(small(), 3, Seed{7});
  sample.augmentation.shift_x = 0;
  sample.augmentation.shift_y = 0;
  IslandSample moved = sample;
  moved.augmentation.shift_x = 23;
  moved.augmentation.shift_y = -9;
  const IslandPair a = make_island_pair(small(), sample, Seed{7}, {});
  const IslandPair b = make_island_pair(small(), moved, Seed{7}, {});
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      ASSERT_EQ(b.terrain((x + 23) % 64, (y + 55) % 64), a.terrain(x, y));
      ASSERT_EQ(b.labels((x + 23) % 64, (y + 55) % 64), a.labels(x, y));
    }
  }
}

TEST(Overlap, CountsWhatIsNotAbyss) {
  LabelMap a(GridFrame::centred(4, 1, 1), Region::abyss), b = a;
  EXPECT_EQ(overlap(a, b), 0);
  a(0, 0) = a(1, 0) = Region::reef;
  b(1, 0) = b(2, 0) = Region::mountain;
  EXPECT_DOUBLE_EQ(overlap(a, b), 1.0 / 3.0);
}

/// A folder of its own for each test.
class IslandSet : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = (fs::path(::testing::TempDir()) /
               ("seamount_set_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name())))
                  .string();
    fs::remove_all(folder_);
  }
  void TearDown() override {
    fs::remove_all(folder_);
    fs::remove_all(folder_ + "_whole");
  }
  static SampleSet set(const std::string& folder, uint64_t count, uint64_t seed = 9) {
    const auto make = [folder, seed](uint64_t index, const RunContext& run) {
      IslandSample sample = draw_island_sample(small(), index, Seed{seed});
      const std::vector<std::string> digests = make_island_files(small(), sample, Seed{seed}, folder, run);
      return std::to_string(index) + " " + digests[0] + " " + digests[1];
    };
    const auto read = [](const std::string& line) {
      SampleRecord record;
      record.digests.resize(2);
      std::istringstream words(line);
      if (!(words >> record.index >> record.digests[0] >> record.digests[1])) throw Error("is damaged");
      return record;
    };
    return {folder, count, {"labels", "height"}, "set " + std::to_string(seed), make, read};
  }
  static std::string content(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
  }
  std::string folder_;
};

TEST_F(IslandSet, GoesOnAfterAKillWithoutAGapOrADuplicate) {
  const std::string whole = folder_ + "_whole";
  make_sample_set(set(whole, 70), {});
  make_sample_set(set(folder_, 40), {});
  // Killed while a line was being written, with files of a sample that has no line yet.
  const std::string manifest = folder_ + "/manifest.jsonl";
  const std::string lines = content(manifest);
  std::ofstream(manifest, std::ios::binary) << lines.substr(0, lines.size() - 7);
  std::ofstream(folder_ + "/000041_height.png") << "half a picture";
  const SampleSetReport report = make_sample_set(set(folder_, 70), {});
  EXPECT_EQ(report.present, 39U);
  EXPECT_EQ(report.made, 31U);
  size_t files = 0;
  for (const auto& entry : fs::directory_iterator(whole)) {
    ++files;
    EXPECT_EQ(content(entry.path().string()), content(folder_ + "/" + entry.path().filename().string()))
        << entry.path();
  }
  EXPECT_EQ(files, 141U);
}

TEST_F(IslandSet, RefusesAFolderOfAnotherSet) {
  make_sample_set(set(folder_, 2), {});
  EXPECT_THROW(make_sample_set(set(folder_, 4, 10), {}), InvalidArgument);
  EXPECT_EQ(make_sample_set(set(folder_, 2), {}).made, 0U);
}

TEST_F(IslandSet, MakesMissingFilesAgainAndLeavesOthersAlone) {
  make_sample_set(set(folder_, 6), {});
  const std::string labels = folder_ + "/000002_labels.png", height = folder_ + "/000004_height.png";
  const std::string before = content(labels);
  fs::remove(labels);
  const SampleSetReport report = make_sample_set(set(folder_, 6), {});
  EXPECT_EQ(report.made, 1U);
  EXPECT_EQ(report.present, 5U);
  EXPECT_EQ(content(labels), before);
  std::ofstream(height, std::ios::binary | std::ios::app) << "x";
  const std::string changed = content(height);
  try {
    make_sample_set(set(folder_, 8), {});
    FAIL();
  } catch (const IoError& error) {
    EXPECT_EQ(std::string(error.what()),
              height + ": is not the file that the manifest describes; remove it, and it is made again");
  }
  EXPECT_EQ(content(height), changed);
}

TEST_F(IslandSet, ReadsEveryLineOfTheManifest) {
  make_sample_set(set(folder_, 4), {});
  const std::string manifest = folder_ + "/manifest.jsonl", all = content(manifest);
  const auto refusal = [&](const std::string& text) {
    std::ofstream(manifest, std::ios::binary) << text;
    try {
      make_sample_set(set(folder_, 6), {});
    } catch (const IoError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const size_t second = all.find('\n', all.find('\n') + 1) + 1, third = all.find('\n', second) + 1;
  const std::string remedy = "; take this line and all after it away, and their samples are made again";
  EXPECT_EQ(refusal(all.substr(0, second) + all.substr(third)),
            manifest + ": line 3: is of sample 2, not of 1" + remedy);
  EXPECT_EQ(refusal(all.substr(0, second) + "x\n" + all.substr(third)), manifest + ": line 3: is damaged" + remedy);
  EXPECT_EQ(refusal(all.substr(0, second)), "");
  EXPECT_EQ(content(manifest).substr(0, all.size()), all);
}

TEST_F(IslandSet, SamplesWithoutAManifestAreNotOverwritten) {
  make_sample_set(set(folder_, 2), {});
  fs::remove(folder_ + "/manifest.jsonl");
  EXPECT_THROW(make_sample_set(set(folder_, 2), {}), InvalidArgument);
}

TEST_F(IslandSet, StopsWhenCancelledAndKeepsWhatIsFinished) {
  std::atomic<bool> cancelled{false};
  const RunContext run{.progress = [&](double) { cancelled = true; }, .cancelled = &cancelled};
  EXPECT_THROW(make_sample_set(set(folder_, 1000), run), Cancelled);
  const SampleSetReport report = make_sample_set(set(folder_, 40), {});
  EXPECT_EQ(report.present, 32U);
  EXPECT_EQ(report.made, 8U);
}

}  // namespace
}  // namespace seamount::train
