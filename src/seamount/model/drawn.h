// What people draw: places, curves of a function, strokes, outlines, polygons. Plain values in metres (x east, y
// north).
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace seamount {

struct Vec2 {
  double x = 0.0;
  double y = 0.0;

  bool operator==(const Vec2&) const = default;
  friend Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  friend Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
  friend double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
  friend double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
};

/// An open chain of points. Metres.
using Polyline = std::vector<Vec2>;

/// A closed ring: the last point is joined to the first and not repeated. Metres.
using Ring = std::vector<Vec2>;

/// An area: one outer ring and any number of holes.
struct Polygon {
  Ring outer;
  std::vector<Ring> holes;

  bool operator==(const Polygon&) const = default;
};

/// One knot of a Curve.
struct Knot {
  double x = 0.0;
  double y = 0.0;
  bool operator==(const Knot&) const = default;
};

/// A function of one variable through knots in ascending x; constant beyond the first and the last. How it runs between
/// knots is the reader's choice (geom/scalar/curve.h): monotone cubic unless said otherwise.
struct Curve {
  std::vector<Knot> knots;
  bool operator==(const Curve&) const = default;
};

/// The values that a field's range holds for (base/fields.h).
template <class Visitor>
void for_each_number(const Curve& curve, Visitor&& visit) {
  for (const Knot& knot : curve.knots) visit(knot.y);
}

/// A brush stroke along a Catmull-Rom spline through `points` (P0 sec. 1.4.1).
struct Stroke {
  Polyline points;          ///< control points, at least two
  double width_m = 500.0;   ///< standard deviation of the falloff across the stroke, > 0
  double strength_m = 0.0;  ///< displacement on the stroke itself; negative points against its direction
  bool operator==(const Stroke&) const = default;
};

/// A closed outline around a centre as radii at equal steps of the polar angle, counter-clockwise from east.
/// One radius is a circle.
struct PolarOutline {
  std::vector<double> radii_m;
  bool operator==(const PolarOutline&) const = default;
};

/// An area that contours grow in (P2 sec. 4.5), as its author draws it.
struct RegionOutline {
  std::string name;                ///< how messages call it; empty: its number
  Ring ring;                       ///< simple, in either direction; a repeated first point at the end is let go
  std::optional<double> height_m;  ///< of the outline; absent: what the distribution of heights gives
  bool basin = false;              ///< its inside lies lower than its outline
  std::optional<double> peak_m;    ///< of its summit, where no hill stands in it; of a basin's deepest place
  bool operator==(const RegionOutline&) const = default;
};

/// A river as its author draws it (P2 sec. 6.6), from its source to its mouth.
struct RiverLine {
  Polyline points;              ///< at least two
  std::vector<double> bed_m;    ///< bed elevation at every point, or at source and mouth; empty: follows from the land
  double source_width_m = 0.0;  ///< of the flat valley floor, at the source, >= 0
  double mouth_width_m = 0.0;   ///< and at the mouth, >= 0
  bool operator==(const RiverLine&) const = default;
};

/// A file named in parameters; relative names are relative to the recipe.
struct FilePath {
  std::string path;
  bool operator==(const FilePath&) const = default;
};

/// An RGB colour, 8 bits a channel, sRGB.
struct Colour {
  unsigned char r = 0, g = 0, b = 0;
  bool operator==(const Colour&) const = default;
};

}  // namespace seamount
