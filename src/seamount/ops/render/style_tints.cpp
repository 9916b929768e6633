#include "seamount/ops/render/style_tints.h"

#include <algorithm>

namespace seamount::render {

StyleTints::StyleTints(const HeightField& ground, const TintScale& scale, Style style, const LayerBorders& layers,
                       const RunContext& run)
    : ground_(ground),
      scale_(scale),
      style_(style),
      layers_(geom::height_layers(ground, style_borders(style, layers, ground), layers.smooth, layers.variation, run)),
      everywhere_(!scale.has_sea() || !scale.has_land()) {
  const auto [low, high] = std::minmax_element(ground.cells().begin(), ground.cells().end());
  lowest_ = everywhere_ ? *low : 0.0F;
  relief_ = std::max(1.0F, *high - lowest_);
  const std::array<StyleLayer, 3>& colours = style_layers(style);
  for (size_t i = 0; i < 3; ++i) {
    bottom_[i] = linear(colours[i].bottom);
    top_[i] = linear(colours[i].top);
  }
}

Rgb StyleTints::tint(int x, int y) const {
  const float height = ground_(x, y);
  const bool reef = style_ == Style::great_barrier_reef;
  if (!everywhere_ && reef != (height < 0.0F)) return scale_.tint(height);
  // The sea's depths go by the logarithm, as on the usual scale.
  const float place =
      reef && !everywhere_ ? static_cast<float>(2.0 * scale_.bar_place(height)) : clamp01((height - lowest_) / relief_);
  const float low = layers_.low(x, y), high = layers_.high(x, y);
  return low * mix(bottom_[0], top_[0], place) + layers_.middle(x, y) * mix(bottom_[1], top_[1], place) +
         high * mix(bottom_[2], top_[2], place);
}

std::vector<Swatch> StyleTints::legend() const {
  std::vector<Swatch> swatches;
  const auto usual = [&](std::string_view name, float height) {
    swatches.push_back({name, srgb(scale_.tint(height))});
  };
  const bool reef = style_ == Style::great_barrier_reef;
  if (!everywhere_ && reef) usual("land", 0.2F * relief_);
  const std::array<StyleLayer, 3>& colours = style_layers(style_);
  for (size_t i = 3; i-- > 0;) swatches.push_back({colours[i].name, srgb(mix(bottom_[i], top_[i], 0.5F))});
  if (!everywhere_ && !reef) usual("sea", -60.0F);
  return swatches;
}

}  // namespace seamount::render
