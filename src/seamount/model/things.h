// What environmental objects look like in three dimensions: shapes, and the instances of them that stand on a terrain.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"

namespace seamount {

/// Indexed triangles with a colour at each vertex. Metres, x east, y north, z up; the foot is at (0, 0, 0). The first
/// `solid` indices are closed surfaces, counter-clockwise seen from outside. The rest are leaves: thin, seen from both
/// sides; their normals may lean towards the outside of the crown, so that it is shaded as a whole.
struct ThingMesh {
  std::vector<float> positions;  ///< 3 a vertex
  std::vector<float> normals;    ///< 3 a vertex, unit length
  std::vector<Colour> colours;   ///< 1 a vertex, sRGB: diffuse albedo, darkened where little light comes in
  std::vector<uint32_t> indices;
  size_t solid = 0;

  size_t vertex_count() const { return positions.size() / 3; }
  size_t triangle_count() const { return indices.size() / 3; }
  bool operator==(const ThingMesh&) const = default;
};

/// One model in levels of detail, the finest first: about 1500, 300 and 40 triangles where it is made here.
struct ThingShape {
  std::string name;               ///< "palm_2", and "palm_2_h40" where it ails; fit for a file name
  std::vector<ThingMesh> levels;  ///< at least one
  float height_m = 0.0F;          ///< of the finest level, over the foot
  float radius_m = 0.0F;          ///< of the finest level around the z axis
  float foot_m = 0.0F;            ///< radius of what touches the ground
  bool operator==(const ThingShape&) const = default;
};

/// One of many.
struct Thing {
  Vec2 place;        ///< of its foot, metres of Things::crs
  double z_m = 0.0;  ///< height of its foot above sea level
  std::array<float, 4> rotation = {0., 0., 0.,
                                   1.};  ///< unit quaternion x, y, z, w: from the shape's axes to the world's
  float scale = 1.0F;                    ///< > 0
  float health = 1.0F;                   ///< [0, 1]
  float tint = 1.0F;                     ///< brightness of its colours, about 1
  uint32_t shape = 0;                    ///< of Things::shapes
  uint32_t level = 0;                    ///< the finest level that it is drawn in
  bool operator==(const Thing&) const = default;
};

struct Things {
  std::vector<ThingShape> shapes;
  std::vector<Thing> things;
  std::string crs = {};  ///< as GridFrame's
  HeightField ground;    ///< what they stand on, as it is written with them; empty: not known

  /// Triangles of all things in their own levels.
  uint64_t triangle_count() const {
    uint64_t sum = 0;
    for (const Thing& thing : things) sum += shapes[thing.shape].levels[thing.level].triangle_count();
    return sum;
  }
  bool operator==(const Things&) const = default;
};

/// A direction or place of a shape, turned by a thing's rotation.
inline std::array<double, 3> turned(const std::array<float, 4>& q, const std::array<double, 3>& v) {
  const double x = q[0], y = q[1], z = q[2], w = q[3];
  const std::array<double, 3> t = {2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])};
  return {v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2],
          v[2] + w * t[2] + x * t[1] - y * t[0]};
}

}  // namespace seamount
