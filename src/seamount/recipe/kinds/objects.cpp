// objects: a scene of environmental objects with all that decides how it goes on.
#include "seamount/recipe/format.h"
#include "seamount/recipe/kinds.h"
#include "seamount/recipe/scene_file.h"
#include "seamount/recipe/scene_json.h"

namespace seamount::recipe {
namespace {

size_t size_of(const Scene& scene) {
  size_t size = sizeof scene;
  for (const SceneObject& object : scene.objects) size += sizeof object + object.skeleton.points.size() * sizeof(Vec2);
  return size;
}

Scene from_bytes(Reader& reader) {
  try {
    return parse_scene(reader.text(), "cached objects");
  } catch (const RecipeError&) {
    throw Damaged();
  }
}

}  // namespace

const Kind& kinds::Objects::kind() {
  static const Kind kind = make_kind<Scene>({
      .name = "objects",
      .about = "environmental objects: points, curves and regions with their classes",
      .files = {".gpkg"},
      .reads = {".json", ".gpkg", ".geojson"},
      .frame = {},
      .extent = [](const Scene& scene) { return std::optional(Extent::of(scene.frame)); },
      .bytes = size_of,
      .write = [](Writer& writer, const Scene& scene) { writer.text(scene_json(scene).dump()); },
      .read = from_bytes,
      .read_file = [](const FileCall& call) { return read_scene(call.path, call.run); },
      .info = {},
  });
  return kind;
}

void kinds::Objects::add_formats(Registry& registry) {
  const std::vector<std::string> files = {".gpkg", ".geojson", ".json"};
  registry.add(make_format<NoParams>(
      {"objects", "objects with their scene, to go on with: GeoPackage, GeoJSON, JSON", files, files, {&kind()}},
      [](const NoParams&, const OutputCall& call) { write_scene(call.value.get<Objects>(), call.path); }));
}

}  // namespace seamount::recipe
