// The order in which the steps of a recipe can run.
#pragma once

#include <string>
#include <vector>

#include "seamount/recipe/recipe.h"

namespace seamount::recipe {

struct StepOrder {
  std::vector<Step> steps;         ///< each after those that it reads from; without those that wait for a cycle
  std::vector<std::string> cycle;  ///< ids of steps of which each needs the one before; empty: there is none
};

/// Puts steps into an order; those that are in order already stay as they are. A source that names no step is waited
/// for in vain. Cost: quadratic in the number of steps.
StepOrder order_of(std::vector<Step> steps);

}  // namespace seamount::recipe
