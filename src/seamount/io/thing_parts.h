// Puts together a thing's mesh from the parts of a file. Not part of the public interface.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/things.h"

namespace seamount::io {

constexpr size_t kMostThingTriangles = 2'000'000;

/// Triangles as they come from a file: a corner's place, its normal (zero: not known) and its colour in linear light.
struct ThingCorner {
  std::array<float, 3> place{}, normal{}, colour{};
  bool operator==(const ThingCorner&) const = default;
};

class ThingParts {
 public:
  explicit ThingParts(std::string name) : name_(std::move(name)) {}
  /// Axes of the file, y up. Throws IoError{name} for too many triangles and corners that are not finite.
  void triangle(const std::array<ThingCorner, 3>& corners, bool two_sided);
  /// Throws IoError{name} if there are no triangles.
  ThingMesh mesh() const;

 private:
  struct Triangle {
    std::array<ThingCorner, 3> corners;
    bool two_sided;
  };
  std::string name_;
  std::vector<Triangle> triangles_;
};

/// Throws IoError{name}.
ThingMesh obj_thing(std::string_view text, const std::string& name, std::string_view materials, const RunContext& run);
ThingMesh glb_thing(std::span<const uint8_t> bytes, const std::string& name, const RunContext& run);
/// The first file of materials that an OBJ names; empty: none.
std::string obj_materials(std::string_view text);

}  // namespace seamount::io
