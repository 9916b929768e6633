#include "seamount/recipe/loaded_networks.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "seamount/base/error.h"
#include "seamount/io/test_files.h"
#include "seamount/io/weights.h"
#include "seamount/ops/learned/test_network.h"

namespace seamount::recipe {
namespace {

using learned::Precision;

TEST(LoadedNetworks, AreReadOnceAndAgainWhenTheirFileHoldsOtherWeights) {
  const io::TestFolder folder;
  const std::string path = folder("w.safetensors");
  io::write_weights(learned::random_weights({3, {8, 8, 8, 8}}), path, io::WeightType::f32);
  const auto first = loaded_network(path, Precision::f32);
  EXPECT_EQ(loaded_network(path, Precision::f32), first);
  io::write_weights(learned::random_weights({5, {8, 8, 8, 8}}), path, io::WeightType::f32);
  const auto second = loaded_network(path, Precision::f32);
  EXPECT_EQ(first->architecture().planes, 3);
  EXPECT_EQ(second->architecture().planes, 5);
  // Back to what it was: the same network, wherever it lies.
  io::write_weights(learned::random_weights({3, {8, 8, 8, 8}}), folder("copy.safetensors"), io::WeightType::f32);
  EXPECT_EQ(loaded_network(folder("copy.safetensors"), Precision::f32), first);
}

TEST(LoadedNetworks, AnotherPrecisionIsAnotherNetwork) {
  const io::TestFolder folder;
  const std::string path = folder("w.safetensors");
  io::write_weights(learned::random_weights({3, {8, 8, 8, 8}}, 7), path, io::WeightType::f32);
  EXPECT_NE(loaded_network(path, Precision::automatic), loaded_network(path, Precision::f32));
  EXPECT_EQ(loaded_network(path, Precision::f32)->precision(), Precision::f32);
}

TEST(LoadedNetworks, AFileThatIsGoneOrDamagedIsAnErrorEachTime) {
  const io::TestFolder folder;
  const std::string path = folder("w.safetensors");
  EXPECT_THROW(loaded_network(path, Precision::f32), IoError);
  io::write_weights(learned::random_weights({3, {8, 8, 8, 8}}, 9), path, io::WeightType::f32);
  loaded_network(path, Precision::f32);
  std::filesystem::resize_file(path, 100);
  for (int i = 0; i < 2; ++i) EXPECT_THROW(loaded_network(path, Precision::f32), IoError);
}

}  // namespace
}  // namespace seamount::recipe
