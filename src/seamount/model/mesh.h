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
  size_t vertex_count() const { return positions.size() / 3; }
  size_t triangle_count() const { return indices.size() / 3; }
  bool operator==(const MeshPart&) const = default;
};

struct Mesh {
  std::vector<MeshPart> parts;
  Vec2 origin;                  ///< where x = y = 0 of the positions lies in the world, metres
  std::string crs = {};         ///< of the origin, as GridFrame::crs
  double vertical_scale = 1.0;  ///< z is so many times the height above sea level
  bool operator==(const Mesh&) const = default;
};

}  // namespace seamount
