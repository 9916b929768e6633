// Things in a Gazebo world. Not part of the public interface; gazebo.h has it.
#pragma once

#include <string>

#include "seamount/io/gazebo.h"

namespace seamount::io {

/// Writes the meshes of shapes in use into the world's folder (OBJ with z up, materials of their mean colours, which
/// Gazebo reads where it reads no colours at vertices), and gives the text of the models. Relative to the frame's
/// middle.
std::string write_gazebo_things(const Things& things, const GridFrame& frame, const std::string& path,
                                const GazeboOptions& options, const RunContext& run);

}  // namespace seamount::io
