#include "seamount/ops/render/map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/geom/contour/contour.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/water/flat_sea.h"
#include "seamount/model/same_size.h"
#include "seamount/ops/render/canvas.h"
#include "seamount/ops/render/ground.h"
#include "seamount/ops/render/map_arrows.h"
#include "seamount/ops/render/map_furniture.h"
#include "seamount/ops/render/map_object_legend.h"
#include "seamount/ops/render/relief.h"
#include "seamount/ops/render/shading.h"
#include "seamount/ops/render/standing_water.h"
#include "seamount/ops/render/style_tints.h"
#include "seamount/ops/render/unknown.h"

namespace seamount::render {
namespace {

/// What is drawn where, all on the grid of the map's pixels.
struct Sheet {
  HeightField ground;
  Grid<uint8_t> unknown_sea;  ///< 1: sea without depths; empty: none
  Grid<uint8_t> unknown;      ///< 1: nothing is known; empty: nowhere
  Grid<uint8_t> dry;          ///< 1: land that lies lower than the sea; empty: none
  ScalarField lakes;          ///< depth of lakes as depth_around_lakes(), which `ground` includes; empty: none
  Grid<float> shade;
  LowestGround lowest;
  double high = 0.0;
  double low() const { return std::min(lowest.sea_m, lowest.land_m); }
  bool is_dry(size_t i) const { return !dry.empty() && dry.data()[i] != 0; }
};

/// Flat sea is put below the coast, and has neither depth nor shade.
void sink_unknown_sea(Sheet& sheet) {
  // The legend speaks of land only, and the coast runs where the flat sea begins.
  sheet.lowest.land_m = std::max(0.0, sheet.low());
  sheet.lowest.sea_m = 0.0;
  // Resampling leaves ripples of less than a metre along the coast's step.
  for (size_t i = 0; i < sheet.ground.size(); ++i) {
    if (sheet.is_dry(i) || (sheet.unknown_sea.cells()[i] == 0 && sheet.ground.cells()[i] >= 0.3F)) continue;
    sheet.ground.cells()[i] = -1.0F;
    sheet.shade.cells()[i] = 1.0F;
  }
}

Sheet make_sheet(const HeightField& terrain, const ScalarField* lake, int width_px,
                 const std::optional<double>& min_sea_m2, const RunContext& run) {
  Sheet sheet;
  sheet.ground = picture_terrain(terrain, width_px, run.part(0.0, 0.2));
  const ScalarField lakes = depth_around_lakes(terrain, lake, run);
  Filled filled = fill_unknown(sheet.ground, run);
  if (!filled.terrain.empty()) {
    sheet.ground = std::move(filled.terrain);
    sheet.unknown = std::move(filled.unknown);
  }
  sheet.unknown_sea = geom::flat_sea(sheet.ground, run.part(0.2, 0.25));
  sheet.dry = picture_dry(terrain, sheet.ground, min_sea_m2, run);
  if (!lakes.empty()) {
    sheet.lakes = geom::resample(lakes, sheet.ground.frame(), run);
    raise_to_lakes(sheet.ground, sheet.lakes);
  }
  sheet.shade = relief_shading(sheet.ground, {}, run.part(0.25, 1.0));
  sheet.lowest = lowest_ground(sheet.ground, sheet.dry);
  sheet.high = *std::max_element(sheet.ground.cells().begin(), sheet.ground.cells().end());
  if (!sheet.unknown_sea.empty()) sink_unknown_sea(sheet);
  return sheet;
}

/// Sizes in pixels: the sheet, the map on it, the column of the legend.
struct Layout {
  double unit = 16.0;  ///< size of text
  int width = 0, height = 0;
  Box map;
  Box side;
  ObjectLegend object_legend;
  Box objects;  ///< of that legend; without height: none
};

Layout lay_out(const MapParams& params, const GridFrame& frame, bool arrows, std::span<const ShownClass> shown) {
  Layout layout;
  layout.unit = std::max(6.0, params.width_px / 62.0);
  const auto units = [&](double n) { return static_cast<int>(std::lround(n * layout.unit)); };
  const bool side = params.legend || params.north_arrow;
  const bool styled = params.legend && params.theme == MapTheme::height && params.style != Style::natural;
  const bool below = params.scale_bar || (arrows && params.legend);
  const bool listed = params.object_legend && !shown.empty();
  const bool bare = !side && !below && !listed && params.title.empty();
  const int margin = bare ? 0 : units(1.5);
  const int top = params.title.empty() ? margin : units(4.2);
  const int below_map = below ? units(listed ? 3.4 : 3.6) : margin;
  const int column = side ? units(styled ? 11.5 : 7.2) : 0;
  layout.width = params.width_px;
  layout.map = {margin, top, std::max(1, params.width_px - 2 * margin - column), 1};
  layout.map.height =
      static_cast<int>(std::clamp(std::round(frame.height_m() * layout.map.width / frame.width_m()), 1.0, 16384.0));
  layout.height = top + layout.map.height + below_map;
  layout.side = {layout.map.x + layout.map.width + units(1.4), top, column - units(1.4), layout.map.height};
  if (listed) {
    layout.object_legend = lay_out_object_legend(Font(), shown, layout.map.width, layout.unit);
    layout.objects = {layout.map.x, layout.height, static_cast<int>(std::ceil(layout.object_legend.width)),
                      static_cast<int>(std::ceil(layout.object_legend.height))};
    layout.height += layout.objects.height + margin;
  }
  return layout;
}

/// Adds the level line of a field on the map's own grid to a layer, in the map's pixels.
void add_level(LineLayer& layer, const ScalarField& field, double level, double width, const RunContext& run) {
  const GridFrame& frame = field.frame();
  for (const Polyline& line : geom::trace_lines(field, level, run)) {
    run.check_cancelled();
    Polyline pixels;
    pixels.reserve(line.size());
    for (const Vec2& p : line)
      pixels.push_back({(p.x - frame.west_m) / frame.cell_m, (frame.north_m - p.y) / frame.cell_m});
    layer.add(pixels, width);
  }
}

/// Round interval for about twenty contours over land, or over all where there is no land to speak of; a metre at
/// least, which is what the lowest land is known to.
double contour_interval(const MapParams& params, double low, double high) {
  if (params.contour_interval_m) return *params.contour_interval_m;
  const double range = high > 1.0 ? high - std::max(0.0, low) : high - low;
  const double least = std::max(1.0, range / 22.0);
  const double round = round_down_nice(least);
  return round >= least - 1e-9                         ? round
         : round_down_nice(2.5 * round + 1e-9) > least ? round_down_nice(2.5 * round)
                                                       : 5.0 * round;
}

/// Depths in metres whose lines a chart shows (negative, falling): 2, 5, 10, 20, 30, 50, 100, 200, 500, 1000 and so on.
std::vector<double> chart_depths(double low) {
  constexpr std::array kFirst = {2.0, 5.0, 10.0, 20.0, 30.0, 50.0, 100.0, 200.0, 500.0};
  std::vector<double> depths;
  for (const double depth : kFirst)
    if (-depth > low) depths.push_back(-depth);
  for (double depth = 1000.0; - depth > low; depth += 1000.0) depths.push_back(-depth);
  return depths;
}

/// The ground without hollows: dry land below the sea's level is just above it.
HeightField without_hollows(const Sheet& sheet) {
  HeightField ground = sheet.ground;
  for (size_t i = 0; i < ground.size(); ++i)
    if (sheet.is_dry(i)) ground.data()[i] = 1.0F;
  return ground;
}

/// The ground with the sea filled up.
HeightField without_sea(const Sheet& sheet) {
  HeightField ground = sheet.ground;
  for (size_t i = 0; i < ground.size(); ++i)
    if (ground.data()[i] < 0.0F && !sheet.is_dry(i)) ground.data()[i] = 0.0F;
  return ground;
}

/// Every fifth line of land is stronger, and of a chart's those of 10, 100 and 1000 metres.
bool is_major(int64_t line) { return line % 5 == 0; }
bool is_major_depth(double depth) {
  const double power = std::log10(-depth);
  return std::abs(power - std::round(power)) < 1e-9;
}

/// `shore`: the ground without hollows.
void draw_contours(Image& image, const Layout& layout, const Sheet& sheet, const HeightField& shore,
                   const MapParams& params, const RunContext& run) {
  const HeightField& ground = sheet.ground;
  const HeightField hollows = sheet.dry.empty() ? HeightField() : without_sea(sheet);
  const double low = sheet.low(), high = sheet.high, interval = contour_interval(params, low, high);
  const double line = std::max(0.6, layout.unit / 26.0);
  LineLayer land(ground.width(), ground.height()), sea(land), index(land), sea_index(land);
  const auto first = static_cast<int64_t>(std::ceil(low / interval)), last = static_cast<int64_t>(high / interval);
  for (int64_t i = first; i <= last; ++i) {
    run.check_cancelled();
    const double level = static_cast<double>(i) * interval;
    LineLayer& layer = is_major(i) ? index : land;
    const double width = is_major(i) ? 1.5 * line : line;
    if (i < 0 && !hollows.empty()) add_level(layer, hollows, level, width, run);
    if (i > 0) add_level(layer, ground, level, width, run);
    if (i < 0 && params.contour_interval_m) add_level(is_major(i) ? sea_index : sea, shore, level, line, run);
  }
  for (const double depth : params.contour_interval_m ? std::vector<double>() : chart_depths(low)) {
    run.check_cancelled();
    add_level(is_major_depth(depth) ? sea_index : sea, shore, depth, line, run);
  }
  const Colour brown{120, 84, 50}, blue{38, 84, 130};
  run.check_cancelled();
  land.draw(image, layout.map.x, layout.map.y, brown, 0.30F);
  index.draw(image, layout.map.x, layout.map.y, brown, 0.55F);
  run.check_cancelled();
  sea.draw(image, layout.map.x, layout.map.y, blue, 0.22F);
  sea_index.draw(image, layout.map.x, layout.map.y, blue, 0.36F);
}

/// 1 inside the reef's outer edge, 0 in open water beyond it, smoothed so that its half level is a clean line.
ScalarField inside_reef(const LabelMap& labels, const GridFrame& frame, const RunContext& run) {
  Grid<float> inside(labels.frame());
  for (size_t i = 0; i < labels.size(); ++i) inside.cells()[i] = labels.cells()[i] == Region::abyss ? 0.0F : 1.0F;
  ScalarField picture = geom::resample(inside, frame, run);
  geom::gaussian_blur(picture, std::max(1.2 * frame.cell_m, 0.8 * labels.cell_m()), run);
  return picture;
}

void paint_ground(Image& image, const Layout& layout, const Sheet& sheet, const LabelMap* labels,
                  const MapParams& params, const TintScale& scale, const StyleTints* styled, const RunContext& run) {
  const auto strength = static_cast<float>(params.shading);
  const Rgb unknown = linear(Colour{176, 211, 220});
  const HeightField& ground = sheet.ground;
  parallel_rows(run, ground.width(), ground.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < ground.width(); ++x) {
        const float height = ground(x, y);
        const bool dry = !sheet.dry.empty() && sheet.dry(x, y) != 0;
        const bool lake = !sheet.lakes.empty() && sheet.lakes(x, y) > 0.0F;
        Rgb tint = styled != nullptr ? styled->tint(x, y) : scale.tint(height, dry);
        if (!sheet.unknown_sea.empty() && height < 0.0F && !dry) tint = unknown;
        if (lake) tint = lake_tint(sheet.lakes(x, y));
        if (params.theme == MapTheme::regions) {
          const auto column = static_cast<int>((x + 0.5) * labels->width() / ground.width());
          const auto row = static_cast<int>((y + 0.5) * labels->height() / ground.height());
          tint = region_colour(static_cast<int>(labels->clamped(column, row)));
        }
        // The floor is shaded more lightly than the land, less and less over the first metres of depth.
        const float part = strength * (height < 0.0F && !dry ? mix(0.85F, 0.55F, ramp(0.0F, 40.0F, -height)) : 1.0F);
        const int px = layout.map.x + x, py = layout.map.y + y;
        write_dithered(image.pixel(px, py), px, py, shaded(tint, 1.0F + part * (sheet.shade(x, y) - 1.0F)));
      }
    }
  });
}

/// Takes out what was drawn where nothing is known.
void blank_unknown(Image& image, const Layout& layout, const Grid<uint8_t>& unknown) {
  if (unknown.empty()) return;
  for (int y = 0; y < unknown.height(); ++y) {
    for (int x = 0; x < unknown.width(); ++x) {
      const int px = layout.map.x + x, py = layout.map.y + y;
      if (unknown(x, y) != 0) write_dithered(image.pixel(px, py), px, py, kUnknownGround);
    }
  }
}

std::vector<Swatch> region_swatches() {
  std::vector<Swatch> swatches;
  swatches.reserve(kRegions.size());
  for (const Region region : kRegions)
    swatches.push_back({region_name(region), srgb(region_colour(static_cast<int>(region)))});
  return swatches;
}

void draw_furniture(Image& image, const Layout& layout, const MapParams& params, const TintScale& scale,
                    const StyleTints* styled, const ArrowScale* arrows, std::span<const ShownClass> shown,
                    double pixel_m) {
  const bool listed = layout.objects.height > 0;
  if (params.title.empty() && !params.legend && !params.scale_bar && !params.north_arrow && !listed) return;
  const Font font;
  const double unit = layout.unit;
  const Box &map = layout.map, &side = layout.side;
  frame_box(image, map.x, map.y, map.x + map.width, map.y + map.height, std::max(1.0, 0.06 * unit), kInk);
  if (!params.title.empty()) font.draw(image, map.x, map.y - 1.25 * unit, 1.9 * unit, params.title, kInk);
  const int top = static_cast<int>(std::lround((params.north_arrow ? 5.6 : 1.6) * unit));
  if (params.north_arrow) draw_north_arrow(image, font, side.x + 0.6 * unit, side.y + 1.7 * unit, unit);
  if (params.legend) {
    const Box box{side.x, side.y + top, side.width, side.height - top};
    if (params.theme == MapTheme::regions) {
      draw_swatches(image, font, box, unit, region_swatches());
    } else if (styled != nullptr) {
      draw_swatches(image, font, box, unit, styled->legend());
    } else if (box.height > 4 * unit) {
      draw_height_legend(image, font, box, unit, scale);
    }
  }
  if (params.scale_bar) {
    draw_scale_bar(image, font, map.x + 0.4 * unit, map.y + map.height + 0.9 * unit, 0.32 * map.width, unit, pixel_m);
  }
  if (arrows != nullptr && params.legend)
    draw_arrow_key(image, font, map.x + map.width, map.y + map.height + 1.5 * unit, *arrows, unit);
  if (listed) draw_object_legend(image, font, layout.objects, shown, layout.object_legend, unit);
}

}  // namespace

Image map(const HeightField& terrain, const LabelMap* labels, const MapDrawings& drawings, const MapParams& params,
          const RunContext& run) {
  check_params(params);
  check_visible(terrain, labels, run);
  if (params.theme == MapTheme::regions && labels == nullptr) {
    throw IncompatibleInputs("labels: missing; the theme 'regions' colours a label map");
  }
  if (drawings.current != nullptr) check_same_size("current", drawings.current->frame(), terrain.frame());
  std::vector<ShownClass> shown;
  if (drawings.objects != nullptr) shown = shown_classes(*drawings.objects, terrain.frame());
  const Layout layout = lay_out(params, terrain.frame(), drawings.current != nullptr, shown);
  const Sheet sheet = make_sheet(terrain, drawings.lake, layout.map.width, params.min_sea_m2, run.part(0.0, 0.6));
  const HeightField& ground = sheet.ground;
  const HeightField shore_only = sheet.dry.empty() ? HeightField() : without_hollows(sheet);
  const HeightField& shore = sheet.dry.empty() ? ground : shore_only;
  const TintScale scale(sheet.lowest.sea_m, sheet.lowest.land_m, sheet.high);
  Image image(layout.width, layout.height, kPaperColour);
  std::optional<StyleTints> styled;
  if (params.theme == MapTheme::height && params.style != Style::natural) {
    styled.emplace(shore, scale, params.style, params.layers, run.part(0.6, 0.65));
  }
  const StyleTints* tints = styled ? &*styled : nullptr;
  paint_ground(image, layout, sheet, labels, params, scale, tints, run.part(0.65, 0.7));
  if (params.contours) {
    draw_contours(image, layout, sheet, shore, params, run);
  }
  run.report(0.9);
  const double line = std::max(0.8, layout.unit / 16.0);
  if (params.reef_crest && labels != nullptr) {
    LineLayer crest(ground.width(), ground.height());
    add_level(crest, inside_reef(*labels, ground.frame(), run.part(0.9, 0.95)), 0.5, line, run);
    crest.draw(image, layout.map.x, layout.map.y, Colour{252, 250, 240}, 0.85F);
  }
  if (params.coast) {
    LineLayer coast(ground.width(), ground.height());
    add_level(coast, shore, 0.0, line, run);
    if (!sheet.lakes.empty()) add_level(coast, sheet.lakes, 0.0, line, run);
    coast.draw(image, layout.map.x, layout.map.y, Colour{46, 74, 94}, 0.85F);
  }
  blank_unknown(image, layout, sheet.unknown);
  draw_drawings(image, layout.map, ground.frame(), drawings, layout.unit, run);
  if (!shown.empty()) {
    fit_symbols(shown, ground.cell_m(), map_pen(layout.unit), run.part(0.95, 0.97));
    draw_objects(image, layout.map, ground.frame(), shown, layout.unit, run);
  }
  std::optional<ArrowScale> arrows;
  if (drawings.current != nullptr) {
    arrows = arrow_scale(*drawings.current, params.arrow_spacing_px.value_or(layout.map.width / 40.0));
    draw_arrows(image, layout.map, *drawings.current, *arrows, layout.unit, run);
  }
  draw_furniture(image, layout, params, scale, tints, arrows ? &*arrows : nullptr, shown, ground.cell_m());
  run.report(1.0);
  return image;
}

}  // namespace seamount::render
