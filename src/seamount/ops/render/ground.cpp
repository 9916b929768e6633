#include "seamount/ops/render/ground.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/geom/water/flat_sea.h"
#include "seamount/model/same_size.h"
#include "seamount/ops/render/detail_noise.h"
#include "seamount/ops/render/lava.h"
#include "seamount/ops/render/river_cover.h"
#include "seamount/ops/render/standing_water.h"
#include "seamount/ops/render/style.h"

namespace seamount::render {
namespace {

/// Single rows and columns are doubled so that there is a surface.
Grid<float> padded(Grid<float> values) {
  if (values.width() >= 2 && values.height() >= 2) return values;
  GridFrame frame = values.frame();
  frame.width = std::max(2, frame.width);
  frame.height = std::max(2, frame.height);
  Grid<float> result(frame);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) result(x, y) = values.clamped(x, y);
  }
  return result;
}

/// On the grid of the heights that are drawn.
Grid<float> drawn_cover(const Grid<float>& values, const GroundOptions& options, const RunContext& run) {
  return values.empty() ? values : padded(reduce(values, options.limit, run));
}

Mask drawn_dry(const HeightField& terrain, const GroundOptions& options, const RunContext& run) {
  if (options.water_level_m != 0.0) return {};
  return drawn_cover(dry_below_sea(terrain, options.min_sea_m2, run), options, run);
}

/// Heights over the water, with the surfaces of lakes, exaggerated, reduced.
HeightField drawn_heights(const HeightField& terrain, const ScalarField& lakes, const GroundOptions& options,
                          const RunContext& run) {
  HeightField heights = reduce(terrain, options.limit, run);
  if (options.water_level_m == 0.0) {
    const Grid<uint8_t> sea = geom::flat_sea(heights, run);
    if (!sea.empty()) geom::sink_flat_sea(heights, sea, run);
  }
  heights = padded(std::move(heights));
  if (!lakes.empty()) raise_to_lakes(heights, lakes);
  parallel_rows(run, heights.width(), heights.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (float& h : heights.row(y)) {
        h = static_cast<float>((h - options.water_level_m) * options.exaggeration);
      }
    }
  });
  return heights;
}

Grid<FormTexel> form_texels(const HeightField& heights, const Mask& dry, const SunDirection& sun,
                            const RunContext& run) {
  // Shadows fall on the water as on the land, so the sea is level for the sun.
  HeightField surface = heights;
  parallel_rows(run, surface.width(), surface.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < surface.width(); ++x)
        if (dry.empty() || dry(x, y) < 0.5F) surface(x, y) = std::max(surface(x, y), 0.0F);
    }
  });
  const Grid<float> lit = sun_visibility(surface, sun, 0.012, run);
  Grid<FormTexel> texels(heights.frame());
  const auto half = static_cast<float>(0.5 / heights.cell_m());
  parallel_rows(run, heights.width(), heights.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const int north = std::max(0, y - 1), south = std::min(heights.height() - 1, y + 1);
      const float down = south - north == 2 ? half : 2.0F * half;
      for (int x = 0; x < heights.width(); ++x) {
        const int west = std::max(0, x - 1), east = std::min(heights.width() - 1, x + 1);
        const float across = east - west == 2 ? half : 2.0F * half;
        texels(x, y) = {heights(x, y), across * (heights(east, y) - heights(west, y)),
                        down * (heights(x, south) - heights(x, north)), lit(x, y)};
      }
    }
  });
  return texels;
}

Grid<LayerTexel> layer_texels(const HeightField& heights, const GroundOptions& options, const RunContext& run) {
  HeightField level = heights;
  const auto flatten = static_cast<float>(1.0 / options.exaggeration);
  for (float& h : level.cells()) h *= flatten;
  run.check_cancelled();
  const geom::Borders borders = style_borders(options.style, options.layers, level);
  const geom::Layers layers = geom::height_layers(level, borders, options.layers.smooth, options.layers.variation, run);
  Grid<LayerTexel> texels(heights.frame());
  for (size_t i = 0; i < texels.size(); ++i) {
    texels.cells()[i] = {layers.low.cells()[i], layers.high.cells()[i], 0.0F};
  }
  run.check_cancelled();
  if (options.style == Style::volcano) {
    const Mask lava = lava_streams(level, layers.high, borders, run);
    for (size_t i = 0; i < texels.size(); ++i) texels.cells()[i].lava = lava.cells()[i];
  }
  return texels;
}

}  // namespace

bool lies_in_sea(const HeightField& terrain, double water_level_m) {
  int64_t wet = 0, dry = 0;
  const auto count = [&](int x, int y) {
    const double h = terrain(x, y);
    if (h <= water_level_m) ++wet;
    if (h > water_level_m) ++dry;
  };
  for (int x = 0; x < terrain.width(); ++x) {
    count(x, 0);
    count(x, terrain.height() - 1);
  }
  for (int y = 0; y < terrain.height(); ++y) {
    count(0, y);
    count(terrain.width() - 1, y);
  }
  return wet > dry;
}

Setting setting_of(const HeightField& terrain, double water_level_m, bool water) {
  float lowest = std::numeric_limits<float>::infinity();
  for (const float h : terrain.cells()) lowest = std::min(lowest, h);  // NaN is no less
  return {water && lies_in_sea(terrain, water_level_m),
          std::isfinite(lowest) ? static_cast<double>(lowest) - water_level_m : 0.0};
}

void check_visible(const HeightField& terrain, const LabelMap* labels, const RunContext& run) {
  if (terrain.empty()) throw InvalidArgument("terrain", "has no cells");
  if (labels != nullptr) check_same_size("labels", labels->frame(), terrain.frame());
  parallel_rows(run, terrain.width(), terrain.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      bool finite = true;
      for (const float h : terrain.row(y)) finite = finite && !std::isinf(h);
      if (!finite) throw InvalidArgument("terrain", "row " + std::to_string(y) + " has a height that is no number");
    }
  });
}

Ground::Ground(const HeightField& terrain, const LabelMap* labels, const GroundOptions& options, const RunContext& run)
    : Ground(fill_unknown(terrain, run), terrain, labels, options, run) {}

Ground::Ground(Filled filled, const HeightField& terrain, const LabelMap* labels, const GroundOptions& options,
               const RunContext& run)
    : unknown_(std::move(filled.unknown)),
      depth_((check_visible(terrain, labels, run),
              drawn_cover(depth_around_lakes(terrain, options.lake, run), options, run))),
      dry_(drawn_dry(terrain, options, run)),
      heights_(drawn_heights(filled.terrain.empty() ? terrain : filled.terrain, depth_, options, run)),
      form_(form_texels(heights_, dry_, options.sun, run), run),
      cover_(ground_cover(heights_, dry_, labels, options.exaggeration, options.wind_from, run), run),
      half_columns_(0.5F * static_cast<float>(heights_.width() - 1)),
      half_rows_(0.5F * static_cast<float>(heights_.height() - 1)),
      cover_scale_(static_cast<float>(heights_.cell_m() / cover_.base().cell_m())),
      exaggeration_(static_cast<float>(options.exaggeration)),
      has_lakes_(!depth_.empty()),
      has_rivers_(options.rivers != nullptr && !options.rivers->lines.empty()),
      labelled_(labels != nullptr),
      layered_(options.style != Style::natural) {
  if (!depth_.empty()) lake_ = MipMap<float>(std::move(depth_), run);
  if (has_rivers_) river_ = MipMap<float>(river_cover(*options.rivers, heights_.frame(), run), run);
  if (layered_) layers_ = MipMap<LayerTexel>(layer_texels(heights_, options, run), run);
}

bool Ground::is_unknown(float x, float y) const {
  if (unknown_.empty()) return false;
  const auto cell = static_cast<float>(unknown_.cell_m());
  const float column = x / cell + 0.5F * static_cast<float>(unknown_.width() - 1);
  const float row = 0.5F * static_cast<float>(unknown_.height() - 1) - y / cell;
  return unknown_.clamped(static_cast<int>(std::lround(column)), static_cast<int>(std::lround(row))) != 0;
}

bool Ground::is_dry(float x, float y) const {
  if (dry_.empty()) return false;
  const float c = column(x), r = row(y);
  if (!(c >= 0.0F && r >= 0.0F && c <= static_cast<float>(dry_.width() - 1) &&
        r <= static_cast<float>(dry_.height() - 1)))
    return false;
  return dry_(static_cast<int>(std::lround(c)), static_cast<int>(std::lround(r))) >= 0.5F;
}

FormTexel Ground::form(float x, float y, float footprint) const {
  return form_.sample(column(x), row(y), std::log2(std::max(1e-3F, footprint / cell_m())));
}

GroundSample Ground::sample(float x, float y, float footprint) const {
  const float c = column(x), r = row(y);
  const float lod = std::log2(std::max(1e-3F, footprint / cell_m()));
  GroundSample s;
  s.form = form_.sample(c, r, lod);
  const float scale = cover_scale_;
  s.cover = cover_.sample((c + 0.5F) * scale - 0.5F, (r + 0.5F) * scale - 0.5F, lod + std::log2(scale));
  SurfacePoint& p = s.point;
  p.x = x;
  p.y = y;
  p.z = s.form.height / exaggeration_;
  p.slope = std::sqrt(s.form.east * s.form.east + s.form.south * s.form.south) / exaggeration_;
  p.northness = s.form.south / exaggeration_;
  p.concavity = s.cover.concavity;
  p.wet = s.cover.wet;
  p.rain = s.cover.rain;
  // What lies around is lower on ribs and higher in gullies, at a few times the scale that is looked at.
  const float around = 4.0F * std::max(footprint, cell_m());
  p.rib = (s.form.height - form(x, y, around).height) / (exaggeration_ * around);
  p.shore_m = s.cover.shore_m;
  p.footprint = footprint;
  p.unknown = is_unknown(x, y);
  if (has_lakes_) p.lake = lake_.sample(c, r, lod);
  if (has_rivers_) p.river = river_.sample(c, r, lod);
  constexpr float kDry_m = 5.0F;  // above the wash of waves
  if (p.z < kDry_m && (p.lake > 0.0F || is_dry(x, y))) p.z = kDry_m;
  p.labelled = labelled_ ? 1.0F : 0.0F;
  p.beach = s.cover.beach;
  p.lagoon = s.cover.lagoon;
  p.reef = s.cover.reef;
  if (layered_) {
    const LayerTexel layers = layers_.sample(c, r, lod);
    p.low = layers.low;
    p.high = layers.high;
    p.lava = layers.lava;
  }
  return s;
}

Vec3 Ground::normal(const GroundSample& sample, float bump) const {
  // The grid carries forms down to about two cells; smaller ones are noise of the material's height.
  const SurfacePoint& p = sample.point;
  const float rough = std::min(1.0F, 0.18F + p.slope);
  const NoiseSample broken = detail_noise(91, p.x, p.y, 2.5F * cell_m(), 4, 0.5F, p.footprint);
  const NoiseSample grain = detail_noise(93, p.x, p.y, 9.0F, 6, 0.55F, p.footprint);
  const float amplitude = 0.11F * cell_m() * rough * std::min(1.0F, bump);
  return normalised({-sample.form.east - amplitude * broken.dx - bump * grain.dx,
                     sample.form.south - amplitude * broken.dy - bump * grain.dy, 1.0F});
}

}  // namespace seamount::render
