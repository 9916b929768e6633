// Computes the steps of plans in the background: each result once, whatever plans it belongs to, and not at all if
// memory or the disk has it. What no plan needs any more is stopped at once; what the next plan needs too goes on.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "seamount/recipe/plan_walk.h"
#include "seamount/recipe/value.h"

namespace seamount::recipe {

/// What is known of the result of a key.
struct StepProgress {
  enum class Stage { unknown, running, done, failed };
  Stage stage = Stage::unknown;
  double fraction = 0.0;           ///< of the running step
  double seconds = 0.0;            ///< that computing it, or reading it from the cache, took
  bool cached = false;             ///< it came from the cache on disk
  std::vector<std::string> notes;  ///< what the operator said, also when it came from a cache
  std::exception_ptr failure;      ///< with the step's name in its message
};

/// What became of a step that a plan needs.
struct StepReport {
  std::string id;
  std::string op;
  double seconds = 0.0;
  bool cached = false;             ///< its result, or all that follows from it, came from the cache
  std::vector<std::string> notes;  ///< what the operator said when the result was computed
};

struct SchedulerOptions {
  int threads = 0;            ///< as RunContext::threads
  std::string cache_folder;   ///< empty: no cache on disk
  uint64_t memory_bytes = 0;  ///< results that nothing needs at the moment are kept while all fit into this; 0: none
                              ///< is, nor outputs of a step that nobody reads
  /// Called after something has changed, from several threads, also at once, with no lock held.
  std::function<void()> changed = {};
  /// Called at once with what an operator says.
  std::function<void(const Step& step, const std::string& line)> note = {};
};

class Scheduler {
 public:
  explicit Scheduler(const SchedulerOptions& options);
  /// Stops everything and waits for it.
  ~Scheduler();
  Scheduler(const Scheduler&) = delete;
  Scheduler& operator=(const Scheduler&) = delete;

  /// From now on only these plans matter, the first one most: a plan is not begun before those ahead of it are settled.
  /// Running steps that none of them has are cancelled. Returns at once.
  void pursue(std::vector<std::shared_ptr<const Plan>> plans);

  /// Forgets failures, so that those steps are tried again if a plan needs them.
  void forget_failures();

  /// Waits until each target of each plan is done or can no longer be. False: `milliseconds` were over first.
  bool wait_for(int milliseconds) const;

  StepProgress progress(const Digest& key) const;
  /// The outputs of a key that are in memory.
  std::optional<Values> values(const Digest& key) const;

  Outcome outcome(const Plan& plan) const;
  /// The failure that keeps a plan from being done; the first in the plan's order.
  std::exception_ptr failure(const Plan& plan) const;
  /// Finished share of the steps that a plan needs.
  double fraction(const Plan& plan) const;
  /// For each step of a plan: is there still something to be done about it?
  std::vector<bool> ahead(const Plan& plan) const;
  /// The steps that a plan needs. REQUIRES: it is done.
  std::vector<StepReport> reports(const Plan& plan) const;
  uint64_t bytes_in_memory() const;

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace seamount::recipe
