#include "seamount/io/vector_layers.h"

#include <algorithm>
#include <optional>

#include "seamount/base/text.h"

namespace seamount::io {
namespace {

/// Layers that write_drawing() makes are read together.
bool is_ours(const std::vector<OGRLayer*>& layers) {
  return layers.size() > 1 && std::all_of(layers.begin(), layers.end(), [](OGRLayer* layer) {
           const std::string name = layer->GetName();
           return name == "areas" || name == "lines" || name == "points";
         });
}

void add_shapes(const OGRGeometry& geometry, LayerShapes& shapes, int depth = 0) {
  constexpr int kDeepest = 16;
  if (geometry.IsEmpty() != 0 || depth > kDeepest) return;
  const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
  if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection) != 0) {
    for (const OGRGeometry* part : *geometry.toGeometryCollection()) add_shapes(*part, shapes, depth + 1);
  } else if (OGR_GT_IsSurface(type) != 0) {
    shapes.areas = true;
  } else if (OGR_GT_IsCurve(type) != 0) {
    shapes.lines = true;
  } else {
    shapes.points = true;
  }
}

/// How well a layer serves, 0 the best; nothing if it does not.
std::optional<int> fit(const LayerShapes& shapes, WantedShapes wanted) {
  if (!shapes.any()) return std::nullopt;
  if (!shapes.areas && !shapes.lines) return wanted == WantedShapes::any ? std::optional(2) : std::nullopt;
  if (wanted == WantedShapes::areas) return shapes.areas ? 0 : 1;
  if (wanted == WantedShapes::lines) return shapes.lines ? 0 : 1;
  return 0;
}

std::string joined(const std::vector<std::string>& names) {
  constexpr size_t kMost = 12;
  std::string text;
  for (size_t i = 0; i < std::min(kMost, names.size()); ++i) text += (i == 0 ? "" : ", ") + names[i];
  return names.size() > kMost ? text + ", ..." : text;
}

}  // namespace

LayerShapes shapes_in(OGRLayer& layer) {
  constexpr int kMost = 1000;
  LayerShapes shapes;
  layer.ResetReading();
  for (int i = 0; i < kMost; ++i) {
    const OGRFeatureUniquePtr feature{layer.GetNextFeature()};
    if (!feature) break;
    if (const OGRGeometry* geometry = feature->GetGeometryRef()) add_shapes(*geometry, shapes);
  }
  layer.ResetReading();
  return shapes;
}

std::vector<OGRLayer*> layers_of(GDALDataset& dataset) {
  std::vector<OGRLayer*> layers;
  for (int i = 0; i < dataset.GetLayerCount(); ++i)
    if (OGRLayer* layer = dataset.GetLayer(i)) layers.push_back(layer);
  return layers;
}

std::vector<OGRLayer*> choose_layers(GDALDataset& dataset, const VectorOptions& options, const GdalCall& call,
                                     const RunContext& run) {
  const std::vector<OGRLayer*> layers = layers_of(dataset);
  if (options.layer.empty() && is_ours(layers)) return layers;
  std::vector<std::string> names;
  for (OGRLayer* layer : layers) {
    names.emplace_back(layer->GetName());
    if (!options.layer.empty() && names.back() == options.layer) return {layer};
  }
  if (!options.layer.empty()) call.fail("has no layer '" + options.layer + "'" + suggestion(options.layer, names));
  std::optional<size_t> best;
  std::optional<int> best_fit;
  bool points = false;
  for (size_t i = 0; i < layers.size(); ++i) {
    run.check_cancelled();
    const LayerShapes shapes = shapes_in(*layers[i]);
    points = points || shapes.points;
    const std::optional<int> own = fit(shapes, options.wanted);
    if (own && (!best_fit || *own < *best_fit)) best = i, best_fit = own;
  }
  run.check_cancelled();
  call.check("is damaged");
  if (!best) {
    call.fail(!points                                 ? "has no areas, lines or points in it"
              : options.wanted == WantedShapes::areas ? "has no areas in it, only points"
                                                      : "has no lines in it, only points");
  }
  if (layers.size() > 1) {
    const std::string taken = names[*best];
    names.erase(names.begin() + static_cast<std::ptrdiff_t>(*best));
    run.say(call.path() + ": of its layers '" + taken + "' is read; 'layer' names another (" + joined(names) + ")");
  }
  return {layers[*best]};
}

}  // namespace seamount::io
