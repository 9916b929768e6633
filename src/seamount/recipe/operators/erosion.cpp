// Registration of the erosion family.
#include "seamount/geom/water/follow_labels.h"
#include "seamount/model/same_size.h"
#include "seamount/ops/erosion/balance.h"
#include "seamount/ops/erosion/refine.h"
#include "seamount/ops/erosion/run.h"
#include "seamount/recipe/ports.h"

namespace seamount::recipe {
namespace {

using kinds::Field, kinds::Labels;
using Parts =
    std::tuple<HeightField, ScalarField, ScalarField, ScalarField, ScalarField, ScalarField, LabelMap, Report>;

Parts run(const erosion::RunParams& params, const Call& call, const HeightField& terrain, const ScalarField* hardness,
          const ScalarField* mask, const ScalarField* uplift, const ScalarField* rain, const ScalarField* debris,
          const ScalarField* sediment, const LabelMap* labels) {
  if (labels != nullptr) check_same_size("labels", labels->frame(), terrain.frame());
  const auto copy_of = [](const ScalarField* given) { return given == nullptr ? ScalarField() : *given; };
  erosion::Layers ground{terrain, copy_of(debris), copy_of(sediment)};
  erosion::Maps site{copy_of(hardness), copy_of(mask), copy_of(uplift), copy_of(rain)};
  erosion::Eroded made = erosion::run(std::move(ground), std::move(site), params, call.seed, call.run);
  Report balance = erosion::balance_report({terrain, debris, sediment}, made, params, call.run);
  const auto sea_m = static_cast<float>(params.sea_m);
  RunContext quiet = call.run;  // the run itself has said what is sea
  quiet.note = {};
  LabelMap regions = labels == nullptr ? geom::plain_labels(made.terrain, sea_m, quiet)
                                       : geom::follow_labels(*labels, terrain, made.terrain, sea_m, quiet);
  return {std::move(made.terrain), std::move(made.debris), std::move(made.sediment), std::move(made.flow),
          std::move(made.lake),    std::move(made.bed),    std::move(regions),       std::move(balance)};
}

}  // namespace

void add_erosion_operators(Registry& registry) {
  registry.add(make_operator<erosion::RunParams>(
      {.name = "erosion.run",
       .revision = 13,
       .summary =
           "Years of rivers, slides, creep and waves on bedrock, debris and sediment; or a range that rises and wears",
       .source = "P1 sec. 5.4; Braun and Willett 2013, Yuan et al. 2019, Tarboton 1997, Musgrave et al. 1989",
       .stochastic = true},
      inputs(
          in<kinds::Terrain>("terrain", "heights in metres"),
          optional_in<Field>("hardness",
                             "how many times as hard as `erodibility` says, 0.1 and more; 1 if absent. A mask or "
                             "picture from 0 to 1 makes rock from 1 to 10 times as hard"),
          optional_in<Field>("mask",
                             "share of the change that is kept: 0 nothing, 1 all; over a hard edge it fades as "
                             "gently as its depth asks for"),
          optional_in<Field>("uplift", "share of `uplift_mm_yr`; 1 if absent"),
          optional_in<Field>("rain", "share of `runoff_mm_yr`, as wet and dry sides of mountains; 1 if absent"),
          formerly("rock", optional_in<Field>("debris", "thickness of debris on the bedrock in metres; 0 if absent")),
          optional_in<Field>("sediment", "thickness of fine sediment in metres; 0 if absent"),
          optional_in<Labels>("labels", "its regions, which follow the new coast")),
      outputs(out<kinds::Terrain>("terrain", "heights in metres"),
              formerly("rock", out<Field>("debris", "thickness of debris in metres")),
              out<Field>("sediment", "thickness of fine sediment in metres"),
              out<Field>("flow", "discharge in m3 per year"),
              out<Field>("lake", "depth of standing water on land in metres"),
              out<Field>("bed", "number of the bed at the top of the bedrock, from 1 for the first; 0 without beds"),
              out<Labels>("labels",
                          "its regions: land is beach or mountain, sea lagoon, reef or abyss; mountain and abyss if no "
                          "labels were given"),
              out<kinds::Report>("balance",
                                 "volumes in m3: bedrock worn, laid down on land and under water, left over "
                                 "the border; and the error")),
      run));
  registry.add(make_operator<erosion::RefineParams>(
      {.name = "erosion.refine",
       .summary = "The erosion of a coarse terrain carried on to smaller cells: valleys of the one, gullies and detail "
                  "of the other, however large",
       .source = "Braun and Willett 2013, Leopold and Maddock 1953",
       .stochastic = true,
       .looks = "some times gather_cells around; at the coarse rasters as wholes"},
      inputs(in<kinds::Terrain>("terrain", "heights in metres on the small cells, as they were before"),
             placed(Placing::system, in<kinds::Terrain>("before", "the same on the large cells: terrain.resample")),
             placed(Placing::system, in<kinds::Terrain>("worn", "that terrain, eroded: erosion.run")),
             placed(Placing::system, in<Field>("flow", "its discharge in m3 per year: erosion.run")),
             placed(Placing::system, optional_in<Field>("sediment",
                                                        "thickness of what was laid down, which buries detail: "
                                                        "erosion.run"))),
      outputs(out<kinds::Terrain>("terrain", "heights in metres")),
      [](const erosion::RefineParams& params, const Call& call, const HeightField& terrain, const HeightField& before,
         const HeightField& worn, const ScalarField& flow, const ScalarField* sediment) {
        return erosion::refine(terrain, {before, worn, flow, sediment}, params, call.seed, call.run);
      },
      erosion::refine_reach));
}

}  // namespace seamount::recipe
