// What the writers of drawings share. Not part of the public interface.
#pragma once

#include <string>
#include <vector>

#include "seamount/model/areas.h"

namespace seamount::io {

/// Calls visit(points) with every chain of points of a drawing: rings, then lines.
template <class AnyDrawing, class Visit>
void for_each_chain(AnyDrawing& drawing, const Visit& visit) {
  for (auto& area : drawing.areas) {
    for (auto& part : area.parts) {
      visit(part.outer);
      for (auto& hole : part.holes) visit(hole);
    }
  }
  for (auto& line : drawing.lines) visit(line.points);
}

/// Decimal without exponent, at most `digits` behind the point, no trailing zeros.
void append_decimal(std::string& text, double value, int digits);

/// A drawing as an SVG picture (write_drawing()).
std::string to_svg(const Drawing& drawing);

}  // namespace seamount::io
