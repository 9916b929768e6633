#include "seamount/ops/island/choose_plan.h"

#include "seamount/base/inputs.h"

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

Island build(const BuildInputs& inputs, const BuildParams& params, const GridFrame& domain, Seed seed,
             const RunContext& run) {
  const Plan plan = choose_plan(params, inputs, domain, seed, run);
  GridFrame frame = inputs.labels != nullptr ? inputs.labels->frame() : domain;
  if (!plan.crs.empty()) frame.crs = plan.crs;
  return build(plan, params, frame, seed, run);
}

}  // namespace seamount::island
