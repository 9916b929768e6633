#include "seamount/recipe/engine_view.h"

#include <algorithm>

#include "seamount/recipe/bypass.h"

namespace seamount::recipe {

std::map<Source, Source> find_sources(const Recipe& recipe, const std::vector<Source>& wanted) {
  std::map<Source, Source> found;
  for (const Source& source : wanted) {
    const auto of_step = [&](const Step& step) { return step.id == source.step; };
    const auto bypassed = std::find_if(recipe.bypassed.begin(), recipe.bypassed.end(), of_step);
    if (bypassed != recipe.bypassed.end() && bypassed->op->find_out(source.port) == nullptr) continue;
    const auto followed = follow(recipe.bypassed, source);
    if (!followed || followed->from_file()) continue;
    const auto step = std::find_if(recipe.steps.begin(), recipe.steps.end(),
                                   [&](const Step& candidate) { return candidate.id == followed->step; });
    if (step != recipe.steps.end() && step->op->find_out(followed->port) != nullptr) found[source] = *followed;
  }
  return found;
}

}  // namespace seamount::recipe
