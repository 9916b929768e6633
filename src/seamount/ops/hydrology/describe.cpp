#include "seamount/ops/hydrology/describe.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "seamount/geom/flow.h"
#include "seamount/geom/resample.h"
#include "seamount/ops/hydrology/descriptors.h"
#include "seamount/ops/hydrology/survey.h"

namespace seamount::hydrology {
namespace {

/// The terrain on cells of another size, its sea a level surface: surveys of land have none below.
HeightField prepare(HeightField terrain, double cell_m, float sea_level_m, const RunContext& run) {
  for (float& z : terrain.cells()) z = std::max(z, sea_level_m);
  GridFrame frame = terrain.frame();
  if (std::abs(frame.cell_m / cell_m - 1.0) < 1e-9) return terrain;
  frame.width = std::max(1, static_cast<int>(std::lround(frame.width_m() / cell_m)));
  frame.height = std::max(1, static_cast<int>(std::lround(terrain.frame().height_m() / cell_m)));
  frame.cell_m = cell_m;
  return geom::resample(terrain, frame, run);
}

float sea_level(const DescribeParams& params) { return params.sea ? 0.0F : geom::kNoSea; }

SurveyPlan make_plan(const std::vector<HeightField>& terrains, const DescribeParams& params) {
  constexpr double kChannelPart = 2000.0, kProminencePart = 50.0;
  SurveyPlan plan;
  plan.sea_level_m = sea_level(params);
  plan.relief_window_m = params.relief_window_m;
  double smallest = std::numeric_limits<double>::infinity();
  for (const HeightField& terrain : terrains)
    smallest = std::min(smallest, terrain.frame().width_m() * terrain.frame().height_m());
  plan.channel_m2 = params.channel_m2.value_or(smallest / kChannelPart);
  const Land land = find_land(terrains.back(), plan.sea_level_m);
  const double relief = static_cast<double>(land.high_m) - static_cast<double>(land.low_m);
  plan.min_prominence_m = params.min_prominence_m.value_or(std::max(1e-3, relief / kProminencePart));
  return plan;
}

}  // namespace

Report describe(const HeightField& terrain, const HeightField* reference, const DescribeParams& params,
                const RunContext& run) {
  check_params(params);
  const double coarser = std::max(terrain.cell_m(), reference == nullptr ? 0.0 : reference->cell_m());
  const double cell_m = params.cell_m.value_or(coarser);
  std::vector<HeightField> terrains{prepare(terrain, cell_m, sea_level(params), run)};
  if (reference != nullptr) terrains.push_back(prepare(*reference, cell_m, sea_level(params), run));
  const SurveyPlan plan = make_plan(terrains, params);
  std::vector<Survey> surveys;
  for (size_t i = 0; i < terrains.size(); ++i) {
    const double share = 1.0 / static_cast<double>(terrains.size()), from = static_cast<double>(i) * share;
    surveys.push_back(survey(terrains[i], plan, run.part(from, from + share)));
  }
  Report report;
  report.title = "Terrain descriptors";
  report.subjects.push_back(params.title.empty() ? "terrain" : params.title);
  if (reference != nullptr)
    report.subjects.push_back(params.reference_title.empty() ? "reference" : params.reference_title);
  report.descriptors = make_descriptors(surveys, plan);
  return report;
}

}  // namespace seamount::hydrology
