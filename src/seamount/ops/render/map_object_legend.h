// The legend of a map's objects: their classes with symbols, names and numbers, in columns.
#pragma once

#include <span>

#include "seamount/ops/render/map_objects.h"

namespace seamount::render {

/// A legend as it fits a width. Pixels.
struct ObjectLegend {
  int columns = 0, rows = 0;
  double column = 0.0, width = 0.0, height = 0.0;
  double name = 0.0;   ///< widest that a name may be; longer ones are cut short
  size_t entries = 0;  ///< so many classes are listed; the last line tells how many more there are
};

/// At most 24 rows. REQUIRES: `shown` is not empty.
ObjectLegend lay_out_object_legend(const Font& font, std::span<const ShownClass> shown, double width, double unit);

/// Draws it from the box's top left corner on.
void draw_object_legend(Image& image, const Font& font, const Box& box, std::span<const ShownClass> shown,
                        const ObjectLegend& legend, double unit);

}  // namespace seamount::render
