// What an environmental object is reduced to on a map (P3 sec. 1.3.2): a point, a curve, or the outline of a region.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/model/drawn.h"

namespace seamount {

enum class SkeletonKind : unsigned char { point, curve, region };

template <>
struct Choices<SkeletonKind> {
  static constexpr std::array<std::string_view, 3> names = {"point", "curve", "region"};
};

/// One point, a chain of at least two, or a simple ring of at least three (counter-clockwise, the first not repeated).
/// Metres.
struct Skeleton {
  SkeletonKind kind = SkeletonKind::point;
  Polyline points;
  std::vector<float> hold = {};  ///< for each point 0 (free) to 1 (locked), hindered in between; empty: all free

  bool operator==(const Skeleton&) const = default;
};

}  // namespace seamount
