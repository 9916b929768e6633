#include "seamount/recipe/scene_file.h"

#include <algorithm>
#include <set>

#include "seamount/io/atomic_file.h"
#include "seamount/io/input_file.h"
#include "seamount/io/object_file.h"
#include "seamount/io/projection.h"
#include "seamount/recipe/json_text.h"
#include "seamount/recipe/scene_json.h"

namespace seamount::recipe {
namespace {

io::ObjectFile to_features(const Scene& scene) {
  io::ObjectFile file;
  file.crs = scene.frame.crs;
  file.head = scene_head_json(scene).dump();
  for (const SceneObject& object : scene.objects) {
    file.objects.push_back({.of_class = scene.catalogue.classes[static_cast<size_t>(object.of_class)].name,
                            .id = object.id,
                            .skeleton = object.skeleton,
                            .size = object.size,
                            .fitness = object.fitness,
                            .born = object.born,
                            .age = iterations_in(scene, object.window) - object.born,
                            .window = object.window,
                            .keep = object.keep});
  }
  return file;
}

/// The scene around the features; where there is none, one with their classes.
Scene scene_around(const io::ObjectFile& file, const std::string& path) {
  if (!file.head.empty()) return parse_scene(file.head, path);
  Scene scene;
  scene.frame.width = scene.frame.height = 0;
  scene.frame.crs = file.crs;
  for (const io::ObjectFeature& object : file.objects) {
    const auto known = [&](const ObjectClass& of) { return of.name == object.of_class; };
    if (std::any_of(scene.catalogue.classes.begin(), scene.catalogue.classes.end(), known)) continue;
    ObjectClass of;
    of.name = object.of_class;
    of.skeleton = object.skeleton.kind;
    scene.catalogue.classes.push_back(std::move(of));
  }
  return scene;
}

int class_of(const io::ObjectFeature& object, const Catalogue& catalogue, const std::string& path) {
  std::vector<std::string> names;
  for (size_t c = 0; c < catalogue.classes.size(); ++c) {
    const ObjectClass& of = catalogue.classes[c];
    names.push_back(of.name);
    if (of.name != object.of_class) continue;
    if (of.skeleton == object.skeleton.kind) return static_cast<int>(c);
    throw IoError(path, "object " + std::to_string(object.id) + " of the class '" + of.name + "' is no " +
                            std::string(Choices<SkeletonKind>::names[static_cast<size_t>(of.skeleton)]));
  }
  throw IoError(path, "unknown class '" + object.of_class + "'" + suggestion(object.of_class, names));
}

/// Places of features that a GIS has brought to another system, back in that of their scene.
void bring_home(io::ObjectFile& file, const std::string& crs, const std::string& path, const RunContext& run) {
  if (file.crs.empty() || crs.empty() || file.crs == crs) return;
  std::vector<Vec2> places;
  for (const io::ObjectFeature& object : file.objects)
    places.insert(places.end(), object.skeleton.points.begin(), object.skeleton.points.end());
  places = io::from_lonlat(io::to_lonlat(places, file.crs), crs);
  auto next = places.begin();
  for (io::ObjectFeature& object : file.objects)
    for (Vec2& p : object.skeleton.points) p = *next++;
  run.say(path + ": its features were brought from " + io::crs_name(file.crs) + " to " + io::crs_name(crs) +
          ", the system of their scene");
}

Scene from_features(io::ObjectFile file, const std::string& path, const RunContext& run) {
  Scene scene = scene_around(file, path);
  bring_home(file, scene.frame.crs, path, run);
  std::set<uint64_t> seen;
  for (const io::ObjectFeature& object : file.objects) {
    const size_t least = object.skeleton.kind == SkeletonKind::point   ? 1
                         : object.skeleton.kind == SkeletonKind::curve ? 2
                                                                       : 3;
    if (object.skeleton.points.size() < least)
      throw IoError(path, "object " + std::to_string(object.id) + " has too few points");
    if (!(object.size > 0))
      throw IoError(path, "object " + std::to_string(object.id) + " has a size that is not above 0");
    if (object.window < 0 || object.window > static_cast<int>(scene.windows.size()))
      throw IoError(path, "object " + std::to_string(object.id) + " lies in a window that there is not");
    if (object.id != 0 && !seen.insert(object.id).second)
      throw IoError(path, "the number " + std::to_string(object.id) + " is given twice");
    scene.next_id = std::max(scene.next_id, object.id + 1);
    scene.objects.push_back({.id = object.id,
                             .of_class = class_of(object, scene.catalogue, path),
                             .skeleton = object.skeleton,
                             .size = object.size,
                             .fitness = object.fitness,
                             .born = object.born,
                             .window = object.window,
                             .keep = object.keep});
  }
  for (SceneObject& object : scene.objects)
    if (object.id == 0) object.id = scene.next_id++;
  std::sort(scene.objects.begin(), scene.objects.end(),
            [](const SceneObject& a, const SceneObject& b) { return a.id < b.id; });
  return scene;
}

}  // namespace

void write_scene(const Scene& scene, const std::string& path) {
  if (io::extension_of(path) != ".json") return io::write_objects(to_features(scene), path);
  io::write_text(path, readable_text(OrderedJson::parse(scene_json(scene).dump())));
}

bool is_scene_file(const std::string& path) {
  const std::string extension = io::extension_of(path);
  if (extension == ".json") return is_scene_text(io::read_text(path, kLargestText + 1, {}));
  return (extension == ".geojson" || extension == ".gpkg") && io::has_scene(path);
}

Scene read_scene(const std::string& path, const RunContext& run) {
  if (io::extension_of(path) != ".json") return from_features(io::read_objects(path, run), path, run);
  return parse_scene(io::read_text(path, kLargestText + 1, run), path, run);
}

}  // namespace seamount::recipe
