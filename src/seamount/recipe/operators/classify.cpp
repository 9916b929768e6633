// Registration of the classify family.
#include "seamount/ops/classify/follow.h"
#include "seamount/ops/classify/paint.h"
#include "seamount/ops/classify/terrain.h"
#include "seamount/recipe/ports.h"

namespace seamount::recipe {

void add_classify_operators(Registry& registry) {
  registry.add(make_operator<classify::TerrainParams>(
      {.name = "classify.terrain",
       .revision = 4,
       .summary =
           "Labels any terrain by depth, slope and exposure, so that it can enter the methods that build on labels",
       .source = "P0 sec. 1.4.1 for the regions"},
      inputs(in<kinds::Terrain>("terrain", "heights in metres about sea level")),
      outputs(out<kinds::Labels>("labels", "mountain, beach, lagoon, reef, abyss"),
              out<kinds::Field>("exposure", "openness to the sea, 0 to 1; 0 on land")),
      [](const classify::TerrainParams& params, const Call& call, const HeightField& terrain) {
        classify::Classified made = classify::terrain(terrain, params, call.run);
        return std::tuple(std::move(made.labels), std::move(made.exposure));
      }));
  registry.add(make_operator<classify::FollowParams>(
      {.name = "classify.follow", .summary = "Labels of a terrain that any steps have changed, from those before"},
      inputs(in<kinds::Terrain>("terrain", "heights in metres, as they are now"),
             in<kinds::Terrain>("before", "the terrain that the labels belong to"),
             in<kinds::Labels>("labels", "its regions before")),
      outputs(out<kinds::Labels>("labels", "land is beach or mountain, sea lagoon, reef or abyss")),
      [](const classify::FollowParams& params, const Call& call, const HeightField& terrain, const HeightField& before,
         const LabelMap& labels) { return classify::follow(terrain, before, labels, params, call.run); }));
  registry.add(make_operator<classify::PaintParams>(
      {.name = "classify.paint",
       .summary =
           "Regions of an island painted with a pen, over those of a label map or from nothing, and its subsidence",
       .source = "P0 sec. 1.7 for what may be painted",
       .looks = "at its own place"},
      inputs(optional_in<kinds::Labels>("labels", "what is painted on; `base` everywhere if open"),
             optional_in<kinds::Field>("subsidence", "how far the ground has sunk before, 0 to 1; 0 if open"),
             with_voids(optional_in<kinds::Terrain>("terrain", "where the map is to lie; its heights do not count"))),
      outputs(out<kinds::Labels>("labels", "mountain, beach, lagoon, reef, abyss"),
              out<kinds::Field>("subsidence", "how far the ground has sunk, 0 to 1")),
      [](const classify::PaintParams& params, const Call& call, const LabelMap* labels, const ScalarField* subsidence,
         const HeightField* terrain) {
        const GridFrame& frame = labels != nullptr       ? labels->frame()
                                 : subsidence != nullptr ? subsidence->frame()
                                 : terrain != nullptr    ? terrain->frame()
                                                         : call.domain;
        classify::Painted made = classify::paint(frame, labels, subsidence, params, call.run, call.whole);
        return std::tuple(std::move(made.labels), std::move(made.subsidence));
      },
      [](const classify::PaintParams&, double) { return Reach::place(); }));
}

}  // namespace seamount::recipe
