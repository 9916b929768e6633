// Registration of the erosion family.
#include "seamount/ops/erosion/balance.h"
#include "seamount/ops/erosion/run.h"
#include "seamount/recipe/registry.h"

namespace seamount::recipe {
namespace {

ScalarField copy_of(const Call& call, std::string_view port) {
  const ScalarField* given = call.scalars(port);
  return given == nullptr ? ScalarField() : *given;
}

Values run(const erosion::RunParams& params, const Call& call) {
  erosion::Ground ground{call.in.at("terrain").heights(), copy_of(call, "rock"), copy_of(call, "sediment")};
  erosion::Site site{copy_of(call, "hardness"), copy_of(call, "mask"), copy_of(call, "uplift"), copy_of(call, "rain")};
  erosion::Eroded made = erosion::run(std::move(ground), std::move(site), params, call.seed, call.run);
  Report balance = erosion::balance_report(
      {call.in.at("terrain").heights(), call.scalars("rock"), call.scalars("sediment")}, made, params, call.run);
  return {{"terrain", Value::terrain(std::move(made.terrain))}, {"rock", Value::field(std::move(made.rock))},
          {"sediment", Value::field(std::move(made.sediment))}, {"flow", Value::field(std::move(made.flow))},
          {"lake", Value::field(std::move(made.lake))},         {"balance", Value::report(std::move(balance))}};
}

}  // namespace

void add_erosion_operators(Registry& registry) {
  registry.add<erosion::RunParams>(
      {.name = "erosion.run",
       .revision = 4,
       .summary =
           "Years of rivers, slides, creep and waves on bedrock, rock and sediment; or a range that rises and wears",
       .source = "P1 sec. 5.4; Braun and Willett 2013, Yuan et al. 2019, Tarboton 1997, Musgrave et al. 1989",
       .stochastic = true,
       .in = {{"terrain", ValueKind::terrain, "heights in metres"},
              {"hardness", ValueKind::field, "how many times as hard as `erodibility` says; 1 if absent", false},
              {"mask", ValueKind::field, "where erosion acts: 0 nowhere, 1 fully", false},
              {"uplift", ValueKind::field, "share of `uplift_mm`; 1 if absent", false},
              {"rain", ValueKind::field, "share of `rain_m`, as wet and dry sides of mountains; 1 if absent", false},
              {"rock", ValueKind::field, "thickness of debris on the bedrock in metres; 0 if absent", false},
              {"sediment", ValueKind::field, "thickness of fine sediment in metres; 0 if absent", false}},
       .out = {{"terrain", ValueKind::terrain, "heights in metres"},
               {"rock", ValueKind::field, "thickness of debris in metres"},
               {"sediment", ValueKind::field, "thickness of fine sediment in metres"},
               {"flow", ValueKind::field, "discharge in m3 per year"},
               {"lake", ValueKind::field, "depth of standing water on land in metres"},
               {"balance", ValueKind::report,
                "volumes in m3: bedrock worn, laid down on land and under water, left over "
                "the border; and the error"}}},
      run);
}

}  // namespace seamount::recipe
