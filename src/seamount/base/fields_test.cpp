#include "seamount/base/fields.h"

#include <gtest/gtest.h>

namespace seamount {
namespace {

struct ReefParams {
  double subsidence = 0.0;
  int strokes = 3;
  std::optional<double> width_m;
  static constexpr auto fields() {
    return std::tuple(field(&ReefParams::subsidence, "subsidence", "", between(0, 1), "share that has sunk"),
                      field(&ReefParams::strokes, "strokes", "", between(0, 100), "number of strokes"),
                      field(&ReefParams::width_m, "width_m", "m", at_least(1), "width"));
  }
};

std::string message_of(const ReefParams& params) {
  try {
    check_params(params);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

TEST(Fields, ChecksNameTheFieldTheValueAndTheRange) {
  EXPECT_EQ(message_of({}), "");
  EXPECT_EQ(message_of({.subsidence = 1.5}), "subsidence: 1.5 is outside [0, 1]");
  EXPECT_EQ(message_of({.strokes = -1}), "strokes: -1 is outside [0, 100]");
  EXPECT_EQ(message_of({.width_m = 0.5}), "width_m: 0.5 is outside [1, inf)");
  EXPECT_EQ(message_of({.subsidence = std::nan("")}), "subsidence: nan is outside [0, 1]");
}

TEST(Text, SuggestsTheNearestName) {
  const std::vector<std::string> names = {"island.build", "island.wind", "island.coral"};
  EXPECT_EQ(suggestion("island.biuld", names), ", did you mean 'island.build'?");
  EXPECT_EQ(suggestion("xyz", names), ", known are: island.build, island.wind, island.coral");
  EXPECT_EQ(nearest_name(std::string(100000, 'a'), names), std::nullopt);
}

TEST(Text, SuggestsNamesOfWhichItIsAPart) {
  const std::vector<std::string> names = {"erosion.run",  "erosion.thermal", "terrain.crop",
                                          "contour.grow", "reef.grow",       "light.sun_azimuth_deg"};
  EXPECT_EQ(suggestion("erosion", names), ", did you mean 'erosion.run' or 'erosion.thermal'?");
  EXPECT_EQ(suggestion("crop", names), ", did you mean 'terrain.crop'?");
  EXPECT_EQ(suggestion("grow", names), ", did you mean 'contour.grow' or 'reef.grow'?");
  EXPECT_EQ(suggestion("azimuth", names), ", did you mean 'light.sun_azimuth_deg'?");
  EXPECT_EQ(suggestion("--sun_azimuth_deg", {"--out", "--light.sun_azimuth_deg"}),
            ", did you mean '--light.sun_azimuth_deg'?");
  EXPECT_EQ(suggestion("cro", {"terrain.crop"}), ", known are: terrain.crop");
  EXPECT_EQ(suggestion("a", std::vector<std::string>(9, "b.a")),
            ", did you mean 'b.a', 'b.a', 'b.a', 'b.a', 'b.a', 'b.a', ...?");
}

TEST(Text, NumbersAreShortAndReadBack) {
  EXPECT_EQ(format_number(0.1), "0.1");
  EXPECT_EQ(format_number(2500), "2500");
  EXPECT_EQ(format_range(0, 1), "[0, 1]");
}

}  // namespace
}  // namespace seamount
