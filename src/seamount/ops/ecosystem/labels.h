// The label map of a scene (P3 fig. 1.45): what island.coral and learned islands read.
#pragma once

#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/model/label_map.h"
#include "seamount/model/scene.h"

namespace seamount::ecosystem {

struct LabelsParams {
  int window = 0;

  static constexpr auto fields() {
    return std::tuple(field(&LabelsParams::window, "window", "", at_least(0),
                            "of the scene: 0 its own frame, else a window, counted from 1"));
  }
};

/// The regions that classes give their objects, each as broad as its class says; where several lie, mountain before
/// beach before reef before lagoon (P0 sec. 1.5.1); abyss where there is none. On the scene's frame or that of a
/// window. Throws InvalidArgument for a window that is not there. Linear in the cells that objects cover.
LabelMap labels(const Scene& scene, const LabelsParams& params, const RunContext& run);

}  // namespace seamount::ecosystem
