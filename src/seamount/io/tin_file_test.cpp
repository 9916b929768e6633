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

TEST(TinFile, SaysWhereItCouldNotBeWritten) {
  const TestFolder folder;
  write_tin(square(), folder("t.ply"));
  EXPECT_THROW(write_tin(square(), folder("t.ply/under/a/file.ply")), IoError);
}

}  // namespace
}  // namespace seamount::io
