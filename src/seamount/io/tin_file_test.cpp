#include "seamount/io/tin_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "seamount/base/error.h"
#include "seamount/io/test_files.h"

namespace seamount::io {
namespace {

using ::testing::HasSubstr;

Tin square() {
  Tin tin;
  tin.nodes = {{0, 0}, {1e6, 0}, {1e6, 10.5}, {0, 10.5}};
  tin.triangles = {{0, 1, 2}, {0, 2, 3}};
  return tin;
}

std::string written(const Tin& tin) {
  const TestFolder folder;
  write_tin(tin, folder("t.ply"));
  const std::vector<uint8_t> bytes = read_file(folder("t.ply"));
  return {bytes.begin(), bytes.end()};
}

TEST(TinFile, HoldsNodesAndTriangles) {
  Tin tin = square();
  const std::string plain = written(tin);
  const size_t body = plain.find("end_header\n") + 11;
  EXPECT_THAT(plain, HasSubstr("element vertex 4\n"));
  EXPECT_THAT(plain, HasSubstr("element face 2\n"));
  EXPECT_EQ(plain.size() - body, 4U * 20U + 2U * 13U);
  double x = 0.0;
  std::memcpy(&x, plain.data() + body + 20, sizeof x);
  EXPECT_EQ(x, 1e6);
  tin.region = {0, 0, 0, -1};
  tin.rank = {0.125F, 0.375F, 0.625F, 0.0F};
  tin.height_m = {1, 2, 3, 4};
  const std::string grown = written(tin);
  EXPECT_THAT(grown, HasSubstr("property int region\nproperty float rank\n"));
  EXPECT_EQ(grown.size() - grown.find("end_header\n") - 11, 4U * 28U + 2U * 13U);
}

Tin grown() {
  Tin tin = square();
  tin.frame = {10, 20, 0.1, -0.05, 1e6 / 3, "LOCAL_CS[\"here\"]"};
  tin.regions.resize(2);
  tin.regions[0].name = "low land";
  tin.regions[0].height_m = 12.25;
  tin.regions[1].parent = 0;
  tin.regions[0].outline = {{0.1, 0}, {1e6, 1.0 / 3}, {1e6, 10}};
  tin.regions[1].basin = true;
  tin.regions[1].peak_m = -3.5;
  tin.bed_m = {Tin::kNoBed, 1.25F, Tin::kNoBed, 0.1F};
  tin.region = {0, 1, 0, -1};
  tin.rank = {0.1F, 0.375F, 0.625F, 0.0F};
  return tin;
}

TEST(TinFile, ComesBackAsItWas) {
  const TestFolder folder;
  Tin tin = grown();
  for (const bool heights : {false, true}) {
    if (heights) tin.height_m = {1.5F, -2.0F, 3.25F, 0.1F};
    write_tin(tin, folder("t.ply"));
    EXPECT_EQ(read_tin(folder("t.ply")), tin);
  }
}

Tin from_text(const std::string& text) {
  return read_tin({reinterpret_cast<const uint8_t*>(text.data()), text.size()}, "t.ply");
}

const std::string kText =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty uchar "
    "red\n"
    "element face 1\nproperty list uchar uint vertex_index\nend_header\n0 0 5 255\n0 10 6 0\n10 0 7.5 0\n3 0 1 2\n";

TEST(TinFile, TextOfOtherProgramsIsTurnedCounterClockwise) {
  const Tin tin = from_text(kText);
  EXPECT_EQ(tin.height_m, (std::vector<float>{5, 6, 7.5F}));
  EXPECT_EQ(tin.triangles.at(0), (std::array<int32_t, 3>{0, 2, 1}));
}

TEST(TinFile, CommentsOfOtherProgramsSayNothing) {
  std::string text = kText;
  text.replace(text.find("element vertex"), 0, "comment no warranty\ncomment frame 25\ncomment region north\n");
  EXPECT_EQ(from_text(text), from_text(kText));
}

TEST(TinFile, DamagedFilesAreRefusedAtEveryLength) {
  const std::string whole = written(grown());
  for (size_t length = 0; length < whole.size(); ++length) EXPECT_THROW(from_text(whole.substr(0, length)), IoError);
  for (size_t length = 0; length + 2 < kText.size(); ++length)
    EXPECT_THROW(from_text(kText.substr(0, length)), IoError) << length;
  const auto with = [](const std::string& what, const std::string& instead) {
    std::string text = kText;
    return from_text(text.replace(text.find(what), what.size(), instead));
  };
  EXPECT_THROW(with("vertex 3", "vertex 99999999"), IoError);
  EXPECT_THROW(with("3 0 1 2", "3 0 1 3"), IoError);
  EXPECT_THROW(with("3 0 1 2", "4 0 1 2 0"), IoError);
  EXPECT_THROW(with("ascii", "binary_big_endian"), IoError);
  EXPECT_THROW(with("7.5", "nan"), IoError);
  EXPECT_THROW(with("float z", "quad z"), IoError);
  EXPECT_THROW(with("element vertex", "comment seamount frame 1 0 1 0 0\nelement vertex"), IoError);
  EXPECT_THROW(with("element vertex", "comment seamount region 0 tall hill\nelement vertex"), IoError);
  EXPECT_THROW(with("element vertex", "comment seamount outline 0 0\nelement vertex"), IoError);
}

TEST(TinFile, SaysWhereItCouldNotBeWritten) {
  const TestFolder folder;
  write_tin(square(), folder("t.ply"));
  EXPECT_THROW(write_tin(square(), folder("t.ply/under/a/file.ply")), IoError);
}

}  // namespace
}  // namespace seamount::io
