// Worlds for robot simulators: Gazebo (gz-sim) and, with a mesh, Gazebo classic with its underwater worlds.
//
// "reef.sdf" is a world (SDF 1.7: http://sdformat.org/spec) of the ground, the sun and the sea; the folder "reef"
// beside it holds the ground as a model for other worlds (model://reef). The world's x is east, y north, z the height
// above sea level in metres; its origin is the middle of the terrain at sea level, where the terrain's coordinate
// system is known with its latitude, longitude and the angle from true north to y.
//
// Height maps are PNG of (2^n + 1)^2 samples, the outer ones on the edge: 16 bits for gz-sim from Garden on, 8 for
// Fortress and Gazebo classic, which read no more. Rendering takes a height map's place from <pos>, physics from the
// collision's <pose>.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/io/provenance.h"
#include "seamount/model/grid.h"
#include "seamount/model/image.h"
#include "seamount/model/mesh.h"
#include "seamount/model/things.h"

namespace seamount::io {

struct GazeboOptions {
  const Image* texture = nullptr;  ///< of the ground from outer sample to outer sample, or of the mesh; row 0 north
  int bits = 16;                   ///< of a height map: 16 or 8
  bool water = true;               ///< a translucent sheet at sea level if any of the terrain is below it
  bool buoyancy = false;           ///< gz-sim's systems, with sea water below 0 m and air above
  const Things* things = nullptr;  ///< what stands on a mesh: static models; each shape in use is a mesh of the folder
  int max_collisions = 2000;       ///< so many of the largest things can be bumped into, as boxes; the others are seen
  Provenance provenance;
};

/// Sides of height maps that Gazebo reads, ascending.
const std::vector<int>& gazebo_sizes();

/// All files of a world with a height map or a mesh, the world first.
std::vector<std::string> gazebo_files(const std::string& path, bool mesh, bool texture, bool things = false);

/// A world whose ground is a height map: heights come back within half of their range / 65535, or 255. Says where the
/// origin is, and the step of 8 bits. Throws InvalidArgument{"size"} unless the grid is a square of a known size,
/// {"bits"}, {"heights"} for one that is not finite; IoError.
void write_gazebo(const HeightField& heights, const std::string& path, const GazeboOptions& options = {},
                  const RunContext& run = {});

/// A world whose ground is a mesh (OBJ): its first part, which lies in `frame` relative to the middle. Things are said
/// to be left out of collisions where there are more than max_collisions.
void write_gazebo(const Mesh& mesh, const GridFrame& frame, const std::string& path, const GazeboOptions& options = {},
                  const RunContext& run = {});

}  // namespace seamount::io
