// Drawing on pictures: blended pixels, boxes and anti-aliased lines. Pixel (0, 0) covers [0, 1] x [0, 1].
#pragma once

#include <vector>

#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"
#include "seamount/model/image.h"

namespace seamount::render {

/// Mixes a colour into a pixel by its share in [0, 1], in sRGB as drawing programs do; outside the picture: nothing.
void blend(Image& image, int x, int y, Colour colour, float share);

/// Fills the box, edges at fractions of a pixel included by share.
void fill_box(Image& image, double x0, double y0, double x1, double y1, Colour colour);

/// A thin frame just inside the box.
void frame_box(Image& image, double x0, double y0, double x1, double y1, double width, Colour colour);

/// Fills a polygon (even-odd), anti-aliased by 4 x 4 samples a pixel.
void fill_polygon(Image& image, const std::vector<Vec2>& corners, Colour colour);

/// Fills a disc, anti-aliased; one of less than a pixel by its share of it.
void fill_disc(Image& image, Vec2 middle, double radius, Colour colour);

/// Lines of one style that may cross and overlap: each pixel is covered once, by the nearest line.
class LineLayer {
 public:
  LineLayer(int width, int height);
  /// Adds a polyline in pixels with round joints. Linear in the pixels near it.
  void add(const Polyline& line, double width);
  /// Lays the lines over the picture with their top left corner at (x, y).
  void draw(Image& image, int x, int y, Colour colour, float opacity) const;

 private:
  Grid<float> coverage_;
};

}  // namespace seamount::render
