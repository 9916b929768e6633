// What a GLB file holds, found from its description. Not part of the public interface.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>

#include "seamount/io/info.h"

namespace seamount::io {

/// x east, y north, z up.
struct MeshSummary {
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  std::string format;
  size_t triangles = 0, vertices = 0, parts = 0;
  size_t instances = 0;  ///< of EXT_mesh_gpu_instancing; they count in the triangles
  std::array<double, 3> low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};
  FileInfo said;  ///< what else the file says

  void add_vertex(const std::array<double, 3>& place);
  void add_box(const std::array<double, 3>& box_low, const std::array<double, 3>& box_high);
};

/// Throws IoError{name}: not a GLB file of version 2, cut off, no scene, numbers that lead nowhere.
MeshSummary glb_summary(std::span<const uint8_t> bytes, const std::string& name);

}  // namespace seamount::io
