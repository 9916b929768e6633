#include "seamount/recipe/plan_walk.h"

namespace seamount::recipe {
namespace {

/// Waiting outweighs failed: something can still be done.
Outcome worse(Outcome a, Outcome b) {
  if (a == Outcome::waiting || b == Outcome::waiting) return Outcome::waiting;
  return a == Outcome::failed || b == Outcome::failed ? Outcome::failed : Outcome::done;
}

}  // namespace

PlanWalk::PlanWalk(const Plan& plan, ResultStore& results) : plan_(plan), results_(results), seen_(plan.steps.size()) {
  for (const size_t target : plan.targets) outcome_ = worse(outcome_, visit(target));
}

Outcome PlanWalk::visit(size_t index) {
  if (!seen_[index]) seen_[index] = look(index);
  return *seen_[index];
}

Outcome PlanWalk::look(size_t index) {
  const PlannedStep& planned = plan_.steps[index];
  if (planned.defect) return fail(planned.defect);
  const Result& result = results_.at(planned.key);
  if (result.values) return Outcome::done;
  if (result.failure) return fail(result.failure);
  if (result.running) return Outcome::waiting;
  if (!result.not_on_disk) return offer(index, false);
  Outcome inputs = Outcome::done;
  for (const size_t from : planned.reads) inputs = worse(inputs, visit(from));
  return inputs == Outcome::done ? offer(index, true) : inputs;
}

Outcome PlanWalk::offer(size_t index, bool compute) {
  if (!next_) next_ = {index, compute};
  return Outcome::waiting;
}

Outcome PlanWalk::fail(const std::exception_ptr& why) {
  if (!failure_) failure_ = why;
  return Outcome::failed;
}

}  // namespace seamount::recipe
