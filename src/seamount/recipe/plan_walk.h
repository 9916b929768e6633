// What there is still to do for a plan, by what is known of its results. Not safe for threads: the scheduler holds its
// lock.
#pragma once

#include <exception>
#include <optional>
#include <utility>
#include <vector>

#include "seamount/recipe/plan.h"
#include "seamount/recipe/result_store.h"

namespace seamount::recipe {

/// How it stands with what a plan is for. failed: some of it cannot be, and nothing is left to do.
enum class Outcome { waiting, done, failed };

/// One look over what a plan needs, from its targets up, as far as results are missing.
class PlanWalk {
 public:
  PlanWalk(const Plan& plan, ResultStore& results);

  Outcome outcome() const { return outcome_; }

  /// A step that can be worked on now.
  struct Next {
    size_t index = 0;
    bool compute = false;  ///< its inputs are there; if not, the disk may have its result
  };
  const std::optional<Next>& next() const { return next_; }

  /// The first failure that was met.
  const std::exception_ptr& failure() const { return failure_; }

 private:
  Outcome visit(size_t index);
  Outcome look(size_t index);
  Outcome offer(size_t index, bool compute);
  Outcome fail(const std::exception_ptr& why);

  const Plan& plan_;
  ResultStore& results_;
  std::vector<std::optional<Outcome>> seen_;
  Outcome outcome_ = Outcome::done;
  std::optional<Next> next_;
  std::exception_ptr failure_;
};

/// Calls visit(key, result) for what a plan's targets rest on: results that are not there, and the first ones above
/// them that are.
template <class Visit>
void for_each_open_end(const Plan& plan, const ResultStore& results, Visit visit) {
  std::vector<bool> seen(plan.steps.size());
  std::vector<size_t> ahead = plan.targets;
  while (!ahead.empty()) {
    const size_t index = ahead.back();
    ahead.pop_back();
    if (seen[index]) continue;
    seen[index] = true;
    const PlannedStep& planned = plan.steps[index];
    if (planned.defect) continue;
    const Result* result = results.find(planned.key);
    visit(planned, result);
    if (result == nullptr || !result->values) ahead.insert(ahead.end(), planned.reads.begin(), planned.reads.end());
  }
}

}  // namespace seamount::recipe
