// Polygons: measures, tests, defects, rasters, and simpler or smoother rings. Metres throughout. A ring is closed, its
// last point is not repeated (model/drawn.h).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// An axis-parallel rectangle; empty() if it holds no point.
struct Box {
  Vec2 low = {1.0, 1.0};
  Vec2 high = {-1.0, -1.0};
  bool empty() const { return low.x > high.x; }
};

/// Area of a ring, positive if it runs counter-clockwise (x east, y north). Square metres.
double signed_area(const Ring& ring);

/// Area of a polygon: the outer ring's less the holes', whatever way they run. Square metres.
double area(const Polygon& polygon);

/// Length of a ring, of all rings of a polygon, of an open line. Metres.
double ring_length(const Ring& ring);
double perimeter(const Polygon& polygon);
double line_length(const Polyline& line);

Box bounding_box(const Ring& ring);

/// Makes the outer ring run counter-clockwise and holes clockwise.
void orient(Polygon& polygon);

/// Is p inside, by the even-odd rule? Exact (predicates.h); on the border either answer. Linear time.
bool contains(const Ring& ring, Vec2 p);
/// Inside the outer ring and in no hole.
bool contains(const Polygon& polygon, Vec2 p);

/// What is wrong with a polygon, in one line for its author, with places: fewer than 3 points, a coordinate that is not
/// finite, no area, edges that cross, edges that touch within a ring or run along each other, a hole outside. Nothing
/// if it is sound: rings may touch each other in single places. A point repeated next to itself is no defect. About n
/// log n for n vertices.
std::optional<std::string> find_defect(const Polygon& polygon);

/// A place where two rings cross or touch, if there is one. REQUIRES: finite coordinates. About n log n.
std::optional<Vec2> find_crossing(const Ring& a, const Ring& b);

/// "(1200, -35.25)": a place for a message, to the millimetre.
std::string format_place(Vec2 p);

/// 1 where a cell's centre lies inside any of the polygons (each by the even-odd rule), else 0. Linear in cells covered
/// and edges.
Grid<uint8_t> rasterise(const std::vector<Polygon>& polygons, const GridFrame& frame);

/// The part of a ring inside a box (Sutherland and Hodgman 1974). Parts may be joined along the box's sides, which
/// leaves areas right. Empty where they do not meet.
Ring clip_to_box(const Ring& ring, const Box& box);

/// Douglas-Peucker: fewer points, none of the dropped ones further than tolerance_m from the result. Keeps at least
/// three points of a ring that has them.
Ring simplify(const Ring& ring, double tolerance_m);
Polyline simplify_line(const Polyline& line, double tolerance_m);

/// Smooths a ring `rounds` times by moving every point half way to the middle of its neighbours, then scales it about
/// its centroid so that the area stays. Same number of points; meant for points about evenly apart (densify).
Ring smooth_ring(const Ring& ring, int rounds);

/// Points at most step_m apart: edges are split evenly, every vertex stays.
Ring densify(const Ring& ring, double step_m);

}  // namespace seamount::geom
