// A terrain made ready for drawing: heights over the water, slopes, light and labels as mip maps, read at any place and
// scale. Shared by perspective pictures and mesh textures.
#pragma once

#include <optional>

#include "seamount/model/areas.h"
#include "seamount/model/grid.h"
#include "seamount/model/label_map.h"
#include "seamount/model/layer_borders.h"
#include "seamount/ops/render/ground_cover.h"
#include "seamount/ops/render/light.h"
#include "seamount/ops/render/materials.h"
#include "seamount/ops/render/mip_map.h"
#include "seamount/ops/render/sky.h"
#include "seamount/ops/render/unknown.h"

namespace seamount::render {

/// Form of the ground at a place.
struct FormTexel {
  float height = 0.0F;              ///< metres over the water, exaggerated
  float east = 0.0F, south = 0.0F;  ///< rise towards east and south, exaggerated
  float sun = 1.0F;                 ///< lit share of the sun
  friend FormTexel operator+(FormTexel a, FormTexel b) {
    return {a.height + b.height, a.east + b.east, a.south + b.south, a.sun + b.sun};
  }
  friend FormTexel operator*(float s, FormTexel a) { return {s * a.height, s * a.east, s * a.south, s * a.sun}; }
};

/// Shares of a style's layers.
struct LayerTexel {
  float low = 0.0F, high = 0.0F, lava = 0.0F;
  friend LayerTexel operator+(LayerTexel a, LayerTexel b) { return {a.low + b.low, a.high + b.high, a.lava + b.lava}; }
  friend LayerTexel operator*(float s, LayerTexel a) { return {s * a.low, s * a.high, s * a.lava}; }
};

struct GroundOptions {
  double water_level_m = 0.0;
  double exaggeration = 1.0;
  SunDirection sun;
  int limit = 2048;  ///< cells of the larger side to keep
  Style style = Style::natural;
  LayerBorders layers;                ///< of a style other than natural; heights over the water
  const ScalarField* lake = nullptr;  ///< metres of standing water over the terrain; may be null
  const Drawing* rivers = nullptr;    ///< of shown.h
  std::optional<double> min_sea_m2;   ///< of geom/water/inland.h
  double wind_from = 0.0;             ///< of the wind that brings rain, radians clockwise from north
};

/// A place on the ground with all that shading needs.
struct GroundSample {
  FormTexel form;
  CoverTexel cover;
  SurfacePoint point;
};

class Ground {
 public:
  /// Lakes are part of the surface. With the water at 0 m, ground below it that is no sea is dry.
  /// Throws InvalidArgument for an empty terrain or heights that are infinite, IncompatibleInputs for labels
  /// or a lake of another size. Unknown cells (NaN) are blank ground. About 60 ns a cell of the kept size.
  Ground(const HeightField& terrain, const LabelMap* labels, const GroundOptions& options, const RunContext& run);

  const HeightField& heights() const { return heights_; }  ///< over the water, exaggerated, at least 2 x 2 cells
  bool has_dry() const { return !dry_.empty(); }
  /// Whether the ground there is no sea floor though it lies lower than the water. False outside the terrain.
  bool is_dry(float x, float y) const;
  float exaggeration() const { return exaggeration_; }
  float cell_m() const { return static_cast<float>(heights_.cell_m()); }
  /// Fractional column and row of a place in metres from the terrain's middle (x east, y north).
  float column(float x) const { return x / cell_m() + half_columns_; }
  float row(float y) const { return half_rows_ - y / cell_m(); }
  float half_width_m() const { return half_columns_ * cell_m(); }  ///< to the outermost centres
  float half_height_m() const { return half_rows_ * cell_m(); }

  /// Everything at a place, averaged over `footprint` metres.
  GroundSample sample(float x, float y, float footprint) const;
  FormTexel form(float x, float y, float footprint) const;
  /// Normal of a sample with the small bumps of its material, as far as they are larger than the footprint.
  Vec3 normal(const GroundSample& sample, float bump) const;

 private:
  Ground(Filled filled, const HeightField& terrain, const LabelMap* labels, const GroundOptions& options,
         const RunContext& run);
  bool is_unknown(float x, float y) const;

  Grid<uint8_t> unknown_;  ///< empty: all is known
  ScalarField depth_;      ///< of lakes as depth_around_lakes(), on the grid of heights_; empty: none
  Mask dry_;               ///< on the grid of heights_; empty: none
  HeightField heights_;
  MipMap<float> lake_;
  MipMap<float> river_;
  MipMap<FormTexel> form_;
  MipMap<CoverTexel> cover_;
  MipMap<LayerTexel> layers_;  ///< of styles other than natural
  float half_columns_, half_rows_, cover_scale_, exaggeration_;
  bool has_lakes_, has_rivers_, labelled_, layered_;
};

/// Whether a terrain lies in the sea: most of its border is under water. Unknown cells do not count.
bool lies_in_sea(const HeightField& terrain, double water_level_m);

/// The setting that a climate asks for; without water nothing lies in a sea.
Setting setting_of(const HeightField& terrain, double water_level_m, bool water);

/// Throws InvalidArgument unless the terrain has cells and no height is infinite, IncompatibleInputs unless the labels
/// (may be null) have its size.
void check_visible(const HeightField& terrain, const LabelMap* labels, const RunContext& run);

}  // namespace seamount::render
