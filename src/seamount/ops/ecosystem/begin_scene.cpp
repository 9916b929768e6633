#include "seamount/ops/ecosystem/begin_scene.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/geom/polygon/polygon.h"

namespace seamount::ecosystem {
namespace {

constexpr int64_t kMostCells = int64_t{1} << 26;

/// Objects under the classes of a catalogue that have their names.
void rename_classes(Scene& scene, const Catalogue& catalogue, const RunContext& run) {
  std::vector<int> now(scene.catalogue.classes.size(), -1);
  for (size_t i = 0; i < now.size(); ++i) {
    for (size_t k = 0; k < catalogue.classes.size(); ++k) {
      const bool same = catalogue.classes[k].name == scene.catalogue.classes[i].name;
      if (same && catalogue.classes[k].skeleton == scene.catalogue.classes[i].skeleton) now[i] = static_cast<int>(k);
    }
  }
  const auto is_gone = [&](const auto& item) { return now[static_cast<size_t>(item.of_class)] < 0; };
  const size_t before = scene.objects.size();
  std::erase_if(scene.objects, is_gone);
  std::erase_if(scene.owed, is_gone);
  if (scene.objects.size() < before) {
    run.say(std::to_string(before - scene.objects.size()) +
            " objects of classes that the catalogue does not have, or has with another skeleton, were dropped");
  }
  for (SceneObject& object : scene.objects) object.of_class = now[static_cast<size_t>(object.of_class)];
  for (Owed& owed : scene.owed) owed.of_class = now[static_cast<size_t>(owed.of_class)];
  scene.catalogue = catalogue;
}

void say_what_lies_outside(const Scene& scene, const RunContext& run) {
  const GridFrame& frame = scene.frame;
  const auto lies_outside = [&](Vec2 p) {
    return p.x < frame.west_m || p.x > frame.east_m() || p.y < frame.south_m() || p.y > frame.north_m;
  };
  size_t count = 0;
  std::string first;
  for (const SceneObject& object : scene.objects) {
    const Polyline& points = object.skeleton.points;
    const auto found = std::find_if(points.begin(), points.end(), lies_outside);
    if (object.window != 0 || found == points.end()) continue;
    if (count++ == 0) first = "object " + std::to_string(object.id) + " at " + geom::format_place(*found);
  }
  if (count > 0)
    run.say(
        std::to_string(count) + " of " + std::to_string(scene.objects.size()) +
        " objects reach beyond the ground, where their fitness has no value: they die unless they are kept, such as " +
        first);
}

}  // namespace

Scene begin_scene(const GrowInputs& inputs, const GrowParams& params, Seed seed, const RunContext& run) {
  Scene scene;
  if (inputs.before != nullptr) {
    scene = *inputs.before;
    if (inputs.catalogue != nullptr) rename_classes(scene, *inputs.catalogue, run);
    for (const ObjectClass& of : scene.catalogue.classes) {
      if (of.fitness.empty())
        throw InvalidArgument("catalogue",
                              "is missing: the objects come without rules for the class '" + of.name + "'");
    }
    if (scene.frame.width == 0) scene.frame = inputs.ground.frame();
    say_what_lies_outside(scene, run);
  } else {
    if (inputs.catalogue == nullptr) throw InvalidArgument("catalogue", "is missing: nothing can grow without one");
    scene.catalogue = *inputs.catalogue;
    scene.surroundings = params.surroundings;
    scene.frame = inputs.ground.frame();
    scene.seed = seed.value;
  }
  if (scene.catalogue.classes.empty()) throw InvalidArgument("catalogue", "has no classes: nothing can grow");
  scene.timeline.insert(scene.timeline.end(), params.timeline.begin(), params.timeline.end());
  return scene;
}

int open_window(const WindowParams& window, Scene& scene) {
  if (window.cell_m == 0.0) return 0;
  const double cells_x = std::round(window.width_m / window.cell_m);
  const double cells_y = std::round(window.height_m / window.cell_m);
  if (!(cells_x >= 1 && cells_y >= 1 && cells_x * cells_y <= static_cast<double>(kMostCells)))
    throw InvalidArgument("window.cell_m", "the window would have " + format_number(cells_x) + " x " +
                                               format_number(cells_y) + " cells; 1 to 67108864 are possible");
  if (window.cell_m >= scene.frame.cell_m)
    throw InvalidArgument("window.cell_m", format_number(window.cell_m) + " m is not finer than the scene's cells, " +
                                               format_number(scene.frame.cell_m) + " m");
  GridFrame frame{static_cast<int>(cells_x),
                  static_cast<int>(cells_y),
                  window.cell_m,
                  window.centre.x - 0.5 * cells_x * window.cell_m,
                  window.centre.y + 0.5 * cells_y * window.cell_m,
                  scene.frame.crs};
  const GridFrame& whole = scene.frame;
  const double slack = 1e-6 * whole.cell_m;
  if (frame.west_m < whole.west_m - slack || frame.east_m() > whole.east_m() + slack ||
      frame.south_m() < whole.south_m() - slack || frame.north_m > whole.north_m + slack) {
    throw InvalidArgument("window.centre", "the window " + format_number(frame.west_m) + " ... " +
                                               format_number(frame.east_m()) + ", " + format_number(frame.south_m()) +
                                               " ... " + format_number(frame.north_m) + " leaves the scene " +
                                               format_number(whole.west_m) + " ... " + format_number(whole.east_m()) +
                                               ", " + format_number(whole.south_m()) + " ... " +
                                               format_number(whole.north_m));
  }
  const auto same = std::find_if(scene.windows.begin(), scene.windows.end(),
                                 [&](const SceneWindow& other) { return other.frame == frame; });
  if (same != scene.windows.end()) return static_cast<int>(same - scene.windows.begin()) + 1;
  scene.windows.push_back({frame});
  return static_cast<int>(scene.windows.size());
}

}  // namespace seamount::ecosystem
