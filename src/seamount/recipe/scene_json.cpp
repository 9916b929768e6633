#include "seamount/recipe/scene_json.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "seamount/ops/ecosystem/rules.h"
#include "seamount/recipe/catalogue_json.h"

namespace seamount::recipe {
namespace {

const char* const kVersion = "seamount_scene";
constexpr int kMostCells = 65536;

Json frame_json(const GridFrame& frame) {
  return {{"width", frame.width},
          {"height", frame.height},
          {"cell_m", write_json(frame.cell_m)},
          {"west_m", write_json(frame.west_m)},
          {"north_m", write_json(frame.north_m)},
          {"crs", frame.crs}};
}

Json object_json(const SceneObject& object, const Catalogue& catalogue) {
  Json json = {{"id", object.id},
               {"class", catalogue.classes[static_cast<size_t>(object.of_class)].name},
               {"points", write_json(object.skeleton.points)},
               {"size", write_json(object.size)},
               {"born", object.born}};
  if (std::isfinite(object.fitness)) json["fitness"] = write_json(object.fitness);
  if (object.window != 0) json["window"] = object.window;
  if (object.keep) json["keep"] = true;
  if (!object.skeleton.hold.empty()) {
    Json hold = Json::array();
    for (const float h : object.skeleton.hold) hold.push_back(h);
    json["hold"] = std::move(hold);
  }
  return json;
}

/// Members of one object, each checked.
class Members {
 public:
  Members(const Json& json, ReadPlace place, const std::string& what) : json_(json), place_(std::move(place)) {
    if (!json.is_object()) place_.expected(what, json);
  }
  template <class T>
  bool read(const char* name, T& value, bool required = true) {
    names_.emplace_back(name);
    if (!json_.is_object()) return false;
    const auto found = json_.find(name);
    if (found == json_.end()) {
      if (required) place_.fail(std::string("\"") + name + "\" is missing");
      return false;
    }
    const size_t before = place_.diagnostics.items().size();
    read_json(*found, value, place_.at(name));
    return place_.diagnostics.items().size() == before;
  }
  /// A whole number up to 2^64 - 1.
  void read_count(const char* name, uint64_t& value) {
    names_.emplace_back(name);
    if (!json_.is_object()) return;
    const auto found = json_.find(name);
    if (found == json_.end()) return place_.fail(std::string("\"") + name + "\" is missing");
    if (!found->is_number_unsigned()) return place_.at(name).expected("a whole number from 0 on", *found);
    value = found->get<uint64_t>();
  }
  const Json* find(const char* name) {
    names_.emplace_back(name);
    if (!json_.is_object() || !json_.contains(name)) return nullptr;
    return &json_.at(name);
  }
  void refuse_others() const {
    if (json_.is_object()) refuse_unknown_keys(json_, names_, "member", place_);
  }

 private:
  const Json& json_;
  ReadPlace place_;
  std::vector<std::string> names_;
};

/// `iteration`: of a window; null for the scene's own frame, which has none.
void read_frame_json(const Json& json, GridFrame& frame, int* iteration, const ReadPlace& place) {
  Members members(json, place, "a frame");
  members.read("width", frame.width);
  members.read("height", frame.height);
  members.read("cell_m", frame.cell_m);
  members.read("west_m", frame.west_m);
  members.read("north_m", frame.north_m);
  members.read("crs", frame.crs, false);
  if (iteration != nullptr) members.read("iteration", *iteration);
  members.refuse_others();
  if (iteration != nullptr && *iteration < 0) place.at("iteration").fail("is below 0");
  const bool sound = frame.width >= 1 && frame.height >= 1 && frame.width <= kMostCells && frame.height <= kMostCells &&
                     frame.cell_m > 0 && frame.cell_m <= 1e6 && std::isfinite(frame.west_m) &&
                     std::isfinite(frame.north_m);
  if (!sound) place.fail("this is no frame: 1 to 65536 columns and rows, cells up to 1000 km");
}

/// A skeleton of this kind, or what is wrong with it.
std::string skeleton_defect(const Skeleton& skeleton) {
  const size_t count = skeleton.points.size();
  const bool finite = std::all_of(skeleton.points.begin(), skeleton.points.end(),
                                  [](Vec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); });
  if (!finite) return "a place is not finite";
  if (skeleton.kind == SkeletonKind::point && count != 1)
    return "a point has one place, found " + std::to_string(count);
  if (skeleton.kind == SkeletonKind::curve && count < 2) return "a curve has two places or more";
  if (skeleton.kind == SkeletonKind::region && count < 3) return "an outline has three places or more";
  if (!skeleton.hold.empty() && skeleton.hold.size() != count) return "\"hold\" is not as long as \"points\"";
  return "";
}

void read_object(const Json& json, Scene& scene, const ReadPlace& place) {
  SceneObject object;
  std::string of_class;
  std::vector<double> hold;
  Members members(json, place, "an object {\"id\", \"class\", \"points\", ...}");
  members.read_count("id", object.id);
  members.read("class", of_class);
  members.read("points", object.skeleton.points);
  members.read("size", object.size, false);
  members.read("born", object.born, false);
  members.read("fitness", object.fitness, false);
  members.read("window", object.window, false);
  members.read("keep", object.keep, false);
  members.read("hold", hold, false);
  members.refuse_others();
  const auto& classes = scene.catalogue.classes;
  const auto found =
      std::find_if(classes.begin(), classes.end(), [&](const ObjectClass& c) { return c.name == of_class; });
  if (found == classes.end()) return place.at("class").fail("'" + of_class + "' is no class of the catalogue");
  object.of_class = static_cast<int>(found - classes.begin());
  object.skeleton.kind = found->skeleton;
  object.skeleton.hold.assign(hold.begin(), hold.end());
  if (const std::string defect = skeleton_defect(object.skeleton); !defect.empty())
    return place.at("points").fail(defect);
  if (object.window < 0 || object.window > static_cast<int>(scene.windows.size()))
    return place.at("window").fail("there is no window " + std::to_string(object.window));
  if (!(object.size > 0) || !std::isfinite(object.size)) return place.at("size").fail("is not above 0");
  scene.objects.push_back(std::move(object));
}

void check_numbers(const Scene& scene, const ReadPlace& place) {
  std::set<uint64_t> seen;
  for (const SceneObject& object : scene.objects) {
    if (object.id == 0 || object.id >= scene.next_id || !seen.insert(object.id).second)
      return place.at("objects").fail("the number " + std::to_string(object.id) +
                                      " is given twice, 0, or not below next_id");
  }
}

void read_owed(const Json& list, Scene& scene, const ReadPlace& place) {
  if (!list.is_array()) return place.expected("a list", list);
  for (size_t i = 0; i < list.size(); ++i) {
    Owed owed;
    std::string of_class;
    Members members(list[i], place.at(i), "{\"class\", \"window\", \"count\"}");
    members.read("class", of_class);
    members.read("window", owed.window);
    members.read("count", owed.count);
    members.refuse_others();
    const auto& classes = scene.catalogue.classes;
    const auto found =
        std::find_if(classes.begin(), classes.end(), [&](const ObjectClass& c) { return c.name == of_class; });
    if (found == classes.end()) {
      place.at(i).fail("'" + of_class + "' is no class of the catalogue");
      continue;
    }
    owed.of_class = static_cast<int>(found - classes.begin());
    if (owed.window < 0 || owed.window > static_cast<int>(scene.windows.size()))
      place.at(i).at("window").fail("there is no window " + std::to_string(owed.window));
    if (owed.count < 0) place.at(i).at("count").fail("is below 0");
    scene.owed.push_back(owed);
  }
}

}  // namespace

Json scene_head_json(const Scene& scene) {
  Json windows = Json::array();
  for (const SceneWindow& window : scene.windows) {
    windows.push_back(frame_json(window.frame));
    windows.back()["iteration"] = window.iteration;
  }
  Json owed = Json::array();
  for (const Owed& o : scene.owed)
    owed.push_back({{"class", scene.catalogue.classes[static_cast<size_t>(o.of_class)].name},
                    {"window", o.window},
                    {"count", o.count}});
  return {{kVersion, 1},
          {"catalogue", write_params(scene.catalogue)},
          {"surroundings", write_params(scene.surroundings)},
          {"timeline", write_json(scene.timeline)},
          {"frame", frame_json(scene.frame)},
          {"windows", std::move(windows)},
          {"seed", scene.seed},
          {"iteration", scene.iteration},
          {"next_id", scene.next_id},
          {"owed", std::move(owed)}};
}

Json scene_json(const Scene& scene) {
  Json json = scene_head_json(scene);
  Json& objects = json["objects"] = Json::array();
  for (const SceneObject& object : scene.objects) objects.push_back(object_json(object, scene.catalogue));
  return json;
}

Scene read_scene_json(const Json& json, const ReadPlace& place) {
  Scene scene;
  if (!json.is_object() || !json.contains(kVersion)) {
    place.fail(std::string("these are no objects of a scene: \"") + kVersion + "\": 1 is missing");
    return scene;
  }
  int version = 0;
  Members members(json, place, "a scene");
  members.read(kVersion, version);
  if (version != 1) place.at(kVersion).fail("version " + std::to_string(version) + " is not known; 1 is");
  members.read("catalogue", scene.catalogue);
  if (place.diagnostics.empty()) {
    for (const ecosystem::CatalogueDefect& defect : ecosystem::find_defects(scene.catalogue))
      place.diagnostics.add(place.pointer + "/catalogue" + defect.pointer, defect.message);
  }
  members.read("surroundings", scene.surroundings);
  members.read("timeline", scene.timeline);
  if (const Json* frame = members.find("frame")) read_frame_json(*frame, scene.frame, nullptr, place.at("frame"));
  if (const Json* windows = members.find("windows")) {
    if (!windows->is_array()) place.at("windows").expected("a list", *windows);
    for (size_t i = 0; windows->is_array() && i < windows->size(); ++i) {
      SceneWindow& window = scene.windows.emplace_back();
      read_frame_json((*windows)[i], window.frame, &window.iteration, place.at("windows").at(i));
    }
  }
  members.read_count("seed", scene.seed);
  if (members.read("iteration", scene.iteration) && scene.iteration < 0) place.at("iteration").fail("is below 0");
  members.read_count("next_id", scene.next_id);
  if (const Json* owed = members.find("owed")) read_owed(*owed, scene, place.at("owed"));
  if (const Json* objects = members.find("objects")) {
    if (!objects->is_array()) place.at("objects").expected("a list", *objects);
    for (size_t i = 0; objects->is_array() && i < objects->size(); ++i)
      read_object((*objects)[i], scene, place.at("objects").at(i));
    check_numbers(scene, place);
  }
  members.refuse_others();
  return scene;
}

bool is_scene_text(const std::string& text) {
  if (text.find(kVersion) == std::string::npos) return false;
  const Json root = Json::parse(text, nullptr, false);
  return root.is_object() && root.contains(kVersion);
}

Scene parse_scene(const std::string& text, const std::string& file, const RunContext& run) {
  const JsonDocument document = parse_json(text, file, run);
  Diagnostics diagnostics;
  Scene scene = read_scene_json(document.root, {"", diagnostics});
  if (!diagnostics.empty()) {
    place_diagnostics(diagnostics, document);
    throw RecipeError(file, diagnostics.items());
  }
  return scene;
}

}  // namespace seamount::recipe
