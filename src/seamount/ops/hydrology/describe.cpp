#include "seamount/ops/hydrology/describe.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "seamount/base/text.h"
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

/// Where no river is large enough for the usual fit.
void say_small_rivers(const Survey& one, const RunContext& run) {
  constexpr double kRiver = 1e6;
  if (one.has_land() && std::isfinite(one.channels.concavity) && one.channels.from_m2 < kRiver)
    run.say("no river drains 10 km2: concavity is that of streams from " +
            format_number(std::round(one.channels.from_m2)) + " m2 on");
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
  // One at a time, the terrain last: one prepared terrain is in memory, whether there is a reference or not.
  const auto prepared = [&](size_t i) { return prepare(*inputs[i], frames[i], sea_level_m, params.min_sea_m2, run); };
  std::vector<Land> lands(inputs.size());
  HeightField ground;
  for (size_t i = inputs.size(); i-- > 0;) {
    ground = {};
    ground = prepared(i);
    lands[i] = find_land(ground, sea_level_m);
  }
  const SurveyPlan plan =
      make_plan(lands, sea_level_m, params.relief_window_m, params.channel_m2, params.min_prominence_m);
  std::vector<Survey> surveys;
  for (size_t i = 0; i < inputs.size(); ++i) {
    const double share = 1.0 / static_cast<double>(inputs.size()), from = static_cast<double>(i) * share;
    if (i > 0) {
      ground = {};
      ground = prepared(i);
    }
    surveys.push_back(survey(ground, plan, run.part(from, from + share)));
  }
  for (const Survey& one : surveys) say_small_rivers(one, run);
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
