// What people do to the objects of a scene between two iterations (P3 sec. 1.7.1).
#pragma once

#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/scene.h"
#include "seamount/model/scene_edits.h"

namespace seamount::ecosystem {

/// Does the edits that are due after the iterations that the scene, or the window, has done, in their order, to the
/// objects of that frame. Returns whether there were
/// any. Throws InvalidArgument with "edits[i]..." for a class, an object or a skeleton that is not there or would not
/// be one; the scene is as before then.
bool apply_edits(const std::vector<SceneEdit>& edits, Scene& scene, int window, const RunContext& run);

}  // namespace seamount::ecosystem
