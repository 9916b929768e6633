#include "seamount/recipe/output_water.h"

#include <algorithm>

#include "seamount/recipe/kinds.h"
#include "seamount/recipe/prepare_output.h"

namespace seamount::recipe {
namespace {

/// The step of `op` that works on the output's terrain.
Step finding_step(const Recipe& recipe, const Output& output, const std::string& op, const Json& params,
                  const ReadPlace& place) {
  Step step;
  step.op = recipe.registry->find_operator(op);
  step.id = output.path + op.substr(op.find('.'));
  step.output = output.path;
  step.params = step.op->complete(params, place);
  step.seed = recipe.seed;
  step.in["terrain"] = output.from;
  return step;
}

}  // namespace

std::vector<std::string> waters_of(const Registry& registry, const OutputFormat& format) {
  if (!format.prepare || !format.takes(kinds::Terrain::kind())) return {};
  Diagnostics ignored;
  const Json params = format.complete(Json::object(), {"", ignored});
  std::vector<std::string> waters;
  for (const Preparation& wanted : format.prepare(params, kinds::Terrain::kind(), "x")) {
    const Operator* op = registry.find_operator(wanted.op);
    if (op == nullptr || !wanted.name.empty()) continue;
    for (const char* name : {"rivers", "lake"})
      if (op->find_in(name) != nullptr) waters.emplace_back(name);
  }
  return waters;
}

OutputWater read_water(const Json& output, const std::vector<std::string>& waters, const ReadPlace& place,
                       const std::vector<DraftStep>& drafts) {
  OutputWater water;
  for (const std::string& name : waters) {
    const auto member = output.find(name);
    if (member == output.end()) continue;
    std::optional<Json>& found = name == "rivers" ? water.rivers : water.lake;
    if (member->is_boolean() || (member->is_object() && !member->contains("file"))) {
      if (member->is_object()) found = *member;
      if (*member == true) found = Json::object();
      continue;
    }
    const Kind* kind = name == "rivers" ? &kinds::Drawing::kind() : &kinds::Field::kind();
    if (const auto source = read_source(*member, place.at(name), {{kind}, name}, drafts)) water.given[name] = *source;
  }
  const bool draws_lake = std::find(waters.begin(), waters.end(), "lake") != waters.end();
  if (water.rivers && draws_lake && !output.contains("lake")) water.lake = Json::object();
  return water;
}

std::map<std::string, Source> add_water(Recipe& recipe, const Output& output, const OutputWater& water,
                                        const ReadPlace& place) {
  std::map<std::string, Source> drawn = water.given;
  std::string lakes;
  if (water.lake) {
    lakes = add_once(recipe.steps, finding_step(recipe, output, "hydrology.lakes", *water.lake, place.at("lake")));
    drawn["lake"] = {lakes, "lake", ""};
  }
  if (water.rivers) {
    Step rivers = finding_step(recipe, output, "hydrology.rivers", *water.rivers, place.at("rivers"));
    if (!lakes.empty()) rivers.in["sinks"] = {lakes, "sinks", ""};
    drawn["rivers"] = {add_once(recipe.steps, std::move(rivers)), "rivers", ""};
  }
  return drawn;
}

}  // namespace seamount::recipe
