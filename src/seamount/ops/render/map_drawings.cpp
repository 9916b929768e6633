#include "seamount/ops/render/map_drawings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/ops/render/canvas.h"

namespace seamount::render {
namespace {

constexpr Colour kWater{58, 112, 168}, kLake{150, 192, 216}, kRidge{134, 62, 40};

double attribute(const Attributes& attributes, std::string_view name, double otherwise) {
  for (const Attribute& one : attributes)
    if (one.name == name) return one.value;
  return otherwise;
}

/// Places in metres as pixels of the box.
class Sheet {
 public:
  Sheet(Image& image, const Box& box, const GridFrame& frame, double unit, const RunContext& run)
      : image_(image), box_(box), frame_(frame), unit_(unit), scale_(box.width / frame.width_m()), run_(run) {}

  Vec2 pixel(Vec2 place) const { return {(place.x - frame_.west_m) * scale_, (frame_.north_m - place.y) * scale_}; }

  void draw_lakes(const Drawing& lakes) {
    GridFrame pixels = frame_;
    pixels.width = box_.width;
    pixels.height = box_.height;
    pixels.cell_m = 1.0 / scale_;
    LineLayer shore(box_.width, box_.height);
    std::vector<Polygon> parts;
    for (const NamedArea& lake : lakes.areas) parts.insert(parts.end(), lake.parts.begin(), lake.parts.end());
    const Grid<uint8_t> inside = geom::rasterise(parts, pixels);
    for (int y = 0; y < box_.height; ++y) {
      run_.check_cancelled();
      for (int x = 0; x < box_.width; ++x) {
        if (inside(x, y) != 0) blend(image_, box_.x + x, box_.y + y, kLake, 1.0F);
      }
    }
    for (const Polygon& part : parts) {
      run_.check_cancelled();
      add_ring(shore, part.outer);
      for (const Ring& hole : part.holes) add_ring(shore, hole);
    }
    shore.draw(image_, box_.x, box_.y, kWater, 0.8F);
  }

  /// Lines from those of the lowest order to the highest; `thinnest` and what an order adds, in units.
  void draw_lines(const Drawing& drawing, Colour colour, float opacity, double thinnest, double per_order) {
    LineLayer layer(box_.width, box_.height);
    for (const ValuedLine& line : drawing.lines) {
      run_.check_cancelled();
      const double order = std::clamp(attribute(line.attributes, "order", line.value), 1.0, 12.0);
      Polyline pixels;
      pixels.reserve(line.points.size() + 1);
      for (const Vec2& p : line.points) pixels.push_back(pixel(p));
      if (line.closed && !pixels.empty()) pixels.push_back(pixels.front());
      layer.add(pixels, std::max(0.7, unit_ * (thinnest + per_order * (order - 1.0))));
    }
    run_.check_cancelled();
    layer.draw(image_, box_.x, box_.y, colour, opacity);
  }

  void draw_peaks(const Drawing& peaks) {
    std::vector<const ValuedPoint*> points;
    for (const ValuedPoint& point : peaks.points) points.push_back(&point);
    std::stable_sort(points.begin(), points.end(), [](const ValuedPoint* a, const ValuedPoint* b) {
      return attribute(a->attributes, "prominence_m", a->value) > attribute(b->attributes, "prominence_m", b->value);
    });
    const Font font;
    const double size = 0.62 * unit_, half = 0.26 * unit_;
    std::vector<std::pair<Vec2, Vec2>> taken;  // boxes of what stands there
    for (const ValuedPoint* point : points) {
      run_.check_cancelled();
      const Vec2 at = pixel(point->place);
      if (at.x < half || at.y < half || at.x > box_.width - half || at.y > box_.height - half) continue;
      const std::string text = fmt::format("{:.0f}", attribute(point->attributes, "height_m", point->value));
      const double width = font.width(text, size);
      const Vec2 low{at.x - half, at.y - half}, high{at.x + 1.5 * half + width, at.y + half};
      const bool free = std::none_of(taken.begin(), taken.end(), [&](const auto& other) {
        return low.x < other.second.x && other.first.x < high.x && low.y < other.second.y && other.first.y < high.y;
      });
      if (!free) continue;
      taken.emplace_back(low, high);
      const Vec2 place{box_.x + at.x, box_.y + at.y};
      fill_polygon(image_,
                   {{place.x - half, place.y + half}, {place.x + half, place.y + half}, {place.x, place.y - half}},
                   kInk);
      if (high.x < box_.width) font.draw(image_, place.x + 1.5 * half, place.y + half, size, text, kInk);
    }
  }

 private:
  void add_ring(LineLayer& layer, const Ring& ring) const {
    Polyline pixels;
    pixels.reserve(ring.size() + 1);
    for (const Vec2& p : ring) pixels.push_back(pixel(p));
    if (!pixels.empty()) pixels.push_back(pixels.front());
    layer.add(pixels, std::max(0.7, 0.05 * unit_));
  }

  Image& image_;
  Box box_;
  GridFrame frame_;
  double unit_, scale_;
  const RunContext& run_;
};

}  // namespace

void draw_drawings(Image& image, const Box& box, const GridFrame& frame, const MapDrawings& drawings, double unit,
                   const RunContext& run) {
  for (const Drawing* drawing : {drawings.lakes, drawings.rivers, drawings.ridges, drawings.peaks}) {
    if (drawing == nullptr || drawing->crs.empty() || frame.crs.empty() || drawing->crs == frame.crs) continue;
    throw IncompatibleInputs("the terrain and a drawing over it are in different coordinate systems");
  }
  Sheet sheet(image, box, frame, unit, run);
  if (drawings.ridges != nullptr) sheet.draw_lines(*drawings.ridges, kRidge, 0.55F, 0.05, 0.03);
  if (drawings.rivers != nullptr) sheet.draw_lines(*drawings.rivers, kWater, 0.95F, 0.055, 0.05);
  if (drawings.lakes != nullptr) sheet.draw_lakes(*drawings.lakes);
  if (drawings.peaks != nullptr) sheet.draw_peaks(*drawings.peaks);
}

}  // namespace seamount::render
