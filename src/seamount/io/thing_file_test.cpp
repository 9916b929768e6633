#include "seamount/io/thing_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "seamount/base/error.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/mesh_file.h"

namespace seamount::io {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;

std::vector<uint8_t> bytes_of(const std::string& text) { return {text.begin(), text.end()}; }
ThingMesh obj(const std::string& text) { return read_thing(bytes_of(text), "x.obj"); }
std::string refusal(const std::vector<uint8_t>& bytes, const std::string& name) {
  try {
    read_thing(bytes, name);
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

/// A tetrahedron, y up, as OBJ.
const char* const kTetrahedron =
    "# by hand\nv 0 0 0\nv 1 0 0 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1/7 2/7 4/7\nf 1 4 3\nf -3 -2 -1\n";

std::vector<uint8_t> glb(Json json, const std::vector<uint8_t>& bin) {
  std::string text = json.dump();
  text.append((4 - text.size() % 4) % 4, ' ');
  std::vector<uint8_t> made;
  const auto word = [&](size_t value) {
    for (int k = 0; k < 4; ++k) made.push_back(static_cast<uint8_t>(value >> 8 * k));
  };
  word(0x46546C67), word(2), word(28 + text.size() + bin.size()), word(text.size()), word(0x4E4F534A);
  made.insert(made.end(), text.begin(), text.end());
  word(bin.size()), word(0x004E4942);
  made.insert(made.end(), bin.begin(), bin.end());
  return made;
}

/// One triangle: 36 bytes of places and three indices in a byte each.
Json triangle_json() {
  return {
      {"asset", {{"version", "2.0"}}},
      {"scene", 0},
      {"scenes", {{{"nodes", {0}}}}},
      {"nodes", {{{"mesh", 0}, {"translation", {10, 0, 0}}, {"scale", {2, 2, 2}}}}},
      {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}, {"material", 0}}}}}}},
      {"materials", {{{"doubleSided", true}, {"pbrMetallicRoughness", {{"baseColorFactor", {1.0, 0.0, 0.0, 1.0}}}}}}},
      {"buffers", {{{"byteLength", 40}}}},
      {"bufferViews", {{{"buffer", 0}, {"byteLength", 36}}, {{"buffer", 0}, {"byteOffset", 36}, {"byteLength", 3}}}},
      {"accessors",
       {{{"bufferView", 0}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}},
        {{"bufferView", 1}, {"componentType", 5121}, {"count", 3}, {"type", "SCALAR"}}}}};
}
std::vector<uint8_t> triangle_bin() {
  const std::array<float, 9> places = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  std::vector<uint8_t> bin(40);
  std::memcpy(bin.data(), places.data(), 36);
  bin[37] = 1;
  bin[38] = 2;
  return bin;
}

TEST(ThingFile, ReadsObjWithItsAxesTurned) {
  const ThingMesh mesh = obj(kTetrahedron);
  EXPECT_EQ(mesh.triangle_count(), 4U);
  EXPECT_EQ(mesh.solid, mesh.indices.size());
  float high = 0, south = 0;
  for (size_t i = 0; i < mesh.positions.size(); i += 3) {
    high = std::max(high, mesh.positions[i + 2]);
    south = std::min(south, mesh.positions[i + 1]);
  }
  EXPECT_EQ(high, 2.0F);
  EXPECT_EQ(south, -3.0F);
  EXPECT_NE(std::find(mesh.colours.begin(), mesh.colours.end(), Colour{255, 0, 0}), mesh.colours.end());
}

TEST(ThingFile, ReadsMaterialsBesideAnObj) {
  const std::string folder = ::testing::TempDir() + "seamount_thing_file";
  std::filesystem::create_directories(folder);
  write_text(folder + "/m.mtl", "newmtl leaf one\nKd 0 1 0\nmap_Kd leaf.png\n");
  write_text(folder + "/a.obj", std::string("mtllib m.mtl\nusemtl leaf one\n") + kTetrahedron);
  write_text(folder + "/b.obj", std::string("mtllib missing.mtl\n") + kTetrahedron);
  std::string said;
  RunContext run;
  run.note = [&](const std::string& line) { said += line; };
  const ThingMesh mesh = read_thing(folder + "/a.obj", run);
  EXPECT_NE(std::find(mesh.colours.begin(), mesh.colours.end(), Colour{0, 255, 0}), mesh.colours.end());
  EXPECT_THAT(said, HasSubstr("its textures are not read"));
  EXPECT_EQ(read_thing(folder + "/b.obj", run).triangle_count(), 4U);
  EXPECT_THAT(said, HasSubstr("its materials are not to be read"));
  std::filesystem::remove_all(folder);
}

TEST(ThingFile, ReadsGlbNodesAndMaterials) {
  const ThingMesh mesh = read_thing(glb(triangle_json(), triangle_bin()), "x.glb");
  EXPECT_EQ(mesh.triangle_count(), 1U);
  EXPECT_EQ(mesh.solid, 0U) << "double-sided: a leaf";
  EXPECT_EQ(mesh.positions[3], 12.0F);
  EXPECT_EQ(mesh.positions[8], 2.0F);
  EXPECT_EQ(mesh.colours[0], (Colour{255, 0, 0}));
  EXPECT_NEAR(mesh.normals[1], -1.0, 1e-6);
}

TEST(ThingFile, SaysWhatIsWrong) {
  EXPECT_EQ(refusal(bytes_of("v 0 0\n"), "x.obj"), "x.obj: line 1: '' is no number");
  EXPECT_EQ(refusal(bytes_of("v 0 0 zero\n"), "x.obj"), "x.obj: line 1: 'zero' is no number");
  EXPECT_EQ(refusal(bytes_of("v 0 0 0\nf 1 2 3\n"), "x.obj"), "x.obj: line 2: index 2 of 1");
  EXPECT_EQ(refusal(bytes_of("v 0 0 0\nf 1 1\n"), "x.obj"), "x.obj: line 2: a face of fewer than three corners");
  EXPECT_EQ(refusal(bytes_of("v 0 0 0\nf 1 1 1\n"), "x.obj"), "x.obj: has no triangles");
  EXPECT_THAT(refusal(bytes_of("v 0 0 inf\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "x.obj"), HasSubstr("no number"));
  EXPECT_EQ(refusal({}, "x.glb"), "x.glb: is no GLB file, or it is cut off");
  EXPECT_EQ(refusal({}, "x.fbx"), "x.fbx: is no .glb or .obj file");
  EXPECT_THROW(read_thing(std::string("/no/such/thing.glb")), IoError);
}

TEST(ThingFile, RefusesNumbersThatLeadNowhere) {
  const auto broken = [&](const std::function<void(Json&)>& change) {
    Json json = triangle_json();
    change(json);
    return refusal(glb(json, triangle_bin()), "x.glb");
  };
  EXPECT_THAT(broken([](Json& j) { j["accessors"][0]["count"] = 4; }), HasSubstr("data beyond its end"));
  EXPECT_THAT(broken([](Json& j) { j["accessors"][0]["count"] = 1e18; }), HasSubstr("x.glb"));
  for (const double none : {-1.0, -3e9, 0.5, 1e18, 1e30}) {
    EXPECT_THAT(broken([&](Json& j) { j["scene"] = none; }), HasSubstr("damaged description")) << none;
    EXPECT_THAT(broken([&](Json& j) { j["nodes"][0]["mesh"] = none; }), HasSubstr("damaged description")) << none;
    EXPECT_THAT(broken([&](Json& j) { j["accessors"][0]["componentType"] = none; }), HasSubstr("x.glb")) << none;
    EXPECT_THAT(broken([&](Json& j) { j["bufferViews"][1]["byteStride"] = none; }), HasSubstr("x.glb")) << none;
  }
  EXPECT_EQ(broken([](Json& j) { j["accessors"][0]["count"] = 3.0; }), "");
  EXPECT_THAT(broken([](Json& j) { j["bufferViews"][0]["byteOffset"] = 18446744073709551000ULL; }), HasSubstr("x.glb"));
  EXPECT_THAT(broken([](Json& j) { j["bufferViews"][1]["byteOffset"] = 0; }), HasSubstr(""));
  EXPECT_THAT(broken([](Json& j) { j["accessors"][1]["bufferView"] = 9; }), HasSubstr("damaged description"));
  EXPECT_THAT(broken([](Json& j) {
                j["nodes"][0] = {{"mesh", 0}, {"children", {0}}};
              }),
              HasSubstr("nodes have no end"));
  EXPECT_THAT(broken([](Json& j) { j["extensionsRequired"] = {"KHR_draco_mesh_compression"}; }),
              HasSubstr("needs KHR_draco"));
  EXPECT_THAT(broken([](Json& j) { j["accessors"][0]["sparse"] = Json::object(); }), HasSubstr("sparse"));
  std::vector<uint8_t> bin = triangle_bin();
  bin[38] = 3;
  EXPECT_THAT(refusal(glb(triangle_json(), bin), "x.glb"), HasSubstr("an index that leads nowhere"));
}

TEST(ThingFile, RefusesFilesThatAreCutOffAnywhere) {
  const auto whole = glb(triangle_json(), triangle_bin());
  for (size_t length = 0; length < whole.size(); ++length)
    EXPECT_NE(refusal({whole.begin(), whole.begin() + static_cast<ptrdiff_t>(length)}, "x.glb"), "") << length;
  const auto text = bytes_of(kTetrahedron);
  for (size_t length = 0; length < text.size(); ++length)
    refusal({text.begin(), text.begin() + static_cast<ptrdiff_t>(length)}, "x.obj");  // ends, whatever comes out
}

TEST(ThingFile, ReadsWhatIsWrittenHere) {
  Mesh mesh;
  MeshPart part;
  part.positions = {0, 0, 0, 4, 0, 0, 0, 3, 1};
  part.normals = {0, 0, 1, 0, 0, 1, 0, 0, 1};
  part.indices = {0, 1, 2};
  mesh.parts = {part};
  for (const std::string extension : {".glb", ".obj"}) {
    const std::string path = ::testing::TempDir() + "seamount_thing" + extension;
    write_mesh(mesh, path);
    const ThingMesh thing = read_thing(path);
    EXPECT_EQ(thing.positions, part.positions) << extension;
    std::filesystem::remove(path);
  }
}

}  // namespace
}  // namespace seamount::io
