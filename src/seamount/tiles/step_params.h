// The parameters of a step, for the tiled ways of its operator.
#pragma once

#include "seamount/recipe/param_json.h"
#include "seamount/recipe/recipe.h"

namespace seamount::tiles {

/// REQUIRES: `Params` are those of the step's operator; a recipe's step was read, so they are complete and in range.
template <class Params>
Params step_params(const recipe::Step& step) {
  recipe::Diagnostics none;
  return recipe::read_params<Params>(step.params, {"", none});
}

}  // namespace seamount::tiles
