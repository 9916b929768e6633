#include "seamount/tiles/spread.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <mutex>
#include <utility>

#include "seamount/base/machine.h"
#include "seamount/base/parallel.h"

namespace seamount::tiles {
namespace {

/// Passes on fractions that grow, one at a time.
class Growing {
 public:
  explicit Growing(const RunContext& run) : run_(run) {}
  void report(double fraction) {
    const std::lock_guard lock(mutex_);
    if (fraction <= most_) return;
    most_ = fraction;
    run_.report(fraction);
  }

 private:
  const RunContext& run_;
  std::mutex mutex_;
  double most_ = 0.0;
};

class LowestFailure {
 public:
  void add(int64_t i, std::exception_ptr what) {
    const std::lock_guard lock(mutex_);
    if (i >= lowest_) return;
    lowest_ = i;
    what_ = std::move(what);
  }
  void rethrow() const {
    if (what_) std::rethrow_exception(what_);
  }

 private:
  std::mutex mutex_;
  int64_t lowest_ = std::numeric_limits<int64_t>::max();
  std::exception_ptr what_;
};

}  // namespace

int threads_of(const Ranks& ranks) {
  return std::clamp(machine_processors() / ranks.on_this_machine(), 1, thread_count({}));
}

int at_once(double bytes, double memory_bytes, const RunContext& run) {
  const double fit = bytes > 0 ? memory_bytes / bytes : 1.0;
  return static_cast<int>(std::clamp(fit, 1.0, static_cast<double>(thread_count(run))));
}

void spread(Ranks& ranks, const RunContext& run, int count, int pieces,
            const std::function<bool(int i, const RunContext& own)>& body) {
  const int64_t counter = ranks.new_counter();
  Growing progress(run);
  LowestFailure failure;
  RunContext own = run;
  own.progress = nullptr;
  const auto work = [&](int64_t, int64_t) {
    for (;;) {
      run.check_cancelled();
      const int64_t i = ranks.take(counter);
      if (i >= count) return;
      try {
        if (!body(static_cast<int>(i), own)) ranks.end(counter);
      } catch (...) {
        failure.add(i, std::current_exception());
        ranks.end(counter);
      }
      progress.report(static_cast<double>(i + 1) / count);
    }
  };
  parallel_blocks({run.threads, {}, run.cancelled, {}}, std::min(pieces, count), 1, work);
  failure.rethrow();
  wait_for_all(ranks);
}

}  // namespace seamount::tiles
