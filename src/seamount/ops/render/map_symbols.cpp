#include "seamount/ops/render/map_symbols.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "seamount/ops/render/canvas.h"
#include "seamount/ops/render/colour.h"
#include "seamount/ops/render/map_furniture.h"

namespace seamount::render {
namespace {

/// A polygon whose corners lie at one distance from its middle, or by turns at two.
struct Outline {
  int corners;
  double first;  ///< direction of its first corner from upwards, as a share of the step between corners
  double inner;  ///< distance of every second corner over that of the others
};

Outline outline_of(Symbol symbol) {
  switch (symbol) {
    case Symbol::triangle:
      return {3, 0.0, 1.0};
    case Symbol::square:
      return {4, 0.5, 1.0};
    case Symbol::diamond:
      return {4, 0.0, 1.0};
    default:
      return {10, 0.0, 0.5};
  }
}

/// Half the angle between neighbouring corners.
double half_step(const Outline& of) { return std::numbers::pi / of.corners; }

/// Distance of the outer corners of the polygon whose area is that of a disc.
double corner_distance(const Outline& of, double radius) {
  return radius * std::sqrt(std::numbers::pi / (0.5 * of.corners * of.inner * std::sin(2.0 * half_step(of))));
}

/// How much further out the corners lie when the sides lie one further.
double corner_growth(const Outline& of) {
  const double side = std::sqrt(1.0 + of.inner * of.inner - 2.0 * of.inner * std::cos(2.0 * half_step(of)));
  return side / (of.inner * std::sin(2.0 * half_step(of)));
}

std::vector<Vec2> corners_of(const Outline& of, Vec2 middle, double distance) {
  std::vector<Vec2> corners;
  for (int i = 0; i < of.corners; ++i) {
    const double angle = 2.0 * half_step(of) * (i + of.first), r = distance * (i % 2 == 0 ? 1.0 : of.inner);
    corners.push_back(middle + r * Vec2{std::sin(angle), -std::cos(angle)});
  }
  return corners;
}

}  // namespace

Colour edge_colour(Colour fill) { return lightness(linear(fill)) < 0.6F ? kPaperColour : kInk; }

Symbol symbol_of(int number) {
  return number <= static_cast<int>(Symbol::star) ? static_cast<Symbol>(number) : Symbol::circle;
}

void draw_symbol(Image& image, Vec2 middle, double radius, Symbol symbol, Colour colour, double pen) {
  const Colour edge = edge_colour(colour);
  if (symbol == Symbol::circle) {
    fill_disc(image, middle, radius + pen, edge);
    fill_disc(image, middle, radius, colour);
    return;
  }
  const Outline outline = outline_of(symbol);
  const double distance = corner_distance(outline, radius);
  fill_polygon(image, corners_of(outline, middle, distance + pen * corner_growth(outline)), edge);
  fill_polygon(image, corners_of(outline, middle, distance), colour);
}

}  // namespace seamount::render
