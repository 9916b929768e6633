#include "seamount/ops/hydrology/describe.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "seamount/geom/grid/resample.h"
#include "seamount/geom/water/flow.h"
#include "seamount/geom/water/inland.h"
#include "seamount/ops/hydrology/comparison.h"
#include "seamount/ops/hydrology/descriptors.h"
#include "seamount/ops/hydrology/mostly_sea.h"
#include "seamount/ops/hydrology/survey.h"

namespace seamount::hydrology {
namespace {

/// The terrain on cells of another size, its sea a level surface: surveys of land have none below. Unknown cells are
/// geom::kUnknownGround.
HeightField prepare(const HeightField& input, const GridFrame& frame, float sea_level_m,
                    const std::optional<double>& min_sea_m2, const RunContext& run) {
  HeightField terrain = geom::raise_inland(input, sea_level_m, min_sea_m2, run);
  geom::forget_unknown(terrain);
  for (float& z : terrain.cells()) z = z < sea_level_m ? sea_level_m : z;
  if (terrain.frame() != frame) terrain = geom::resample(terrain, frame, run);
  for (float& z : terrain.cells())
    if (std::isnan(z)) z = geom::kUnknownGround;
  return terrain;
}

Drawing draw_peaks(const std::vector<Peak>& peaks, const GridFrame& frame) {
  Drawing drawing;
  drawing.crs = frame.crs;
  drawing.heights = true;
  for (const Peak& peak : peaks) {
    const int column = peak.cell % frame.width, row = peak.cell / frame.width;
    drawing.points.push_back({{frame.x(column), frame.y(row)},
                              peak.height_m,
                              {{"prominence_m", peak.prominence_m}, {"isolation_m", peak.isolation_m}}});
  }
  return drawing;
}

}  // namespace

Described describe(const HeightField& terrain, const HeightField* reference, const DescribeParams& params,
                   const RunContext& run) {
  check_params(params);
  say_mostly_sea(terrain, params.sea, run);
  const float sea_level_m = params.sea ? 0.0F : geom::kNoSea;
  std::vector<const HeightField*> inputs{&terrain};
  if (reference != nullptr) inputs.push_back(reference);
  std::vector<GridFrame> frames;
  frames.reserve(inputs.size());
  for (const HeightField* input : inputs) frames.push_back(input->frame());
  const double cell_m = comparison_cell(frames, params.cell_m);
  for (GridFrame& frame : frames) frame = frame_at(frame, cell_m);
  std::vector<HeightField> terrains;
  for (size_t i = 0; i < inputs.size(); ++i)
    terrains.push_back(prepare(*inputs[i], frames[i], sea_level_m, params.min_sea_m2, run));
  const SurveyPlan plan =
      make_plan(terrains, sea_level_m, params.relief_window_m, params.channel_m2, params.min_prominence_m);
  std::vector<Survey> surveys;
  for (size_t i = 0; i < terrains.size(); ++i) {
    const double share = 1.0 / static_cast<double>(terrains.size()), from = static_cast<double>(i) * share;
    surveys.push_back(survey(terrains[i], plan, run.part(from, from + share)));
  }
  Described out{{}, draw_peaks(surveys.front().peaks, frames.front())};
  Report& report = out.report;
  report.title = "Terrain descriptors";
  report.subjects.push_back(params.title.empty() ? "terrain" : params.title);
  if (reference != nullptr)
    report.subjects.push_back(params.reference_title.empty() ? "reference" : params.reference_title);
  report.settings = make_settings(surveys, plan);
  report.descriptors = make_descriptors(surveys, plan);
  return out;
}

}  // namespace seamount::hydrology
