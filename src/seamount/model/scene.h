// A scene: objects that grow on a terrain, with all that decides how they go on. What they make of the ground, the
// water and the materials follows from it (ops/ecosystem/environment.h) and is not kept.
#pragma once

#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "seamount/model/catalogue.h"
#include "seamount/model/grid.h"
#include "seamount/model/scene_events.h"

namespace seamount {

/// The water around the objects, and how heights join (P3 eq. 1.46-1.53).
struct Surroundings {
  double water_level_m = 0.0;
  double current_m_s = 0.2;
  double towards_deg = 180.0;
  double venturi_1_m = 0.0;
  double broad_m = 200.0;
  double broad_weight = 0.8;
  double broad_deviation = 30.0;
  double fine_m = 50.0;
  double fine_weight = 0.2;
  double fine_deviation = 5.0;
  double shore_m = 2.0;
  double blend_m = 1.0;
  bool operator==(const Surroundings&) const = default;

  static constexpr auto fields() {
    return std::tuple(
        field(&Surroundings::water_level_m, "water_level_m", "m", between(-20000, 20000), "height of the water"),
        field(&Surroundings::current_m_s, "current_m_s", "m/s", between(0, 100), "speed of the undisturbed current"),
        field(&Surroundings::towards_deg, "towards_deg", "deg", between(-360, 360),
              "where it flows to: 0 east, 90 north"),
        field(&Surroundings::venturi_1_m, "venturi_1_m", "1/m", between(0, 10),
              "by how much a metre between ground and water level speeds it up (k_w of eq. 1.52)"),
        field(&Surroundings::broad_m, "broad_m", "m", between(0, 1e6),
              "deviation of the broad blur of the ground (eq. 1.53)"),
        field(&Surroundings::broad_weight, "broad_weight", "", between(0, 1), "its share"),
        field(&Surroundings::broad_deviation, "broad_deviation", "", between(0, 1e4),
              "how strongly it turns the current"),
        field(&Surroundings::fine_m, "fine_m", "m", between(0, 1e6), "deviation of the fine blur"),
        field(&Surroundings::fine_weight, "fine_weight", "", between(0, 1), "its share"),
        field(&Surroundings::fine_deviation, "fine_deviation", "", between(0, 1e4),
              "how strongly it turns the current"),
        field(&Surroundings::shore_m, "shore_m", "m", between(0, 1000),
              "depth below which water slows down towards the shore"),
        field(&Surroundings::blend_m, "blend_m", "m", between(0, 1000),
              "how far two equal heights rise where they join: 1/(2k) of the smooth maximum"));
  }
};

/// A finer frame within a scene, in which other classes grow. While it does the scene stands still: its iterations are
/// its own, so that what happens in a window changes nothing outside.
struct SceneWindow {
  GridFrame frame;
  int iteration = 0;  ///< how many are done in it
  bool operator==(const SceneWindow&) const = default;
};

/// One object of a scene.
struct SceneObject {
  uint64_t id = 0;   ///< from 1, never given twice
  int of_class = 0;  ///< index into the catalogue
  Skeleton skeleton;
  double size = 1.0;     ///< times the size, length or area of its class
  double fitness = 0.0;  ///< when it was last asked
  int born = 0;          ///< iteration of its frame
  int window = 0;        ///< where it grew: 0 the scene's own frame, else a window, counted from 1
  bool keep = false;     ///< it lives whatever its fitness: placed by hand

  bool operator==(const SceneObject&) const = default;
};

/// Deaths that are still to be made up for: so many of a class in a window.
struct Owed {
  int of_class = 0;
  int window = 0;
  int count = 0;
  bool operator==(const Owed&) const = default;
};

struct Scene {
  Catalogue catalogue;
  Surroundings surroundings;
  Timeline timeline;
  GridFrame frame;  ///< of the ground that it grew on
  std::vector<SceneWindow> windows = {};
  uint64_t seed = 0;
  int iteration = 0;  ///< how many are done in the scene's own frame, and what time it is for events
  uint64_t next_id = 1;
  std::vector<SceneObject> objects;  ///< by ascending id
  std::vector<Owed> owed = {};

  bool operator==(const Scene&) const = default;
};

/// Iterations done in a frame: 0 the scene's own, else a window. REQUIRES: it is there.
inline int iterations_in(const Scene& scene, int window) {
  return window == 0 ? scene.iteration : scene.windows[static_cast<size_t>(window - 1)].iteration;
}

}  // namespace seamount
