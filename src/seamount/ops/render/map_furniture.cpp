#include "seamount/ops/render/map_furniture.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/text.h"
#include "seamount/ops/render/canvas.h"

namespace seamount::render {

void draw_height_legend(Image& image, const Font& font, const Box& box, double unit, const TintScale& scale) {
  const double left = box.x, right = box.x + 1.1 * unit, top = box.y, bottom = box.y + box.height;
  for (int y = box.y; y < box.y + box.height; ++y) {
    const double place = 1.0 - (y + 0.5 - top) / box.height;
    fill_box(image, left, y, right, y + 1, srgb(scale.bar_tint(place)));
  }
  frame_box(image, left, top, right, bottom, std::max(1.0, 0.06 * unit), kInk);
  for (const TintScale::Tick& tick : scale.ticks(3.2 * unit / box.height)) {
    const double y = bottom - tick.place * box.height;
    fill_box(image, right, y - 0.04 * unit, right + 0.3 * unit, y + 0.04 * unit, kInk);
    font.draw(image, right + 0.45 * unit, y + 0.36 * unit, unit, height_text(tick.height_m), kInk);
  }
  font.draw(image, left, top - 0.8 * unit, unit, "m", kInk);
}

void draw_swatches(Image& image, const Font& font, const Box& box, double unit, std::span<const Swatch> swatches) {
  double y = box.y;
  for (const Swatch& swatch : swatches) {
    fill_box(image, box.x, y, box.x + 1.1 * unit, y + 1.1 * unit, swatch.colour);
    frame_box(image, box.x, y, box.x + 1.1 * unit, y + 1.1 * unit, std::max(1.0, 0.06 * unit), kInk);
    font.draw(image, box.x + 1.5 * unit, y + 0.91 * unit, unit, swatch.name, kInk);
    y += 1.8 * unit;
  }
}

void draw_scale_bar(Image& image, const Font& font, double x, double y, double widest, double unit, double pixel_m) {
  if (widest < 1.0) return;
  const double length_m = round_down_nice(widest * pixel_m), length = length_m / pixel_m;
  const double thick = 0.34 * unit, line = std::max(1.0, 0.06 * unit);
  const bool kilometres = length_m >= 1000.0;
  const double shown = kilometres ? length_m / 1000.0 : length_m;
  // Two halves, the first of them in two quarters: dark and light in turn.
  fill_box(image, x, y, x + 0.25 * length, y + thick, kInk);
  fill_box(image, x + 0.5 * length, y, x + length, y + thick, kInk);
  frame_box(image, x, y, x + length, y + thick, line, kInk);
  const double baseline = y + thick + 1.15 * unit;
  font.draw(image, x, baseline, unit, "0", kInk, Anchor::middle);
  font.draw(image, x + 0.5 * length, baseline, unit, format_number(0.5 * shown), kInk, Anchor::middle);
  const std::string last = format_number(shown);
  font.draw(image, x + length - 0.5 * font.width(last, unit), baseline, unit, last + (kilometres ? " km" : " m"), kInk);
}

void draw_north_arrow(Image& image, const Font& font, double x, double y, double unit) {
  const double half = 0.62 * unit, top = y - 0.4 * unit, bottom = y + 1.5 * unit, notch = y + 1.05 * unit;
  fill_polygon(image, {{x, top}, {x, notch}, {x - half, bottom}}, kInk);
  fill_polygon(image, {{x, top}, {x + half, bottom}, {x, notch}}, Colour{170, 172, 174});
  font.draw(image, x, y - 0.7 * unit, 1.15 * unit, "N", kInk, Anchor::middle);
}

}  // namespace seamount::render
