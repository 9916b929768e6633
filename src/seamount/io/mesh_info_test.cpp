#include "seamount/io/mesh_info.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "seamount/io/atomic_file.h"
#include "seamount/io/mesh_file.h"
#include "seamount/io/test_files.h"
#include "seamount/io/tin_file.h"

namespace seamount::io {
namespace {

using ::testing::Contains;
using ::testing::Pair;

/// A pyramid over 20 m x 14 m, 6 m high, a metre below the sea; two of its corners have two vertices.
Mesh pyramid() {
  MeshPart part{.positions = {-10, 7, -1, -10, -7, -1, 10, -7, -1, 10, 7, -1, 0, 0, 5, -10, 7, -1, 10, 7, -1},
                .normals = {},
                .uvs = {},
                .indices = {0, 1, 4, 1, 2, 4, 2, 3, 4, 6, 5, 4, 0, 2, 1, 0, 3, 2},
                .hard_edges = true};
  for (size_t v = 0; v < 7; ++v) part.normals.insert(part.normals.end(), {0, 0, 1});
  for (size_t v = 0; v < 7; ++v) part.uvs.insert(part.uvs.end(), {0.5F, 0.5F});
  return {.parts = {part}, .origin = {5155.5, 6895}, .crs = "EPSG:32604", .largest_error_m = 1.25, .rms_error_m = 0.5};
}

TEST(DescribeMesh, TellsTheSameOfEveryFormat) {
  const TestFolder folder;
  for (const std::string extension : {".glb", ".obj", ".ply", ".stl"}) {
    const std::string path = folder("p" + extension);
    write_mesh(pyramid(), path);
    const FileInfo info = *describe_mesh(path);
    EXPECT_THAT(info, Contains(Pair("triangles", "6")));
    EXPECT_THAT(info, Contains(Pair("vertices", extension == ".glb" ? "7" : "5"))) << "only GLB has some twice";
    EXPECT_THAT(info, Contains(Pair("parts", "1")));
    EXPECT_THAT(info, Contains(Pair("extent", "20 m x 14 m")));
    EXPECT_THAT(info, Contains(Pair("heights", "-1 m to 5 m")));
  }
}

TEST(DescribeMesh, TellsWhatAGlbSaysOfItsTerrain) {
  const TestFolder folder;
  Mesh mesh = pyramid();
  mesh.offset = {300, -200};
  write_mesh(mesh, folder("p.glb"));
  const FileInfo info = *describe_mesh(folder("p.glb"));
  EXPECT_THAT(info, Contains(Pair("from the terrain", "at most 1.25 m, 0.5 m rms")));
  EXPECT_THAT(info, Contains(Pair("middle of the terrain", "5155.5 m, 6895 m")));
  EXPECT_THAT(info, Contains(Pair("extent", "20 m x 14 m"))) << "wherever it lies";
}

TEST(DescribeMesh, ReadsWhatOtherProgramsWrite) {
  const TestFolder folder;
  write_text(folder("quad.obj"), "# no objects\nv 0 1 0\r\nv 2 1 0\r\nv 2 1 -3\nv 0 4.5 -3\nf 1 2 3 4\n");
  EXPECT_THAT(*describe_mesh(folder("quad.obj")), Contains(Pair("triangles", "2")));
  EXPECT_THAT(*describe_mesh(folder("quad.obj")), Contains(Pair("heights", "1 m to 4.5 m")));
  write_text(folder("a.stl"),
             "solid a\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 1\n   vertex 2 0 1e0\n   vertex 0 3 7\n"
             "  endloop\n endfacet\nendsolid a\n");
  EXPECT_THAT(*describe_mesh(folder("a.stl")), Contains(Pair("vertices", "3")));
  EXPECT_THAT(*describe_mesh(folder("a.stl")), Contains(Pair("extent", "2 m x 3 m")));
}

TEST(DescribeMesh, LeavesNetworksAndOtherFilesToOthers) {
  const TestFolder folder;
  Tin tin;
  tin.frame = GridFrame::centred(10, 10, 1);
  tin.nodes = {{0, 0}, {1, 0}, {0, 1}};
  tin.triangles = {{0, 1, 2}};
  write_tin(tin, folder("tin.ply"));
  EXPECT_FALSE(describe_mesh(folder("tin.ply")));
  EXPECT_FALSE(describe_mesh(folder("none.tif")));
}

TEST(DescribeMesh, RefusesWhatIsDamaged) {
  const TestFolder folder;
  for (const std::string extension : {".glb", ".ply", ".stl"}) {
    write_mesh(pyramid(), folder("p" + extension));
    const std::vector<uint8_t> whole = read_file(folder("p" + extension));
    for (size_t length = 0; length < whole.size(); length += 7)
      EXPECT_THROW(describe_mesh(std::span(whole).first(length), "p" + extension), IoError)
          << extension << " " << length;
  }
  const auto glb = [](const std::string& json) {
    std::vector<uint8_t> bytes(20 + json.size());
    const std::array<uint32_t, 5> header{0x46546C67, 2, static_cast<uint32_t>(bytes.size()),
                                         static_cast<uint32_t>(json.size()), 0x4E4F534A};
    std::memcpy(bytes.data(), header.data(), 20);
    std::copy(json.begin(), json.end(), bytes.begin() + 20);
    return bytes;
  };
  for (const std::string json :
       {"", "{", "[]", "{}", R"({"scenes":[{"nodes":[7]}]})", R"({"scenes":[{"nodes":[-1]}],"nodes":[]})",
        R"({"scenes":[{"nodes":[0]}],"nodes":[{"children":[0,0]}]})",
        R"({"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":9}}]}]})"})
    EXPECT_THROW(describe_mesh(glb(json), "x.glb"), IoError) << json;
}

}  // namespace
}  // namespace seamount::io
