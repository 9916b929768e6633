// The shipped networks. Golden recipes cannot hold them, for their bits are promised on one machine only (ADR 14).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "seamount/recipe/test_calls.h"

namespace seamount::recipe {
namespace {

HeightField made(const std::string& name, const Json& params, uint64_t seed) {
  const Extent extent{128, 96, 500};
  const Operator& op = *standard_registry().find_operator(name);
  Values in;
  if (name == "learned.island") in["labels"] = example_values(extent).at("labels");
  Diagnostics diagnostics;
  const Json complete = op.complete(params, {"", diagnostics});
  EXPECT_TRUE(diagnostics.empty());
  const GridFrame frame = frame_of(extent);
  const std::string folder;
  const RunContext run;
  return op.run(complete, in, {frame, true, Seed{seed}, folder, run}).at("terrain").get<kinds::Terrain>();
}

TEST(ShippedNetworks, AreSoundInEitherPrecision) {
  for (const std::string name : {"learned.sketch", "learned.island"}) {
    const HeightField plain = made(name, {{"precision", "f32"}}, 3),
                      other = made(name, {{"precision", "automatic"}}, 3);
    const auto [low, high] = std::minmax_element(plain.cells().begin(), plain.cells().end());
    EXPECT_GT(*high - *low, 50) << name;
    EXPECT_LT(*high - *low, 6000) << name;
    double off = 0;
    for (size_t i = 0; i < plain.size(); ++i) {
      ASSERT_TRUE(std::isfinite(plain.data()[i])) << name;
      off += std::abs(plain.data()[i] - other.data()[i]);
    }
    EXPECT_LT(off / static_cast<double>(plain.size()), 0.01 * (*high - *low)) << name;
    EXPECT_EQ(other, made(name, {{"precision", "automatic"}}, 3)) << name;
    EXPECT_NE(plain, made(name, {{"precision", "f32"}}, 4)) << name;
  }
}

}  // namespace
}  // namespace seamount::recipe
