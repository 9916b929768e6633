// Runs a recipe: independent steps side by side, each step at most once and not at all if the cache has its result,
// then the outputs. Nothing is written before every step has succeeded.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "seamount/recipe/cache.h"
#include "seamount/recipe/recipe.h"
#include "seamount/recipe/run_outputs.h"

namespace seamount::recipe {

struct ExecuteOptions {
  std::string out_folder = "out";
  std::string cache_folder = Cache::default_folder();  ///< empty: no cache
};

struct StepReport {
  std::string id;
  std::string op;
  double seconds = 0.0;
  bool cached = false;
};

struct ExecuteReport {
  std::vector<StepReport> steps;
  std::vector<OutputReport> outputs;
};

/// Says the recipe's notes, runs the steps that the outputs need (all of them, if there are no outputs) and writes the
/// outputs. run.progress gets the fraction of the whole. Throws what operators and writers throw, with "step 'reef'
/// (island.coral): " before it.
ExecuteReport execute(const Recipe& recipe, const ExecuteOptions& options, const RunContext& run);

/// Runs the steps only and returns the value of "step.port" for each of `wanted`.
std::vector<Value> evaluate(const Recipe& recipe, const std::vector<Source>& wanted, const ExecuteOptions& options,
                            const RunContext& run, ExecuteReport* report = nullptr);

}  // namespace seamount::recipe
