#include "seamount/recipe/step_times.h"

namespace seamount::recipe {

void StepTimes::learn(const Plan& plan, const Scheduler& scheduler) {
  for (size_t i = 0; i < plan.steps.size(); ++i) {
    if (!plan.steps[i].needed) continue;
    const StepProgress progress = scheduler.progress(plan.steps[i].key);
    if (progress.stage != StepProgress::Stage::done || progress.cached) continue;
    const Step& step = plan.recipe->steps[i];
    last_[step.id] = {step.op->name, plan.recipe->domain.cells(), progress.seconds};
  }
}

std::optional<double> StepTimes::expected(const Plan& plan, const std::vector<bool>& ahead) const {
  double seconds = 0.0;
  for (size_t i = 0; i < plan.steps.size(); ++i) {
    if (!ahead[i]) continue;
    const Step& step = plan.recipe->steps[i];
    const auto took = last_.find(step.id);
    if (took == last_.end() || took->second.op != step.op->name || took->second.cells != plan.recipe->domain.cells())
      return std::nullopt;
    seconds += took->second.seconds;
  }
  return seconds;
}

}  // namespace seamount::recipe
