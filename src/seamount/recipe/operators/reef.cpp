// Registration of the reef family.
#include "seamount/ops/reef/grow.h"
#include "seamount/recipe/registry.h"

namespace seamount::recipe {
namespace {

Values grow(const reef::GrowParams& params, const Call& call) {
  const reef::GrowInputs in{call.in.at("terrain").heights(), call.labels("labels"), call.scalars("habitat"),
                            call.scalars("start"), call.shapes("drawing")};
  reef::Grown grown = reef::grow(in, params, call.seed, call.run);
  Drawing outlines = reef::reef_outlines(grown.aggregate, call.run);
  return {{"terrain", Value::terrain(std::move(grown.terrain))},
          {"aggregate", Value::field(std::move(grown.aggregate))},
          {"labels", Value::labels(std::move(grown.labels))},
          {"outlines", Value::drawing(std::move(outlines))}};
}

}  // namespace

void add_reef_operators(Registry& registry) {
  registry.add<reef::GrowParams>(
      {.name = "reef.grow",
       .summary = "Grows barrier reefs, ribbon reefs and patch reefs by diffusion-limited aggregation",
       .source = "P4 sec. 3.2-3.3, eq. 1 and 2",
       .stochastic = true,
       .in = {{"terrain", ValueKind::terrain, "heights in metres: the ground on which the reef grows"},
              {"labels", ValueKind::labels, "its regions; places without reef keep them", false},
              {"habitat", ValueKind::field, "particles settle only where it is at least 0.5", false},
              {"start", ValueKind::field, "random kernels lie where it is at least 0.5", false},
              {"drawing", ValueKind::drawing, "lines along which, and areas in which growth starts", false}},
       .out = {{"terrain", ValueKind::terrain, "heights in metres"},
               {"aggregate", ValueKind::field, "1 on the reef, 0 outside, soft at its edge"},
               {"labels", ValueKind::labels, "reef, the lagoon behind it, land by height, abyss: the open sea"},
               {"outlines", ValueKind::drawing, "the reef's outlines, as one area named reef"}}},
      grow);
}

}  // namespace seamount::recipe
