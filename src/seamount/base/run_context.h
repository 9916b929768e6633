// What a caller gives to a running operator besides its inputs: threads, progress and cancellation. No globals: two
// operators may run side by side with different contexts.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "seamount/base/error.h"

namespace seamount {

struct RunContext {
  /// Threads that parallel loops may use. 0: as many as the machine has. Results never depend on it.
  int threads = 0;

  /// Called with the finished fraction in [0, 1], from any thread, never concurrently from one parallel loop. Optional.
  std::function<void(double)> progress;

  /// Set to true by anybody to stop the work soon. Optional; must outlive the call.
  const std::atomic<bool>* cancelled = nullptr;

  /// Called with one line that the user should know although the work goes on: a strength that had to be limited, say.
  /// Optional. The cache keeps it with the result of a step, and it is said again whenever that is used.
  std::function<void(const std::string&)> note;

  /// Throws Cancelled once the caller asked to stop. Cheap: call it for every row or block.
  void check_cancelled() const {
    if (cancelled != nullptr && cancelled->load(std::memory_order_relaxed)) throw Cancelled();
  }

  void report(double fraction) const {
    if (progress) progress(fraction);
  }

  void say(const std::string& line) const {
    if (note) note(line);
  }

  /// The context of one part of the work, whose own [0, 1] is [from, to] of the whole.
  RunContext part(double from, double to) const {
    RunContext sub = *this;
    if (progress) sub.progress = [whole = progress, from, to](double f) { whole(from + (to - from) * f); };
    return sub;
  }
};

}  // namespace seamount
