#include "seamount/io/sidecar.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "seamount/io/info.h"
#include "seamount/io/raster.h"
#include "seamount/io/test_files.h"

namespace seamount::io {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Pair;

nlohmann::json json_of(const std::string& path) {
  const auto bytes = read_file(sidecar_path(path));
  return nlohmann::json::parse(bytes.begin(), bytes.end());
}

ScalarField ramp() {
  ScalarField field(GridFrame::centred(11, 3, 5));
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 11; ++x) field(x, y) = 2.0F + static_cast<float>(x);
  return field;
}

TEST(SidecarOfFields, HasNoMetres) {
  for (const std::string name : {"x.png", "x.r16", "x.exr", "x.npy", "x.r32"}) {
    const TestFolder folder;
    write_field(ramp(), folder(name));
    const nlohmann::json json = json_of(folder(name));
    EXPECT_EQ(json["quantity"], "field");
    EXPECT_EQ(json["min"], 2);
    EXPECT_EQ(json["max"], 12);
    for (const char* metres : {"min_m", "max_m", "low_m", "high_m", "vertical_datum"})
      EXPECT_FALSE(json.contains(metres)) << name << " " << metres;
    EXPECT_LE(largest_difference(read_field(folder(name)), ramp()), 1e-4F);
    EXPECT_THAT(*describe_raster(folder(name)), Contains(Pair("values", "2 to 12")));
  }
}

TEST(SidecarOfFields, OfEarlierVersionsIsRead) {
  const TestFolder folder;
  write_field(ramp(), folder("x.r16"));
  nlohmann::json json = json_of(folder("x.r16"));
  for (const char* name : {"min", "max", "low", "high"}) {
    json[std::string(name) + "_m"] = json[name];
    json.erase(name);
  }
  write_text(sidecar_path(folder("x.r16")), json.dump());
  EXPECT_LE(largest_difference(read_field(folder("x.r16")), ramp()), 1e-4F);
  json["high_m"] = json["low_m"];
  write_text(sidecar_path(folder("x.r16")), json.dump());
  EXPECT_THAT(error_of([&] { read_field(folder("x.r16")); }), HasSubstr("high_m: must be above low_m"));
}

TEST(SidecarOfHeights, KeepsItsMetres) {
  const TestFolder folder;
  write_heights(ramp(), folder("x.r16"));
  EXPECT_EQ(json_of(folder("x.r16"))["high_m"], 12);
  EXPECT_THAT(*describe_raster(folder("x.r16")), Contains(Pair("heights", "2 m to 12 m")));
}

}  // namespace
}  // namespace seamount::io
