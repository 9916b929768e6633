// How long steps took when they were computed last, to tell what will be there in a moment.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "seamount/recipe/plan.h"
#include "seamount/recipe/scheduler.h"

namespace seamount::recipe {

class StepTimes {
 public:
  /// Remembers the steps of a plan that were computed, with the domain's cells.
  void learn(const Plan& plan, const Scheduler& scheduler);

  /// Seconds that the steps of a plan will take of which `ahead` says that something is to be done: as long as last
  /// time on as many cells. Nothing if one of them was never computed so.
  std::optional<double> expected(const Plan& plan, const std::vector<bool>& ahead) const;

 private:
  struct Took {
    std::string op;
    int64_t cells = 0;
    double seconds = 0.0;
  };
  std::map<std::string, Took> last_;  ///< by the step's id
};

}  // namespace seamount::recipe
