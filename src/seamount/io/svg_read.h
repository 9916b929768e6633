// SVG files as drawings: what write_drawing() writes, also after an editor such as Inkscape had it, and plain paths of
// others. Not part of the public interface.
//
// Read are path (M L H V C S Q T Z), polygon, polyline, line, rect, circle and ellipse, with the transforms of groups;
// curves become chains of short edges. What is filled or has data-name is an area, whose subpaths nest by the even-odd
// rule; what is not is a line. y runs down in the file and up in the drawing. Text, uses, images, clips and what stands
// in defs are passed over.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "seamount/model/areas.h"

namespace seamount::io {

inline constexpr uint64_t kMostSvgBytes = uint64_t{1} << 28;

struct SvgDrawing {
  Drawing drawing;                           ///< in user units; `frame` where the file carries one
  std::string crs;                           ///< of data-seamount-crs
  bool ours = false;                         ///< it carries a mark of write_drawing()
  std::optional<std::string> without_value;  ///< the first line that has no number
};

/// Throws IoError{name}: not SVG, damaged, a path that cannot be read (with the element), elements nested deeper than
/// 200, more than 50 million points.
SvgDrawing parse_svg(std::span<const uint8_t> bytes, const std::string& name);

}  // namespace seamount::io
