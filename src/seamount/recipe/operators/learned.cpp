// Registration of the learned family.
#include <algorithm>
#include <memory>

#include "seamount/geom/grid/painted_labels.h"
#include "seamount/io/image_file.h"
#include "seamount/ops/island/wind.h"
#include "seamount/ops/learned/erode.h"
#include "seamount/ops/learned/island.h"
#include "seamount/ops/learned/sketch.h"
#include "seamount/recipe/draw_again.h"
#include "seamount/recipe/loaded_networks.h"
#include "seamount/recipe/ports.h"

namespace seamount::recipe {
namespace {

using kinds::Drawing, kinds::Field, kinds::Terrain;

/// The network of a model. Says in what numbers it is evaluated where that is slower than need be.
std::shared_ptr<const learned::Network> network_of(const ModelFile& model, learned::Precision precision,
                                                   const Call& call) {
  std::shared_ptr<const learned::Network> network = loaded_network(call.resolve(model), precision);
  if (network->precision() == learned::Precision::f32 && precision == learned::Precision::automatic)
    call.run.say("this processor has no bf16: the network is evaluated in f32, which takes twice as long");
  return network;
}

HeightField sketch(const learned::SketchParams& params, const Call& call, const seamount::Drawing* lines,
                   const Image* image, const ScalarField* river, const ScalarField* ridge, const ScalarField* levelset,
                   const HeightField* terrain, const ScalarField* erase) {
  GridFrame frame = call.domain;
  for (const ScalarField* grid : {terrain, river, ridge, levelset, erase}) {
    if (grid == nullptr) continue;
    frame = grid->frame();
    break;
  }
  const auto network = network_of(params.model, params.precision, call);
  return learned::sketch({lines, image, river, ridge, levelset, terrain, erase, draw_again}, params, *network, frame,
                         call.seed, call.run);
}

/// Regions and subsidence as the strokes bend them.
void bend(const std::vector<Stroke>& strokes, LabelMap& labels, ScalarField& subsidence, const Call& call) {
  island::WindParams wind;
  wind.strokes = strokes;
  island::Warped warped = island::wind(subsidence, &labels, nullptr, wind, call.seed, call.run);
  labels = std::move(warped.labels);
  subsidence = std::move(warped.terrain);
  for (float& share : subsidence.cells()) share = std::clamp(share, 0.0F, 1.0F);  // cubics overshoot
}

HeightField island(const learned::IslandParams& params, const Call& call, const LabelMap* labels,
                   const ScalarField* subsidence) {
  const bool bends = !params.strokes.empty();
  learned::IslandMap map;
  if ((labels == nullptr) == params.painting.path.empty())
    throw InvalidArgument(labels == nullptr ? "labels" : "painting",
                          "a map of regions is needed, as the input labels or as a painting, and not both");
  LabelMap regions;  // empty: the shares are known better
  if (labels != nullptr) {
    map.frame = labels->frame();
    regions = *labels;
    map.subsidence = ScalarField(map.frame, static_cast<float>(params.subsidence));
  } else {
    map.frame = call.domain;
    geom::PaintedLabels read = geom::decode_labels(io::read_image(call.resolve(params.painting)), map.frame, call.run);
    map.shares = learned::without_specks(read.shares, call.run);
    map.subsidence = std::move(read.subsidence_per_cell);
    if (bends) regions = std::move(read.labels);
  }
  if (subsidence != nullptr) map.subsidence = *subsidence;
  if (bends) bend(params.strokes, regions, map.subsidence, call);
  if (!regions.empty()) map.shares = learned::shares_of(regions, call.run);
  const double width_m = std::max(map.frame.width_m(), map.frame.height_m());
  map.scale = params.scale.value_or(std::clamp(width_m / learned::kIslandWidth_m, 0.02, 1.0));
  map.peak_m = params.peak_m;
  map.floor_m = params.floor_m;
  map.reef_depth_m = params.reef_depth_m;
  return learned::island(map, *network_of(params.model, params.precision, call), call.seed, call.run);
}

HeightField erode(const learned::ErodeParams& params, const Call& call, const HeightField& terrain,
                  const ScalarField* mask) {
  return learned::erode(terrain, mask, params, *network_of(params.model, params.precision, call), call.run);
}

}  // namespace

void add_learned_operators(Registry& registry) {
  registry.add(make_operator<learned::SketchParams>(
      {.name = "learned.sketch",
       .revision = 5,
       .summary = "Terrain from a sketch of ridges, rivers, heights, high ground and known ground in any mix, by a "
                  "network",
       .source = "P1 sec. 4 to 6.1, 6.3",
       .stochastic = true},
      inputs(optional_in<Drawing>("lines",
                                  "lines of value 0 (river) or 1 (ridge), points with heights, areas of high ground"),
             optional_in<kinds::Image>("image", "a painted sketch over the domain: ridges red, rivers blue"),
             optional_in<Field>("river", "above 0.5 on rivers"), optional_in<Field>("ridge", "above 0.5 on ridges"),
             with_voids(optional_in<Field>("levelset", "1 on high ground, 0 on low, unknown where nothing is said")),
             with_voids(optional_in<Terrain>("terrain", "known ground, which stays; unknown cells are made")),
             optional_in<Field>("erase", "above 0.5 where known ground is made anew")),
      outputs(out<Terrain>("terrain", "heights in metres")), sketch));
  registry.add(make_operator<learned::IslandParams>(
      {.name = "learned.island",
       .revision = 3,
       .summary = "Island terrain from a map of its regions, painted or made, by a network",
       .source = "P0 sec. 1.5 to 1.7",
       .stochastic = true},
      inputs(optional_in<kinds::Labels>("labels", "regions"),
             optional_in<Field>("subsidence", "how far the ground has sunk, 0 to 1")),
      outputs(out<Terrain>("terrain", "heights in metres")), island));
  registry.add(make_operator<learned::ErodeParams>(
      {.name = "learned.erode",
       .revision = 3,
       .summary = "Years of rivers, slides and creep in a moment, by a network that learned from erosion.run (early "
                  "weights)",
       .source = "ours; the simulation is erosion.run"},
      inputs(in<Terrain>("terrain", "heights in metres"),
             optional_in<Field>("mask", "share of the change that is kept: 0 nothing, 1 all; everywhere if absent")),
      outputs(out<Terrain>("terrain", "heights in metres")), erode));
}

}  // namespace seamount::recipe
