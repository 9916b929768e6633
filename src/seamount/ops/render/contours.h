// render.contours: a contour set as a topographic map: brown lines on paper, every fifth stronger and with its height,
// blue under water, ticks downhill in basins.
#pragma once

#include <string>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/model/contour_set.h"
#include "seamount/model/image.h"

namespace seamount::render {

struct ContoursParams {
  int width_px = 1600;
  std::string title;
  int index_every = 5;
  bool labels = true;
  bool water = true;
  bool basin_ticks = true;
  bool scale_bar = true;
  bool north_arrow = true;

  static constexpr auto fields() {
    using P = ContoursParams;
    return std::tuple(
        field(&P::width_px, "width_px", "", between(16, 16384), "width of the picture in pixels"),
        field(&P::title, "title", "text over the map; none if empty"),
        field(&P::index_every, "index_every", "", between(1, 1000),
              "every so many heights the line is stronger, counted from sea level where heights are multiples of their "
              "interval, else from the lowest"),
        field(&P::labels, "labels", "write the heights of the stronger lines into them"),
        field(&P::water, "water", "tint what lies below a contour of sea level"),
        field(&P::basin_ticks, "basin_ticks", "draw ticks into basins, to tell them from hills"),
        field(&P::scale_bar, "scale_bar", "show lengths, and the interval between contours, below the map"),
        field(&P::north_arrow, "north_arrow", "show where north is"));
  }
};

/// Draws the set over its frame, north up. Throws InvalidArgument for params out of range and a set without contours,
/// Error where the font is missing. Linear in the pixels along the lines and the points.
Image contours(const ContourSet& set, const ContoursParams& params, const RunContext& run);

}  // namespace seamount::render
