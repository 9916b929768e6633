// objects: a scene of environmental objects with all that decides how it goes on.
#include <string>

#include "seamount/base/text.h"
#include "seamount/io/projection.h"
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

std::string frame_text(const GridFrame& frame) {
  return std::to_string(frame.width) + " x " + std::to_string(frame.height) + " cells of " +
         format_number(frame.cell_m) + " m, x " + format_number(frame.west_m) + " to " + format_number(frame.east_m()) +
         ", y " + format_number(frame.south_m()) + " to " + format_number(frame.north_m);
}

/// Of a file that holds a scene; features without one are described as a drawing.
std::optional<io::FileInfo> describe(const std::string& path) {
  if (!is_scene_file(path)) return std::nullopt;
  const Scene scene = read_scene(path, {});
  std::vector<size_t> counts(scene.catalogue.classes.size(), 0);
  for (const SceneObject& object : scene.objects) ++counts[static_cast<size_t>(object.of_class)];
  std::string classes;
  for (size_t c = 0; c < counts.size(); ++c)
    classes += (c > 0 ? ", " : "") + scene.catalogue.classes[c].name + " " + std::to_string(counts[c]);
  io::FileInfo info = {{"format", "environmental objects"},
                       {"catalogue", scene.catalogue.name},
                       {"objects", std::to_string(scene.objects.size())},
                       {"classes", classes},
                       {"iteration", std::to_string(scene.iteration)},
                       {"events", std::to_string(scene.timeline.size())},
                       {"frame", frame_text(scene.frame)}};
  for (size_t w = 0; w < scene.windows.size(); ++w)
    info.emplace_back("window " + std::to_string(w + 1),
                      frame_text(scene.windows[w].frame) + ", iteration " + std::to_string(scene.windows[w].iteration));
  info.emplace_back("coordinate system",
                    scene.frame.crs.empty() ? "none (local metres)" : io::crs_name(scene.frame.crs));
  return info;
}

/// Of the ground that they grew on; of the places of objects that have none.
std::optional<Extent> extent_of(const Scene& scene) {
  if (scene.frame.width > 0) return Extent::of(scene.frame);
  std::optional<Extent> extent;
  for (const SceneObject& object : scene.objects) {
    for (const Vec2 p : object.skeleton.points) {
      const Extent place{scene.frame.crs, p.x, p.y, p.x, p.y};
      if (extent) extent->include(place);
      if (!extent) extent = place;
    }
  }
  return extent;
}

/// Objects without a ground go anywhere; a scene belongs to the cells that it grew on.
Scene brought(const Scene& scene, const Destination& to) {
  if (scene.frame.width > 0)
    throw IncompatibleInputs("the objects grew on a ground in " + io::crs_name(scene.frame.crs) +
                             ", the terrain is in " + io::crs_name(to.frame.crs) +
                             ": give the terrain that they grew on");
  Scene there = scene;
  there.frame.crs = to.frame.crs;
  std::vector<Vec2> places;
  for (const SceneObject& object : scene.objects)
    places.insert(places.end(), object.skeleton.points.begin(), object.skeleton.points.end());
  places = io::from_lonlat(io::to_lonlat(places, scene.frame.crs), to.frame.crs);
  auto next = places.begin();
  for (SceneObject& object : there.objects)
    for (Vec2& p : object.skeleton.points) p = *next++;
  return there;
}

}  // namespace

const Kind& kinds::Objects::kind() {
  static const Kind kind = make_kind<Scene>({
      .name = "objects",
      .about = "environmental objects: points, curves and regions with their classes",
      .files = {".gpkg"},
      .reads = {".json", ".gpkg", ".geojson"},
      .frame = {},
      .extent = extent_of,
      .bring = brought,
      .bytes = size_of,
      .write = [](Writer& writer, const Scene& scene) { writer.text(scene_json(scene).dump()); },
      .read = from_bytes,
      .read_file = [](const FileCall& call) { return read_scene(call.path, call.run); },
      .info = describe,
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
