#include "seamount/ops/island/choose_plan.h"

#include <cmath>

#include "seamount/base/inputs.h"
#include "seamount/base/text.h"

namespace seamount::island {

Plan choose_plan(const BuildParams& p, const BuildInputs& inputs, const GridFrame& domain, Seed seed,
                 const RunContext& run) {
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
  if (p.coast.path.empty()) return random_plan(domain, p.centre, p.irregularity, seed, widths);
  if (!inputs.read_coast) throw InvalidArgument("coast", "is a file, and nothing was given to read it with");
  const CoastFile coast = inputs.read_coast(p.coast);
  if (const auto* labels = std::get_if<LabelMap>(&coast)) return plan_from_labels(*labels, widths, run);
  return plan_from_areas(std::get<Drawing>(coast), widths, "coast");
}

namespace {

std::string rounded(double value, double per_unit) { return format_number(std::round(value * per_unit) / per_unit); }

/// Parameters that have no part in this island.
void say_ignored(const Plan& plan, const BuildParams& params, const RunContext& run) {
  if (plan.polar.empty() && !(params.centre == Vec2{}))
    run.say("centre is ignored: the coast lies where its coordinates put it");
  if (params.profile.knots.empty()) return;
  if (params.peak_m) run.say("peak_m is ignored: the profile says how high the summit is");
  if (params.floor_m) run.say("floor_m is ignored: the profile says how deep the sea floor is");
}

}  // namespace

Island build(const BuildInputs& inputs, const BuildParams& params, const GridFrame& domain, Seed seed,
             const RunContext& run) {
  const Plan plan = choose_plan(params, inputs, domain, seed, run);
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
  return build(plan, params, frame, seed, run);
}

}  // namespace seamount::island
