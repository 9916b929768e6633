#include "seamount/ops/ecosystem/labels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/base/text.h"
#include "seamount/geom/skeleton/skeleton_index.h"
#include "seamount/ops/ecosystem/environment.h"

namespace seamount::ecosystem {
namespace {

/// What covers what, the first on top.
constexpr std::array<Region, 4> kOrder = {Region::mountain, Region::beach, Region::reef, Region::lagoon};

constexpr Region region_of(LabelChoice choice) { return static_cast<Region>(static_cast<int>(choice) - 1); }

/// Objects of one region and one breadth.
struct Layer {
  Region region;
  double width_m;
  std::vector<Skeleton> skeletons;
};

std::vector<Layer> layers_of(const Scene& scene, int window) {
  std::vector<Layer> layers;
  for (const Region region : kOrder) {
    for (size_t c = 0; c < scene.catalogue.classes.size(); ++c) {
      const LabelEffect& label = scene.catalogue.classes[c].label;
      if (label.region == LabelChoice::none || region_of(label.region) != region) continue;
      Layer layer{region, label.width_m, {}};
      for (const SceneObject& object : scene.objects)
        if (object.of_class == static_cast<int>(c) && seen_from(scene, object, window))
          layer.skeletons.push_back(object.skeleton);
      if (!layer.skeletons.empty()) layers.push_back(std::move(layer));
    }
  }
  return layers;
}

void paint(const Layer& layer, LabelMap& labels, const RunContext& run) {
  const std::vector<int32_t> owners(layer.skeletons.size(), 0);
  const geom::SkeletonIndex index(layer.skeletons, owners);
  const GridFrame& frame = labels.frame();
  // Half the breadth to each side of points and curves, the whole beyond outlines.
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    std::vector<Vec2> places(static_cast<size_t>(frame.width));
    std::vector<geom::NearestSkeleton> nearest(places.size());
    RunContext serial;
    serial.threads = 1;
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < frame.width; ++x) places[static_cast<size_t>(x)] = {frame.x(x), frame.y(y)};
      index.nearest(places, {}, nearest, serial);
      for (int x = 0; x < frame.width; ++x) {
        const geom::NearestSkeleton& hit = nearest[static_cast<size_t>(x)];
        const bool region = layer.skeletons[0].kind == SkeletonKind::region;
        if (hit.inside || hit.distance <= (region ? layer.width_m : 0.5 * layer.width_m)) labels(x, y) = layer.region;
      }
    }
  });
}

}  // namespace

LabelMap labels(const Scene& scene, const LabelsParams& params, const RunContext& run) {
  check_params(params);
  LabelMap made(frame_of(scene, params.window), Region::abyss);
  std::vector<Layer> layers = layers_of(scene, params.window);
  for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) paint(*layer, made, run);
  return made;
}

}  // namespace seamount::ecosystem
