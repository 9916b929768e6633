#include "seamount/ops/render/splat_layers.h"

#include <algorithm>

#include "seamount/base/text.h"
#include "seamount/geom/grid/resample.h"

namespace seamount::render {
namespace {

constexpr double kCellsOfSoftness = 4.0;
/// From a tenth to nine tenths of a blurred edge, in its deviations.
constexpr double kWidthOfDeviation = 2.563;

double deviation_of(std::optional<double> soft_m, double cell_m) {
  const double width_m = soft_m.value_or(kCellsOfSoftness * cell_m);
  if (!(width_m >= 0)) throw InvalidArgument("soft_m", format_number(width_m) + " is below 0");
  return width_m / kWidthOfDeviation;
}

/// Blurs are linear: what summed to one still does.
void soften(std::vector<GroundLayer>& layers, double deviation_m, const RunContext& run) {
  for (size_t i = 0; i < layers.size(); ++i) {
    const double step = 1.0 / static_cast<double>(layers.size()), begin = static_cast<double>(i) * step;
    geom::gaussian_blur(layers[i].weights, deviation_m, run.part(begin, begin + step));
    for (float& weight : layers[i].weights.cells()) weight = std::max(weight, 0.0F);
  }
}

/// Resampling overshoots at steps: back between 0 and 1, and to sums of one.
void normalise(std::vector<GroundLayer>& layers) {
  for (size_t i = 0; i < layers[0].weights.size(); ++i) {
    float sum = 0;
    for (GroundLayer& layer : layers)
      sum += layer.weights.cells()[i] = std::clamp(layer.weights.cells()[i], 0.0F, 1.0F);
    for (GroundLayer& layer : layers) layer.weights.cells()[i] /= sum;
  }
}

}  // namespace

std::vector<std::string> terrain_layer_names() { return {"low", "middle", "high", "seabed"}; }

std::vector<std::string> region_layer_names() {
  std::vector<std::string> names;
  names.reserve(kRegions.size());
  for (const Region region : kRegions) names.emplace_back(region_name(region));
  return names;
}

std::vector<GroundLayer> splat_layers(const HeightField& terrain, const LayersParams& params,
                                      std::optional<double> soft_m, const RunContext& run) {
  const double deviation_m = deviation_of(soft_m, terrain.frame().cell_m);
  geom::Layers made = layers(terrain, params, run.part(0.0, 0.5));
  Mask seabed(terrain.frame(), 0.0F);
  for (size_t i = 0; i < terrain.size(); ++i) {
    if (!(terrain.cells()[i] < 0.0F)) continue;
    seabed.cells()[i] = 1.0F;
    made.low.cells()[i] = made.middle.cells()[i] = made.high.cells()[i] = 0.0F;
  }
  std::vector<GroundLayer> all = {{"low", std::move(made.low)},
                                  {"middle", std::move(made.middle)},
                                  {"high", std::move(made.high)},
                                  {"seabed", std::move(seabed)}};
  soften(all, deviation_m, run.part(0.5, 1.0));
  return all;
}

std::vector<GroundLayer> splat_layers(const LabelMap& labels, const GridFrame& frame, std::optional<double> soft_m,
                                      const RunContext& run) {
  if (labels.empty()) throw InvalidArgument("labels", "there are no cells");
  const double deviation_m = deviation_of(soft_m, frame.cell_m);
  std::vector<GroundLayer> all;
  for (const Region region : kRegions) {
    run.check_cancelled();
    Mask share(labels.frame(), 0.0F);
    for (size_t i = 0; i < labels.size(); ++i) share.cells()[i] = labels.cells()[i] == region ? 1.0F : 0.0F;
    if (frame != labels.frame()) share = geom::resample(share, frame, run.part(0.0, 0.5));
    all.push_back({std::string(region_name(region)), std::move(share)});
  }
  if (frame != labels.frame()) normalise(all);
  soften(all, deviation_m, run.part(0.5, 1.0));
  return all;
}

}  // namespace seamount::render
