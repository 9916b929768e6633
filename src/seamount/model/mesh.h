// Triangle meshes on their way to files, printers and engines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "seamount/model/drawn.h"

namespace seamount {

enum class MeshMaterial : uint8_t {
  ground,  ///< opaque, textured where a picture is given
  water,   ///< translucent: only formats that know materials hold it
};

/// Indexed triangles of one material, counter-clockwise seen from outside.
struct MeshPart {
  MeshMaterial material = MeshMaterial::ground;
  std::vector<float> positions;  ///< metres, x east, y north, z up; 3 a vertex
  std::vector<float> normals;    ///< 3 a vertex, unit length
  std::vector<float> uvs;        ///< 2 a vertex, (0, 0) is the north-west corner of the texture; empty: not textured
  std::vector<uint32_t> indices;
  bool hard_edges = false;  ///< vertices may lie in one place, each with a normal of its own
  size_t vertex_count() const { return positions.size() / 3; }
  size_t triangle_count() const { return indices.size() / 3; }
  bool operator==(const MeshPart&) const = default;
};

struct Mesh {
  std::vector<MeshPart> parts;
  Vec2 origin;                   ///< where x = y = 0 of the positions lies in the world, metres
  std::string crs = {};          ///< of the origin, as GridFrame::crs
  double vertical_scale = 1.0;   ///< z is so many times the height above sea level
  Vec2 offset = {};              ///< to add to the positions' x and y: tiles of one terrain fit then, without rounding
  double largest_error_m = 0.0;  ///< how far the ground is above or below a cell that it covers, before vertical_scale
  double rms_error_m = 0.0;      ///< the same, root of the mean square over the cells that it covers
  bool operator==(const Mesh&) const = default;
};

}  // namespace seamount
