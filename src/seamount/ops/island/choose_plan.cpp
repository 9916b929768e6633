#include "seamount/ops/island/choose_plan.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "seamount/base/inputs.h"
#include "seamount/base/parallel.h"
#include "seamount/base/text.h"
#include "seamount/geom/grid/upsample_rows.h"
#include "seamount/geom/water/breach.h"

namespace seamount::island {

namespace {

Plan choose_plan(const BuildParams& p, const BuildInputs& inputs, const std::optional<CoastFile>& coast,
                 const GridFrame& domain, Seed seed, const RunContext& run) {
  const GivenWidths& widths = p.widths;
  std::vector<std::string> given;
  if (!p.coast.path.empty()) given.emplace_back("coast");
  if (!p.outlines.empty()) given.emplace_back("outlines");
  if (!p.areas.empty()) given.emplace_back("areas");
  if (inputs.outlines != nullptr) given.emplace_back("the input 'outlines'");
  if (inputs.labels != nullptr) given.emplace_back("the input 'labels'");
  refuse_several(given, "an island is built on one of them");
  if (inputs.labels != nullptr) return plan_from_labels(*inputs.labels, widths, run);
  if (inputs.outlines != nullptr) return plan_from_areas(*inputs.outlines, widths, "outlines");
  if (!p.outlines.empty()) return plan_from_polar(p.outlines, p.centre, widths);
  if (!p.areas.empty()) return plan_from_areas({{{"", p.areas}}, {}, {}}, widths, "areas");
  if (!coast) return random_plan(domain, p.centre, p.irregularity, seed, widths);
  if (const auto* painted = std::get_if<PaintedCoast>(&*coast)) return plan_from_labels(painted->labels, widths, run);
  return plan_from_areas(std::get<Drawing>(*coast), widths, "coast");
}

std::optional<CoastFile> read(const BuildParams& p, const BuildInputs& inputs) {
  if (p.coast.path.empty()) return {};
  if (!inputs.read_coast) throw InvalidArgument("coast", "is a file, and nothing was given to read it with");
  return inputs.read_coast(p.coast);
}

std::string rounded(double value, double per_unit) { return format_number(std::round(value * per_unit) / per_unit); }

/// Parameters that have no part in this island.
void say_ignored(const Plan& plan, const BuildParams& params, const RunContext& run) {
  if (plan.polar.empty() && !(params.centre == Vec2{}))
    run.say("centre is ignored: the coast lies where its coordinates put it");
  if (params.profile.knots.empty()) return;
  if (params.peak_m) run.say("peak_m is ignored: the profile says how high the summit is");
  if (params.floor_m) run.say("floor_m is ignored: the profile says how deep the sea floor is");
}

/// Those drawn join those of the parameters; a point without a height above the sea gets that of its lobe.
BuildParams with_summits(const BuildParams& params, const Drawing* drawn) {
  BuildParams all = params;
  if (drawn == nullptr) return all;
  if (drawn->points.empty()) throw InvalidArgument("summits", "holds no point");
  for (const ValuedPoint& point : drawn->points) {
    const auto height = point.value > 0 ? std::optional<double>(point.value) : std::nullopt;
    all.summits.push_back({point.place, height, {}});
  }
  return all;
}

/// Heights sink over the sea floor as far as a painting says.
void sink(const ScalarField& subsidence, HeightField& terrain, const RunContext& run) {
  const float floor = *std::min_element(terrain.cells().begin(), terrain.cells().end());
  const GridFrame& frame = terrain.frame();
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    geom::RowUpsampler rows(subsidence);
    std::vector<float> lambda(static_cast<size_t>(frame.width));
    for (int y = begin; y < end; ++y) {
      rows.read(frame.x(0), frame.cell_m, frame.y(y), lambda);
      const auto heights = terrain.row(y);
      for (size_t x = 0; x < lambda.size(); ++x) heights[x] -= std::clamp(lambda[x], 0.0F, 1.0F) * (heights[x] - floor);
    }
  });
  geom::breach_pits(terrain, 0.0F, {}, run);
  const auto most = *std::max_element(subsidence.cells().begin(), subsidence.cells().end());
  run.say("sunk as the painting's brightness says, by up to " + format_number(std::round(100 * most)) +
          " % of the height over the sea floor: island.coral with subsidence 0 grows its reef");
}

}  // namespace

Plan choose_plan(const BuildParams& params, const BuildInputs& inputs, const GridFrame& domain, Seed seed,
                 const RunContext& run) {
  return choose_plan(params, inputs, read(params, inputs), domain, seed, run);
}

Island build(const BuildInputs& inputs, const BuildParams& params, const GridFrame& domain, Seed seed,
             const RunContext& run) {
  const std::optional<CoastFile> coast = read(params, inputs);
  const Plan plan = choose_plan(params, inputs, coast, domain, seed, run);
  GridFrame frame = inputs.labels != nullptr ? inputs.labels->frame() : domain;
  if (!plan.crs.empty()) frame.crs = plan.crs;
  if (inputs.fit_domain && plan.polar.empty() && inputs.labels == nullptr) {
    const GridFrame fitted = frame_around(plan, frame);
    if (fitted != frame)
      run.say("the document does not say how large it is: laid around the island, " + rounded(fitted.width_m(), 1) +
              " x " + rounded(fitted.height_m(), 1) + " m in cells of " + rounded(fitted.cell_m, 100) + " m");
    frame = fitted;
  }
  say_ignored(plan, params, run);
  Island island = build(plan, with_summits(params, inputs.summits), frame, seed, run);
  const auto* painted = coast ? std::get_if<PaintedCoast>(&*coast) : nullptr;
  if (painted != nullptr && !painted->subsidence.empty()) sink(painted->subsidence, island.terrain, run);
  return island;
}

}  // namespace seamount::island
