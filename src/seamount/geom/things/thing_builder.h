// Puts the mesh of a thing together from closed surfaces (tubes, blobs, lathes, lenses) and from leaves.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "seamount/geom/things/point3.h"
#include "seamount/geom/things/tone.h"
#include "seamount/model/things.h"

namespace seamount::geom {

/// One ring of a tube.
struct Ring3 {
  Point3 centre;
  double radius = 0.1;
  Tone tone;
};

class ThingBuilder {
 public:
  /// A surface around a chain of rings, closed at both ends; `sides` corners in each. `bulge(ring, angle)`, if given,
  /// multiplies the radius. REQUIRES: at least two rings with radii > 0 in different places, sides >= 3.
  void tube(std::span<const Ring3> rings, int sides, const std::function<double(size_t, double)>& bulge = {});

  /// A sphere of 20 * 4^fineness triangles, its unit directions moved by `place` and coloured by `colour`.
  void blob(int fineness, const std::function<Point3(Point3)>& place, const std::function<Tone(Point3)>& colour);

  /// A surface of sectors between two poles: rows of points, place(row, angle). REQUIRES: rows >= 1 and
  /// counter-clockwise seen from outside when rows go from the lower to the upper pole.
  void lathe(Point3 lower, Point3 upper, int rows, int sectors, const std::function<Point3(int, double)>& place,
             const std::function<Tone(Point3)>& colour);

  /// A pyramid on three corners around `base`, closed.
  void spike(Point3 base, Point3 tip, double radius, double turn, Tone low, Tone high);

  /// A thin sheet of across x along patches; its normals are its own, or lean towards `lean` by `leaning` in
  /// [0, 1]; then it faces that side.
  void sheet(int across, int along, const std::function<Point3(double, double)>& place,
             const std::function<Tone(double, double)>& colour, Point3 lean = {}, double leaning = 0.0);

  /// A leaf of two triangles: from `base` to `tip`, as wide as 2 |side| where it is widest. It faces `normal`'s side.
  void leaf(Point3 base, Point3 tip, Point3 side, Point3 normal, Tone low, Tone high);
  /// A leaf of one triangle, widest at its base.
  void blade(Point3 base, Point3 tip, Point3 side, Point3 normal, Tone low, Tone high);

  /// What follows is missing while this is true: an ailing thing lost it. It still counts for the size.
  void missing(bool missing) { missing_ = missing; }

  /// The mesh, its lowest point at z = 0, stretched to a height and width (of the upright box around the z axis, the
  /// wider side). Without triangles of no area. Clears the builder.
  ThingMesh finish(double height_m, double width_m);

 private:
  class Part;
  uint32_t vertex(Point3 place, Tone tone);
  uint32_t leaf_vertex(Point3 place, Point3 normal, Tone tone);
  std::vector<Point3> solid_normals() const;

  std::vector<Point3> places_, leaf_places_, leaf_normals_, room_;
  std::vector<Tone> tones_, leaf_tones_;
  std::vector<uint32_t> solid_, leaves_;
  bool missing_ = false;
};

}  // namespace seamount::geom
