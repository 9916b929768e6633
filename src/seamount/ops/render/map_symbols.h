// Symbols of points on a map: shapes that differ without their colours, and dots where there is no room for shapes.
#pragma once

#include "seamount/model/image.h"

namespace seamount::render {

enum class Symbol : unsigned char { circle, triangle, square, diamond, star };

/// Symbols of the first classes of points are all different; the rest are circles.
Symbol symbol_of(int number);

/// What symbols and lines are lined with: light around dark colours, dark around others.
Colour edge_colour(Colour fill);

/// Draws a symbol that covers as much as a disc of `radius` pixels, with an outline `pen` pixels wide around it.
void draw_symbol(Image& image, Vec2 middle, double radius, Symbol symbol, Colour colour, double pen);

}  // namespace seamount::render
