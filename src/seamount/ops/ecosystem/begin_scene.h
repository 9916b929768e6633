// The scene that growth begins with.
#pragma once

#include "seamount/ops/ecosystem/grow.h"

namespace seamount::ecosystem {

/// A new scene of a catalogue on the ground, or the one that is given, with the timeline added to and, where a
/// catalogue is given as well, its objects under the classes of the same names (those of others are dropped, said).
/// Throws InvalidArgument, IncompatibleInputs.
Scene begin_scene(const GrowInputs& inputs, const GrowParams& params, Seed seed, const RunContext& run);

/// The number of the window that is asked for: 0 for none, that of the scene which is the same, else a new one.
/// Throws InvalidArgument for a window that leaves the scene or has too many cells.
int open_window(const WindowParams& window, Scene& scene);

}  // namespace seamount::ecosystem
