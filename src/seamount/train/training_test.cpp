#include "seamount/train/training.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <numeric>

#include "seamount/base/error.h"
#include "seamount/io/weights.h"
#include "seamount/ops/learned/network.h"
#include "seamount/train/ground_tiles.h"
#include "seamount/train/island_task.h"
#include "seamount/train/sketch_crop.h"

namespace seamount::train {
namespace {

/// The target is the blurred sign of the one drawn plane: small, quick, and learnable.
class Stripes : public Task {
 public:
  std::string name() const override { return "stripes"; }
  learned::Architecture architecture() const override { return {2, {8, 16}}; }
  std::vector<int> drawn_planes() const override { return {0}; }
  Sample training(uint64_t n) const override { return sample(n); }
  Sample held_out(uint64_t n) const override { return sample(n + 1000000); }

 private:
  static Sample sample(uint64_t n) {
    Rng rng(Seed{n});
    Sample s;
    s.size = 32;
    const double phase = rng.uniform(0, 6), wave = rng.uniform(0.2, 0.5);
    for (int i = 0; i < 32 * 32; ++i) {
      const double v = std::sin(wave * (i % 32) + phase);
      s.planes.push_back(v > 0 ? 1.0F : -1.0F);
      s.planes.push_back(static_cast<float>(rng.uniform(-1, 1)));
      s.target.push_back(static_cast<float>(0.5 * v));
    }
    s.base.assign(s.target.size(), 0.0F);
    s.weight.assign(s.target.size(), 1.0F);
    return s;
  }
};

class Training : public testing::Test {
 protected:
  void SetUp() override {
    if (!can_train()) GTEST_SKIP() << "built without libtorch";
    folder_ = std::filesystem::temp_directory_path() / ("seamount_training_" + std::to_string(::getpid()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override {
    if (!folder_.empty()) std::filesystem::remove_all(folder_);
  }
  Check train(const std::string& name, int samples, int critic_from = 100000, const RunContext& run = two()) {
    TrainingParams params;
    params.samples = samples;
    params.batch = 2;
    params.rate = 2e-3;
    params.check_every = 20;
    params.checks = 4;
    params.critic_from = critic_from;
    return train_network(
        Stripes(), params, {file(name + ".safetensors"), file(name + ".checkpoint"), "", ""}, Seed{5},
        [](const std::string&) {}, run);
  }
  static RunContext two() {
    RunContext run;
    run.threads = 2;
    return run;
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  std::filesystem::path folder_;
};

TEST_F(Training, LearnsAndGoesOnAfterAStop) {
  const Check first = train("a", 40);
  const Check later = train("a", 600);
  EXPECT_EQ(later.samples, 600);
  EXPECT_LT(later.error, 0.6 * first.error);
  const Check whole = train("b", 600);
  EXPECT_NEAR(whole.error, later.error, 0.3 * whole.error);
}

TEST_F(Training, AStoppedRunGoesOnAsIfItHadNotBeen) {
  std::atomic<bool> stop = false;
  RunContext run;
  run.threads = 2;
  run.cancelled = &stop;
  run.progress = [&](double done) { stop = done > 0.35; };
  EXPECT_THROW(train("parts", 200, 60, run), Cancelled);
  EXPECT_LT(std::stoi(io::read_weights(file("parts.checkpoint")).about.at("samples")), 100);
  train("parts", 200, 60);
  train("whole", 200, 60);
  const Weights parts = io::read_weights(file("parts.checkpoint")), whole = io::read_weights(file("whole.checkpoint"));
  ASSERT_EQ(parts.tensors.size(), whole.tensors.size());
  for (const auto& [name, tensor] : whole.tensors) {
    const Tensor& other = parts.tensors.at(name);
    ASSERT_EQ(other.values.size(), tensor.values.size()) << name;
    for (size_t i = 0; i < tensor.values.size(); ++i)
      ASSERT_NEAR(other.values[i], tensor.values[i], 1e-4 * (1 + std::abs(tensor.values[i]))) << name;
  }
}

TEST_F(Training, InferenceIsTheTrainedNetwork) {
  const Check check = train("c", 200);
  const learned::Network network(io::read_weights(file("c.safetensors")), learned::Precision::f32);
  double error = 0;
  for (uint64_t n = 0; n < 4; ++n) {
    const Sample sample = Stripes().held_out(n);
    const learned::Planes planes{32, 32, 2, [&](int begin, int end, std::span<float> values) {
                                   std::copy_n(sample.planes.begin() + 64 * begin, 64 * (end - begin), values.begin());
                                 }};
    const ScalarField made = network.evaluate(planes, GridFrame::centred(32, 32, 1), {});
    for (size_t i = 0; i < made.size(); ++i) error += std::abs(made.data()[i] - sample.target[i]);
  }
  EXPECT_NEAR(error / (4 * 32 * 32), check.error, 0.02 * check.error);  // bf16 in training, f16 weights
}

TEST(TrainingFiles, ADamagedCheckpointIsAnError) {
  if (!can_train()) GTEST_SKIP() << "built without libtorch";
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("seamount_damaged_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  Weights wrong;
  wrong.about["samples"] = "3";
  wrong.tensors["generator.input.weight"] = {{1}, {0}};
  io::write_weights(wrong, (folder / "x.checkpoint").string(), io::WeightType::f32);
  EXPECT_THROW(
      train_network(Stripes(), {}, {(folder / "x.safetensors").string(), (folder / "x.checkpoint").string(), "", ""},
                    Seed{1}, [](const std::string&) {}, {}),
      IoError);
  std::filesystem::remove_all(folder);
}

/// A tent along the diagonal with a valley beside it, whose lines are known.
TEST(SketchCrop, LinesLieWhereTheGroundSaysInEveryTurn) {
  GridFrame frame = GridFrame::centred(400, 400, 30);
  HeightField tile(frame);
  for (int y = 0; y < 400; ++y) {
    for (int x = 0; x < 400; ++x) tile(x, y) = static_cast<float>(1000 - 4 * std::abs(x - 0.5 * y - 100) + 0.3 * x);
  }
  DrawnTile drawn;
  drawn.ridges = {{{100, 0}, {299.5F, 399}}};
  int turned = 0;
  for (uint64_t n = 0; n < 60; ++n) {
    Rng rng(Seed{n});
    const std::optional<Crop> crop = find_crop(tile, 128, 0.92, rng);
    ASSERT_TRUE(crop);
    turned += crop->transpose;
    for (int i = 0; i <= 40; ++i) {
      const auto [x, y] = crop->placed({100 + 0.5F * 9.9F * static_cast<float>(i), 9.9F * static_cast<float>(i)});
      if (x < 2 || y < 2 || x > 125 || y > 125) continue;
      const int cx = static_cast<int>(std::lround(x)), cy = static_cast<int>(std::lround(y));
      int higher = 0;
      for (int dy = -6; dy <= 6; dy += 6) {
        for (int dx = -6; dx <= 6; dx += 6)
          higher += crop->heights.clamped(cx + dx, cy + dy) > crop->heights(cx, cy) + 8;
      }
      EXPECT_EQ(higher, 0) << "sample " << n;
    }
  }
  EXPECT_GT(turned, 10);
}

TEST(GroundTiles, RegionsAreOnOneSide) {
  EXPECT_EQ(is_held_out("himalaya_n27e086_1arcsec"), is_held_out("himalaya_n27e086_3arcsec"));
  int held = 0;
  for (const char* name : {"alps",      "andes",   "akan",      "zao",    "kuju",    "tuscany",  "unzen",
                           "taal",      "crop",    "canyon",    "dunes",  "luzon",   "cascades", "cederberg",
                           "patagonia", "olympic", "yakushima", "sefuri", "hakkoda", "vesuvius"})
    held += is_held_out(name);
  EXPECT_GT(held, 0);
  EXPECT_LT(held, 10);
  EXPECT_THROW(read_ground("/nowhere", false, {}), InvalidArgument);
}

TEST(IslandTask, ASampleIsAFunctionOfItsNumber) {
  const IslandTask task(Seed{3}), other(Seed{3});
  const Sample a = task.training(7);
  other.training(900);
  const Sample b = other.training(7);
  EXPECT_EQ(a.planes, b.planes);
  EXPECT_EQ(a.target, b.target);
  EXPECT_NE(a.target, task.held_out(7).target);
  for (const float z : a.target) EXPECT_LT(std::abs(z), 2.2F);
}

}  // namespace
}  // namespace seamount::train
