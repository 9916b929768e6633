// What stands around a map: legend, scale bar, north arrow, title.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "seamount/model/image.h"
#include "seamount/ops/render/text.h"
#include "seamount/ops/render/tints.h"

namespace seamount::render {

/// A box in pixels.
struct Box {
  int x = 0, y = 0, width = 0, height = 0;
};

inline constexpr Colour kInk{44, 46, 50};
inline constexpr Colour kPaperColour{252, 251, 247};

/// A colour bar in the left part of the box with round heights at its side; `unit` in pixels is the size of text.
void draw_height_legend(Image& image, const Font& font, const Box& box, double unit, const TintScale& scale);

/// A colour and what it stands for.
struct Swatch {
  std::string_view name;
  Colour colour;
};

/// Swatches and their names, from the top of the box.
void draw_swatches(Image& image, const Font& font, const Box& box, double unit, std::span<const Swatch> swatches);

/// A bar of a round length at most `widest` pixels, from (x, y) to the right and down.
void draw_scale_bar(Image& image, const Font& font, double x, double y, double widest, double unit, double pixel_m);

/// An arrow with its middle at (x, y), three units high.
void draw_north_arrow(Image& image, const Font& font, double x, double y, double unit);

}  // namespace seamount::render
