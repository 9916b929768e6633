// The small languages inside SVG's attributes: paths, lists of points, transforms. Not part of the public interface.
#pragma once

#include <string_view>
#include <vector>

#include "seamount/model/drawn.h"

namespace seamount::io {

/// One subpath in user units, y as in the file.
struct SvgChain {
  Polyline points;  ///< the first point is not repeated at the end of a closed one
  bool closed = false;
};

/// The subpaths of a `d` attribute; curves in 16 edges each. Throws InvalidArgument{"d"}: an unknown command (arcs are
/// not read), a missing number.
std::vector<SvgChain> parse_svg_path(std::string_view d);

/// "x,y x,y ...". Throws InvalidArgument{"points"}.
Polyline parse_svg_points(std::string_view points);

/// (x, y) -> (a x + c y + e, b x + d y + f).
struct SvgMatrix {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
  Vec2 operator()(Vec2 p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  /// First `inner`, then this.
  SvgMatrix after(const SvgMatrix& inner) const;
};

/// translate, scale, rotate, skewX, skewY, matrix, in any row. Throws InvalidArgument{"transform"}.
SvgMatrix parse_svg_transform(std::string_view text);

}  // namespace seamount::io
