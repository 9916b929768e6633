#include "seamount/ops/render/contours.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/geom/contour/nesting.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/ops/render/canvas.h"
#include "seamount/ops/render/contour_labels.h"
#include "seamount/ops/render/map_furniture.h"

namespace seamount::render {
namespace {

constexpr Colour kLand{150, 104, 62};
constexpr Colour kSea{66, 118, 164};
constexpr Colour kCoast{36, 78, 118};
constexpr Colour kWater{221, 235, 241};

/// The heights that occur, and which of them are drawn stronger.
struct Levels {
  std::vector<double> all, index;
  std::optional<double> interval_m;  ///< where all are multiples of it
};

bool is_multiple(double height, double of) { return std::abs(height / of - std::round(height / of)) < 1e-6; }

Levels find_levels(const ContourSet& set, int every) {
  Levels levels;
  for (const Contour& contour : set.contours) levels.all.push_back(contour.height_m);
  std::sort(levels.all.begin(), levels.all.end());
  levels.all.erase(std::unique(levels.all.begin(), levels.all.end()), levels.all.end());
  double gap = 0.0;
  for (size_t i = 1; i < levels.all.size(); ++i) {
    const double step = levels.all[i] - levels.all[i - 1];
    gap = i == 1 ? step : std::min(gap, step);
  }
  const bool even = gap > 0.0 && std::all_of(levels.all.begin(), levels.all.end(),
                                             [&](double height) { return is_multiple(height, gap); });
  if (even) levels.interval_m = gap;
  for (size_t i = 0; i < levels.all.size(); ++i) {
    const bool strong = even ? is_multiple(levels.all[i], gap * every) : i % static_cast<size_t>(every) == 0;
    if (strong) levels.index.push_back(levels.all[i]);
  }
  return levels;
}

struct Layout {
  double unit = 16.0;  ///< size of text
  int width = 0, height = 0;
  Box map;
  double pixel_m = 1.0;
};

Layout lay_out(const ContoursParams& params, const GridFrame& frame) {
  Layout layout;
  layout.unit = std::max(6.0, params.width_px / 62.0);
  const auto units = [&](double n) { return static_cast<int>(std::lround(n * layout.unit)); };
  const bool below = params.scale_bar || params.north_arrow;
  const int margin = below || !params.title.empty() ? units(1.5) : 0;
  const int top = params.title.empty() ? margin : units(4.2);
  layout.width = params.width_px;
  layout.map = {margin, top, std::max(1, params.width_px - 2 * margin), 1};
  layout.pixel_m = frame.width_m() / layout.map.width;
  layout.map.height = static_cast<int>(std::clamp(std::round(frame.height_m() / layout.pixel_m), 1.0, 16384.0));
  layout.height = layout.map.height + top + (below ? units(4.3) : margin);
  return layout;
}

Ring in_pixels(const Ring& ring, const GridFrame& frame, double pixel_m) {
  Ring pixels;
  pixels.reserve(ring.size());
  for (const Vec2 p : ring) pixels.push_back({(p.x - frame.west_m) / pixel_m, (frame.north_m - p.y) / pixel_m});
  return pixels;
}

/// The nearest contour of sea level around one, or -1.
int sea_level_around(const ContourSet& set, int contour) {
  do contour = set.contours[static_cast<size_t>(contour)].parent;
  while (contour >= 0 && set.contours[static_cast<size_t>(contour)].height_m != 0.0);
  return contour;
}

/// 1 where a pixel of the map lies below sea level, as far as contours of sea level tell.
Grid<uint8_t> find_water(const ContourSet& set, const Layout& layout) {
  std::vector<Polygon> islands, lakes;
  std::vector<int> island(set.contours.size(), -1);
  for (size_t i = 0; i < set.contours.size(); ++i) {
    const Contour& contour = set.contours[i];
    if (contour.height_m != 0.0) continue;
    const int around = sea_level_around(set, static_cast<int>(i));
    if (geom::is_hill(contour)) {
      island[i] = static_cast<int>(islands.size());
      islands.push_back({contour.ring, {}});
    } else if (around >= 0 && island[static_cast<size_t>(around)] >= 0) {
      islands[static_cast<size_t>(island[static_cast<size_t>(around)])].holes.push_back(contour.ring);
    } else {
      lakes.push_back({contour.ring, {}});
    }
  }
  const GridFrame frame{layout.map.width, layout.map.height, layout.pixel_m, set.frame.west_m, set.frame.north_m, {}};
  Grid<uint8_t> water = geom::rasterise(lakes, frame);
  if (!islands.empty()) {
    const Grid<uint8_t> land = geom::rasterise(islands, frame);
    for (size_t i = 0; i < water.size(); ++i) water.cells()[i] = land.cells()[i] == 0 ? 1 : water.cells()[i];
    return water;
  }
  const bool all_below = std::all_of(set.contours.begin(), set.contours.end(),
                                     [](const Contour& contour) { return contour.height_m < 0.0; });
  if (all_below) std::fill(water.cells().begin(), water.cells().end(), uint8_t{1});
  return water;
}

/// Short lines to the lower side, evenly along a ring whose higher side is on its left on the ground, which is the
/// right-hand side of the same points in pixels.
void add_ticks(LineLayer& layer, const Ring& ring, double unit) {
  const double spacing = 0.8 * unit, length = 0.28 * unit, width = std::max(0.6, unit / 30.0);
  double next = 0.5 * spacing;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i];
    const Vec2 d = ring[(i + 1) % ring.size()] - a;
    const double edge = std::hypot(d.x, d.y);
    for (; edge > 0.0 && next <= edge; next += spacing) {
      const Vec2 foot = a + (next / edge) * d;
      layer.add({foot, foot + (length / edge) * Vec2{-d.y, d.x}}, width);
    }
    next -= edge;
  }
}

std::string height_label(double height) { return format_number(std::round(height * 10.0) / 10.0); }

class Sheet {
 public:
  Sheet(const ContourSet& set, const ContoursParams& params, const RunContext& run)
      : params_(params),
        layout_(lay_out(params, set.frame)),
        levels_(find_levels(set, params.index_every)),
        image_(layout_.width, layout_.height, kPaperColour) {
    for (const Contour& contour : set.contours) {
      run.check_cancelled();
      rings_.push_back(in_pixels(contour.ring, set.frame, layout_.pixel_m));
    }
    if (params.water) water_ = find_water(set, layout_);
  }

  void draw_water() {
    for (int y = 0; y < water_.height(); ++y) {
      for (int x = 0; x < water_.width(); ++x)
        if (water_(x, y) != 0) blend(image_, layout_.map.x + x, layout_.map.y + y, kWater, 1.0F);
    }
  }

  void draw_lines(const ContourSet& set, const RunContext& run) {
    const double line = std::max(0.6, layout_.unit / 24.0);
    LineLayer land(layout_.map.width, layout_.map.height), sea(land), coast(land), index(land), sea_index(land);
    for (size_t i = 0; i < rings_.size(); ++i) {
      run.check_cancelled();
      const double height = set.contours[i].height_m;
      const bool strong = is_index(height), wet = height < 0.0;
      LineLayer& layer = params_.water && height == 0.0 ? coast : strong ? (wet ? sea_index : index) : wet ? sea : land;
      Polyline closed = rings_[i];
      closed.push_back(closed.front());
      layer.add(closed, (strong || &layer == &coast ? 2.0 : 1.0) * line);
      if (params_.basin_ticks && !geom::is_hill(set.contours[i])) add_ticks(layer, rings_[i], layout_.unit);
    }
    const auto lay = [&](const LineLayer& layer, Colour colour, float opacity) {
      run.check_cancelled();
      layer.draw(image_, layout_.map.x, layout_.map.y, colour, opacity);
    };
    lay(sea, kSea, 0.75F);
    lay(land, kLand, 0.75F);
    lay(sea_index, kSea, 1.0F);
    lay(index, kLand, 1.0F);
    lay(coast, kCoast, 1.0F);
  }

  void draw_labels(const ContourSet& set, const RunContext& run) {
    const Font font;
    const double size = 0.78 * layout_.unit;
    std::vector<LabelLine> lines;
    for (size_t i = 0; i < rings_.size(); ++i) {
      run.check_cancelled();
      const double height = set.contours[i].height_m;
      if (!is_index(height) || (params_.water && height == 0.0)) continue;
      lines.push_back({&rings_[i], height, font.width(height_label(height), size) + 0.5 * size});
    }
    const Vec2 corner{static_cast<double>(layout_.map.x), static_cast<double>(layout_.map.y)};
    for (const ContourLabel& label : place_labels(lines, size, layout_.map.width, layout_.map.height, run)) {
      run.check_cancelled();
      const Vec2 middle = corner + label.at;
      const Vec2 half = (0.5 * label.width) * label.along;
      const Vec2 up = (0.46 * size) * Vec2{label.along.y, -label.along.x};
      const bool wet =
          !water_.empty() && water_.clamped(static_cast<int>(label.at.x), static_cast<int>(label.at.y)) != 0;
      fill_polygon(image_, {middle - half - up, middle + half - up, middle + half + up, middle - half + up},
                   wet ? kWater : kPaperColour);
      font.draw_along(image_, middle, label.along, size, height_label(label.height_m),
                      label.height_m < 0.0 ? kSea : kLand);
    }
  }

  void draw_furniture() {
    if (!params_.scale_bar && !params_.north_arrow && params_.title.empty()) return;
    const Font font;
    const double unit = layout_.unit;
    const Box& map = layout_.map;
    const double right = map.x + map.width, bottom = map.y + map.height;
    clear_margins();
    frame_box(image_, map.x, map.y, right, bottom, std::max(1.0, 0.06 * unit), kInk);
    if (!params_.title.empty()) font.draw(image_, map.x, map.y - 1.25 * unit, 1.9 * unit, params_.title, kInk);
    if (params_.north_arrow) draw_north_arrow(image_, font, right - 0.7 * unit, bottom + 2.3 * unit, 0.85 * unit);
    if (!params_.scale_bar) return;
    const double bar = 0.3 * map.width;
    draw_scale_bar(image_, font, map.x + 0.4 * unit, bottom + 1.1 * unit, bar, unit, layout_.pixel_m);
    if (!levels_.interval_m || levels_.all.size() < 2) return;
    font.draw(image_, map.x + bar + 5.0 * unit, bottom + 1.5 * unit, unit,
              fmt::format("contours every {} m", height_label(*levels_.interval_m)), kInk);
  }

  Image take() { return std::move(image_); }

 private:
  bool is_index(double height) const { return std::binary_search(levels_.index.begin(), levels_.index.end(), height); }

  /// Halos of labels at the edge may have left the map.
  void clear_margins() {
    const Box& map = layout_.map;
    const double right = map.x + map.width, bottom = map.y + map.height;
    fill_box(image_, 0, 0, image_.width, map.y, kPaperColour);
    fill_box(image_, 0, bottom, image_.width, image_.height, kPaperColour);
    fill_box(image_, 0, map.y, map.x, bottom, kPaperColour);
    fill_box(image_, right, map.y, image_.width, bottom, kPaperColour);
  }

  const ContoursParams& params_;
  Layout layout_;
  Levels levels_;
  Image image_;
  std::vector<Ring> rings_;
  Grid<uint8_t> water_;
};

}  // namespace

Image contours(const ContourSet& set, const ContoursParams& params, const RunContext& run) {
  check_params(params);
  run.check_cancelled();
  if (set.contours.empty()) throw InvalidArgument("contours", "holds no contours");
  Sheet sheet(set, params, run);
  if (params.water) sheet.draw_water();
  run.report(0.2);
  sheet.draw_lines(set, run);
  run.report(0.8);
  if (params.labels) sheet.draw_labels(set, run);
  sheet.draw_furniture();
  run.report(1.0);
  return sheet.take();
}

}  // namespace seamount::render
