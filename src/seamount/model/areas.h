// Named areas and lines in the plane: what GIS files hold and what outlines are traced to.
#pragma once

#include <string>
#include <vector>

#include "seamount/model/drawn.h"

namespace seamount {

/// One feature: an area of one or more parts under a name ("kauai", "reef").
struct NamedArea {
  std::string name;
  std::vector<Polygon> parts;
  bool operator==(const NamedArea&) const = default;
};

/// One line feature with the number that it carries: a contour's height, say.
struct ValuedLine {
  Polyline points;
  double value = 0.0;
  bool closed = false;
  bool operator==(const ValuedLine&) const = default;
};

/// A drawing in one metric coordinate system; `crs` as in GridFrame.
struct Drawing {
  std::vector<NamedArea> areas;
  std::vector<ValuedLine> lines;
  std::string crs;
  bool operator==(const Drawing&) const = default;
};

}  // namespace seamount
