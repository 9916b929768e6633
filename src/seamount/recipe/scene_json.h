// Scenes of environmental objects as JSON: everything that decides how they go on, to the last bit.
#pragma once

#include <string>

#include "seamount/model/scene.h"
#include "seamount/recipe/param_json.h"

namespace seamount::recipe {

/// {"seamount_scene": 1, "catalogue", "surroundings", "timeline", "frame", "windows", "seed", "iteration", "next_id",
/// "owed"}: all but the objects.
Json scene_head_json(const Scene& scene);

/// The same with "objects": [{"id", "class", "points", ...}].
Json scene_json(const Scene& scene);

/// What scene_head_json() or scene_json() wrote; a scene without "objects" has none. Everything that is wrong goes to
/// `place`: unknown members, values out of range, a catalogue that is none, objects of no class, places that are not
/// finite, numbers given twice.
Scene read_scene_json(const Json& json, const ReadPlace& place);

/// Is this JSON that says that it is a scene, sound or not?
bool is_scene_text(const std::string& text);

/// Throws RecipeError with every defect and its line, Cancelled.
Scene parse_scene(const std::string& text, const std::string& file, const RunContext& run = {});

}  // namespace seamount::recipe
