// Areas, lines and places in the plane with what is known about them: what GIS files hold and what outlines, rivers and
// summits are traced to.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"

namespace seamount {

/// One more number that a feature carries, by name with its unit: {"width_m", 12.5}.
struct Attribute {
  std::string name;
  double value = 0.0;
  bool operator==(const Attribute&) const = default;
};
using Attributes = std::vector<Attribute>;

/// One feature: an area of one or more parts under a name ("kauai", "reef").
struct NamedArea {
  std::string name;
  std::vector<Polygon> parts;
  Attributes attributes = {};
  bool operator==(const NamedArea&) const = default;
};

/// One line feature with the number that it carries: a contour's height, say.
struct ValuedLine {
  Polyline points;
  double value = 0.0;
  bool closed = false;
  Attributes attributes = {};
  bool operator==(const ValuedLine&) const = default;
};

/// One place with the number that it carries: a summit's height, say.
struct ValuedPoint {
  Vec2 place;
  double value = 0.0;
  Attributes attributes = {};
  bool operator==(const ValuedPoint&) const = default;
};

/// A drawing in one metric coordinate system; `crs` as in GridFrame. Where `heights` is set, values of lines and points
/// are heights in metres: files name them "height_m" and carry them as z too. `frame`: of the document that it was made
/// in, where that is known, in the drawing's system; files carry it.
struct Drawing {
  std::vector<NamedArea> areas;
  std::vector<ValuedLine> lines;
  std::string crs;
  std::vector<ValuedPoint> points = {};
  bool heights = false;
  std::optional<GridFrame> frame = std::nullopt;
  bool operator==(const Drawing&) const = default;
};

}  // namespace seamount
