#include "seamount/ops/erosion/hardness.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace seamount::erosion {
namespace {

using testing::HasSubstr;

/// A map of three cells as a run takes it, and what is said of it.
std::pair<std::vector<float>, std::string> settled(std::vector<float> values) {
  ScalarField map(GridFrame{3, 1});
  std::copy(values.begin(), values.end(), map.data());
  std::string said;
  RunContext run;
  run.note = [&](const std::string& note) { said += note; };
  settle_hardness(map, run);
  return {{map.cells().begin(), map.cells().end()}, said};
}

TEST(Hardness, OfAPictureIsNeverNone) {
  const auto [map, said] = settled({0.0F, 0.5F, 1.0F});
  EXPECT_FLOAT_EQ(map[0], 1.0F);
  EXPECT_FLOAT_EQ(map[1], std::sqrt(kHardestOfPicture));
  EXPECT_FLOAT_EQ(map[2], kHardestOfPicture);
  EXPECT_THAT(said, HasSubstr("like a mask"));
  EXPECT_EQ(settled({0.0F, 0.0F, 0.0F}).first, (std::vector<float>{1, 1, 1}));
}

TEST(Hardness, FactorsStayAndAreBounded) {
  for (const auto& factors : {std::vector<float>{0.5F, 1.0F, 0.2F}, {1.0F, 7.0F, 400.0F}}) {
    const auto [map, said] = settled(factors);
    EXPECT_EQ(map, factors);
    EXPECT_EQ(said, "");
  }
  const auto [map, said] = settled({0.0F, 0.05F, 2.0F});
  EXPECT_EQ(map, (std::vector<float>{kSoftest, kSoftest, 2.0F}));
  EXPECT_THAT(said, HasSubstr("2 of 3 cells"));
}

}  // namespace
}  // namespace seamount::erosion
