// Runs a recipe: independent steps side by side, each step at most once and not at all if the cache has its result or
// one that follows from it, then the outputs. Nothing is written before every step has succeeded.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "seamount/recipe/cache.h"
#include "seamount/recipe/run_outputs.h"
#include "seamount/recipe/scheduler.h"

namespace seamount::recipe {

struct ExecuteOptions {
  std::string out_folder = "out";
  std::string cache_folder = Cache::default_folder();  ///< empty: no cache
};

struct ExecuteReport {
  std::vector<StepReport> steps;
  std::vector<OutputReport> outputs;
};

/// Says the recipe's notes, runs the steps that the outputs need (all of them, if there are no outputs) and writes the
/// outputs. run.progress gets the fraction of the whole, run.note what operators say, with "step 'reef': " before it,
/// also for a step that was cached. Throws what operators and writers throw, with "step 'reef' (island.coral): " before
/// it; other steps are then stopped.
ExecuteReport execute(const Recipe& recipe, const ExecuteOptions& options, const RunContext& run);

/// Runs the steps only and returns the value of "step.port" for each of `wanted`.
std::vector<Value> evaluate(const Recipe& recipe, const std::vector<Source>& wanted, const ExecuteOptions& options,
                            const RunContext& run, ExecuteReport* report = nullptr);

/// What the outputs of a recipe are made from.
std::vector<Source> output_sources(const Recipe& recipe);

/// The second half of execute(): writes the outputs from values that are there, one for each of output_sources().
std::vector<OutputReport> write_outputs_from(const Recipe& recipe, const std::string& out_folder,
                                             const std::map<Source, Value>& values, const RunContext& run);

}  // namespace seamount::recipe
