// Parameters of ecosystem.grow.
#pragma once

#include <string>
#include <tuple>
#include <vector>

#include "seamount/model/scene.h"
#include "seamount/model/scene_edits.h"

namespace seamount::ecosystem {

/// How many objects of a class are wanted.
struct Target {
  std::string class_name;
  int count = 1;

  static constexpr auto fields() {
    return std::tuple(field(&Target::class_name, "class", "of the catalogue"),
                      field(&Target::count, "count", "", between(0, 1e7), "so many are to live, and no more"));
  }
};

/// A finer frame within the scene.
struct WindowParams {
  double cell_m = 0.0;
  Vec2 centre;
  double width_m = 100.0;
  double height_m = 100.0;

  static constexpr auto fields() {
    return std::tuple(field(&WindowParams::cell_m, "cell_m", "m", between(0, 1e5),
                            "cell size of the window; 0: the whole scene grows"),
                      field(&WindowParams::centre, "centre", "its middle"),
                      field(&WindowParams::width_m, "width_m", "m", between(1e-3, 1e7), "west to east"),
                      field(&WindowParams::height_m, "height_m", "m", between(1e-3, 1e7), "south to north"));
  }
};

struct GrowParams {
  int iterations = 30;
  Surroundings surroundings;
  Timeline timeline;
  FilePath timeline_file;
  std::vector<SceneEdit> edits;
  FilePath edits_file;
  std::vector<Target> targets;
  std::vector<std::string> classes;
  WindowParams window;

  static constexpr auto fields() {
    return std::tuple(
        field(&GrowParams::iterations, "iterations", "", between(0, 100000),
              "so many more; fewer once every target is reached"),
        field(&GrowParams::surroundings, "surroundings", "the water; objects that are given keep their own"),
        field(&GrowParams::timeline, "timeline", "events, beside those of objects that are given"),
        field(&GrowParams::timeline_file, "timeline_file", "a JSON file with more of them"),
        field(&GrowParams::edits, "edits", "what is done to objects by hand"),
        field(&GrowParams::edits_file, "edits_file", "a JSON file with more of them"),
        field(&GrowParams::targets, "targets", "how many of a class are wanted; growth ends once all are there"),
        field(&GrowParams::classes, "classes", "only these are born; empty: all of the catalogue"),
        field(&GrowParams::window, "window", "a finer frame to grow in"));
  }
};

}  // namespace seamount::ecosystem
