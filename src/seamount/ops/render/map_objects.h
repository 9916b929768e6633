// The objects of a scene on a map: regions as tints with an outline, curves as lines, points as symbols.
#pragma once

#include <span>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/image.h"
#include "seamount/model/scene.h"
#include "seamount/ops/render/map_furniture.h"
#include "seamount/ops/render/map_symbols.h"

namespace seamount::render {

/// A class with those of its objects that a map shows.
struct ShownClass {
  const ObjectClass* of_class = nullptr;
  std::vector<const SceneObject*> objects;
  Symbol symbol = Symbol::circle;  ///< of points: the same whether the other classes have objects or not
  double shrink = 1.0;             ///< of symbols, so that they do not cover each other
  double dot_px = 0.0;             ///< above 0: they would still, and are dots of this radius
};

/// The classes that have objects on the map of a frame, whatever window those grew in: regions, then curves, then
/// points, each in the catalogue's order. Refers to the scene. Linear in its vertices. Throws IncompatibleInputs for a
/// scene in another coordinate system than the frame, where both have one.
std::vector<ShownClass> shown_classes(const seamount::Scene& scene, const GridFrame& frame);

/// What is one pixel wide in pictures of 900 to 1250 pixels, and finer and broader in smaller and larger ones.
double map_pen(double unit);

/// Radius in pixels of a point's symbol if there is room: half its diameter on the map, but 2 to 9 pens.
double symbol_radius(const ObjectClass& of_class, const SceneObject& object, double pixel_m, double pen);

/// Finds `shrink` and `dot_px`: a quarter of the symbols of a class may touch another one. Those that are less than
/// half as large do not count: a few rocks stay what they are among many pebbles. About 2 us a point.
void fit_symbols(std::vector<ShownClass>& shown, double pixel_m, double pen, const RunContext& run);

/// Draws them into the box of the picture that `frame` is shown in, cut off at its edges; `unit` in pixels is the size
/// of text.
void draw_objects(Image& image, const Box& box, const GridFrame& frame, std::span<const ShownClass> shown, double unit,
                  const RunContext& run);

/// How a class looks, for a legend, within one unit of a place.
void draw_class_sign(Image& image, Vec2 middle, const ShownClass& shown, double unit);

}  // namespace seamount::render
