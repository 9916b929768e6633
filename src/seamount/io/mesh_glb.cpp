// glTF 2.0 binary (Khronos specification, sec. 4): a header, a JSON chunk and a chunk of buffers.
#include "seamount/base/error.h"
#include "seamount/io/glb_builder.h"
#include "seamount/io/image_file.h"
#include "seamount/io/mesh_formats.h"

namespace seamount::io {
namespace {

using Json = OrderedJson;

Json ground_material(bool textured) {
  Json material{{"name", "terrain"}, {"pbrMetallicRoughness", {{"metallicFactor", 0.0}, {"roughnessFactor", 0.95}}}};
  Json& surface = material["pbrMetallicRoughness"];
  if (textured) surface["baseColorTexture"] = {{"index", 0}};
  if (!textured) surface["baseColorFactor"] = {0.55, 0.52, 0.45, 1.0};
  return material;
}

Json water_material() {
  return {{"name", "water"},
          {"alphaMode", "BLEND"},
          {"doubleSided", true},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {0.03, 0.18, 0.25, 0.6}}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.1}}}};
}

Json extras(const Mesh& mesh, const Provenance& provenance) {
  Json json{{"units", "metres, sea level at y = 0"}, {"origin_x_m", mesh.origin.x}, {"origin_y_m", mesh.origin.y}};
  if (!mesh.crs.empty()) json["crs"] = mesh.crs;
  json["largest_error_m"] = mesh.largest_error_m;
  json["rms_error_m"] = mesh.rms_error_m;
  if (mesh.vertical_scale != 1.0) json["vertical_scale"] = mesh.vertical_scale;
  if (!provenance.recipe.empty()) json["recipe"] = provenance.recipe;
  if (provenance.seed) json["seed"] = *provenance.seed;
  return json;
}

}  // namespace

void begin_glb(GlbBuilder& glb, const Provenance& provenance) {
  glb.json["asset"] = {{"version", "2.0"}, {"generator", provenance.program.empty() ? "Seamount" : provenance.program}};
  glb.json["scene"] = 0;
  glb.json["scenes"] = {{{"nodes", Json::array()}}};
}

void add_terrain(GlbBuilder& glb, const Mesh& mesh, const MeshFileOptions& options) {
  Json node{{"name", "terrain"}, {"mesh", 0}, {"extras", extras(mesh, options.provenance)}};
  if (!(mesh.offset == Vec2{})) node["translation"] = {mesh.offset.x, 0.0, 0.0 - mesh.offset.y};
  Json primitives = Json::array();
  for (const MeshPart& part : mesh.parts) {
    Json attributes{{"POSITION", glb.places(y_up(part.positions), GlbBuilder::kVertices)},
                    {"NORMAL", glb.floats(y_up(part.normals), 3, GlbBuilder::kVertices)}};
    if (!part.uvs.empty()) attributes["TEXCOORD_0"] = glb.floats(part.uvs, 2, GlbBuilder::kVertices);
    const int indices = glb.indices(part.indices);
    const bool textured = options.texture != nullptr && !part.uvs.empty();
    const int material =
        glb.add_material(part.material == MeshMaterial::water ? water_material() : ground_material(textured));
    primitives.push_back({{"attributes", std::move(attributes)}, {"indices", indices}, {"material", material}});
  }
  if (options.texture != nullptr) {
    glb.json["images"] = {{{"mimeType", "image/png"}, {"bufferView", glb.bytes(encode_png(*options.texture))}}};
    glb.json["samplers"] = {{{"magFilter", 9729}, {"minFilter", 9987}, {"wrapS", 33071}, {"wrapT", 33071}}};
    glb.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
  }
  node["mesh"] = glb.add_mesh({{"name", "terrain"}, {"primitives", primitives}});
  glb.add_node(std::move(node));
}

void write_glb(const Mesh& mesh, const std::string& path, const MeshFileOptions& options) {
  GlbBuilder glb;
  begin_glb(glb, options.provenance);
  add_terrain(glb, mesh, options);
  glb.write(path, "the mesh is too large for a GLB file (4 GiB); set max_triangles");
}

}  // namespace seamount::io
