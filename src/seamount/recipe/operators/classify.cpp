// Registration of the classify family.
#include "seamount/ops/classify/terrain.h"

#include "seamount/recipe/registry.h"

namespace seamount::recipe {
namespace {

Values terrain(const classify::TerrainParams& params, const Call& call) {
  classify::Classified made = classify::terrain(call.in.at("terrain").heights(), params, call.run);
  return {{"labels", Value::labels(std::move(made.labels))}, {"exposure", Value::field(std::move(made.exposure))}};
}

}  // namespace

void add_classify_operators(Registry& registry) {
  registry.add<classify::TerrainParams>(
      {.name = "classify.terrain",
       .revision = 2,
       .summary =
           "Labels any terrain by depth, slope and exposure, so that it can enter the methods that build on labels",
       .source = "P0 sec. 1.4.1 for the regions",
       .in = {{"terrain", ValueKind::terrain, "heights in metres about sea level"}},
       .out = {{"labels", ValueKind::labels, "mountain, beach, lagoon, reef, abyss"},
               {"exposure", ValueKind::field, "openness to the sea, 0 to 1; 0 on land"}}},
      terrain);
}

}  // namespace seamount::recipe
