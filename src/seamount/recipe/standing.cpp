#include "seamount/recipe/standing.h"

namespace seamount::recipe {
namespace {

std::string message_of(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace

StepState state_of(const Plan& plan, size_t index, const StepProgress& progress, bool ahead, bool paused) {
  const Step& step = plan.recipe->steps[index];
  const PlannedStep& planned = plan.steps[index];
  StepState state{.id = step.id, .op = step.op->name};
  if (planned.defect) {
    state.standing = !step.incomplete.empty()     ? Standing::incomplete
                     : planned.defect_of == index ? Standing::failed
                                                  : Standing::blocked;
    state.message = step.incomplete.empty() ? message_of(planned.defect) : step.incomplete;
    return state;
  }
  state.fraction = progress.fraction;
  state.seconds = progress.seconds;
  state.cached = progress.cached;
  state.notes = progress.notes;
  using Stage = StepProgress::Stage;
  if (progress.stage == Stage::failed) {
    state.standing = Standing::failed;
    state.message = message_of(progress.failure);
  } else if (progress.stage == Stage::done) {
    state.standing = Standing::fresh;
  } else if (progress.stage == Stage::running) {
    state.standing = Standing::running;
  } else if (planned.needed && !ahead) {  // all that follows from it is there
    state.standing = Standing::fresh;
    state.cached = true;
  } else {
    state.standing = planned.needed && !paused ? Standing::queued : Standing::stale;
  }
  return state;
}

}  // namespace seamount::recipe
