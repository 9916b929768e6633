// Tints of a map in a style: three layers by height, each a little lighter towards the top, beside the usual tints for
// what the style does not speak of (the land of a reef, the sea around mountains).
#pragma once

#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/grid/height_layers.h"
#include "seamount/model/grid.h"
#include "seamount/ops/render/map_furniture.h"
#include "seamount/ops/render/style.h"
#include "seamount/ops/render/tints.h"

namespace seamount::render {

class StyleTints {
 public:
  /// For the map of a ground, in a style other than natural. Keeps references to ground and scale.
  StyleTints(const HeightField& ground, const TintScale& scale, Style style, const LayerBorders& layers,
             const RunContext& run);

  /// Tint of a cell of the ground, linear light.
  Rgb tint(int x, int y) const;
  /// What the colours stand for, from the top down.
  std::vector<Swatch> legend() const;

 private:
  const HeightField& ground_;
  const TintScale& scale_;
  Style style_;
  geom::Layers layers_;
  std::array<Rgb, 3> bottom_, top_;
  float lowest_ = 0.0F, relief_ = 1.0F;
  bool everywhere_ = false;  ///< there is only land, or only sea
};

}  // namespace seamount::render
