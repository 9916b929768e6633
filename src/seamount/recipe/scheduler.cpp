#include "seamount/recipe/scheduler.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>

#include "seamount/base/background.h"
#include "seamount/base/parallel.h"
#include "seamount/recipe/cache.h"
#include "seamount/recipe/plan_walk.h"
#include "seamount/recipe/step_work.h"

namespace seamount::recipe {
namespace {

/// More steps than this at once would only take more memory: each has parallel loops of its own.
constexpr int kMostSteps = 16;
/// More than these are written to disk before the next step begins.
constexpr size_t kMostUnsaved = 32;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// A step's progress is told at most so often: telling takes time from computing.
constexpr std::chrono::milliseconds kProgressEvery{50};

/// A result that the disk does not have yet.
struct Unsaved {
  Digest key;
  Values values;
  std::vector<std::string> notes;
};

/// A step of a plan that a thread takes on: first it asks the disk, later it computes.
struct Job {
  std::shared_ptr<const Plan> plan;
  size_t index = 0;
  bool compute = false;

  const Step& step() const { return plan->recipe->steps[index]; }
  const PlannedStep& planned() const { return plan->steps[index]; }
};

}  // namespace

class Scheduler::Work {
 public:
  explicit Work(const SchedulerOptions& options)
      : options_(options),
        cache_(options.cache_folder),
        results_(options.memory_bytes),
        arena_(std::max(1, std::min(thread_count({.threads = options.threads}), thread_count({})))),
        crew_(std::min(arena_.max_concurrency(), kMostSteps), [this] { work(); }) {}

  ~Work() {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    plans_.clear();
    for (auto& [key, result] : results_.all()) result.cancelled = true;
    wake_.notify_all();
  }
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  void pursue(std::vector<std::shared_ptr<const Plan>> plans) {
    const std::lock_guard lock(mutex_);
    Keys keys;
    for (const auto& plan : plans) {
      for (const PlannedStep& planned : plan->steps) {
        if (!planned.defect && planned.needed) keys.insert(planned.key);
      }
    }
    for (auto& [key, result] : results_.all()) {
      if (result.running && !keys.contains(key)) result.cancelled = true;
    }
    plans_ = std::move(plans);
    for (const auto& plan : plans_) {
      for (const PlannedStep& planned : plan->steps) {
        if (!planned.defect) keys.insert(planned.key);
      }
    }
    results_.forget_all_but(keys);
    tidy();
  }

  void forget_failures() {
    const std::lock_guard lock(mutex_);
    results_.forget_failures();
    wake_.notify_all();
  }

  bool wait_for(int milliseconds) {
    std::unique_lock lock(mutex_);
    return wake_.wait_for(lock, std::chrono::milliseconds(milliseconds), [&] {
      return std::all_of(plans_.begin(), plans_.end(),
                         [&](const auto& plan) { return PlanWalk(*plan, results_).outcome() != Outcome::waiting; });
    });
  }

  StepProgress progress(const Digest& key) {
    const std::lock_guard lock(mutex_);
    StepProgress progress;
    const Result* result = results_.find(key);
    if (result == nullptr) return progress;
    using Stage = StepProgress::Stage;
    progress.stage = result->failure                                ? Stage::failed
                     : result->done                                 ? Stage::done
                     : result->running && !result->cancelled.load() ? Stage::running
                                                                    : Stage::unknown;
    progress.fraction = result->fraction;
    progress.seconds = result->seconds;
    progress.cached = result->cached;
    progress.notes = result->notes;
    progress.failure = result->failure;
    return progress;
  }

  std::optional<Values> values(const Digest& key) {
    const std::lock_guard lock(mutex_);
    const Result* result = results_.find(key);
    return result == nullptr ? std::nullopt : result->values;
  }

  std::pair<Outcome, std::exception_ptr> outcome(const Plan& plan) {
    const std::lock_guard lock(mutex_);
    const PlanWalk walk(plan, results_);
    return {walk.outcome(), walk.failure()};
  }

  double fraction(const Plan& plan) {
    const std::lock_guard lock(mutex_);
    const auto needed = std::count_if(plan.steps.begin(), plan.steps.end(), [](const auto& p) { return p.needed; });
    double left = 0;
    for_each_open_end(plan, results_, [&](const PlannedStep&, const Result* result) {
      if (result == nullptr || !result->values) left += 1.0 - (result == nullptr ? 0.0 : result->fraction.load());
    });
    return needed == 0 ? 1.0 : 1.0 - left / static_cast<double>(needed);
  }

  std::vector<bool> ahead(const Plan& plan) {
    const std::lock_guard lock(mutex_);
    std::vector<bool> ahead(plan.steps.size());
    for_each_open_end(plan, results_, [&](const PlannedStep& planned, const Result* result) {
      ahead[static_cast<size_t>(&planned - plan.steps.data())] = result == nullptr || !result->values;
    });
    return ahead;
  }

  std::vector<StepReport> reports(const Plan& plan) {
    std::vector<StepReport> reports;
    for (size_t i = 0; i < plan.steps.size(); ++i) {
      if (!plan.steps[i].needed) continue;
      const Step& step = plan.recipe->steps[i];
      const StepProgress known = progress(plan.steps[i].key);
      if (known.stage == StepProgress::Stage::done) {
        reports.push_back({step.id, step.op->name, known.seconds, known.cached, known.notes});
      } else {  // a result that follows from it was in the cache
        reports.push_back({step.id, step.op->name, 0.0, true, cache_.notes(plan.steps[i].key)});
      }
    }
    return reports;
  }

  uint64_t bytes() {
    const std::lock_guard lock(mutex_);
    return results_.bytes();
  }

 private:
  void work() {
    std::unique_lock lock(mutex_);
    while (!stopping_ || !unsaved_.empty()) {
      if (const auto job = next_job()) {
        run(*job, lock);
      } else if (!unsaved_.empty()) {
        save_one(lock);
      } else {
        wake_.wait(lock);
      }
    }
  }

  std::optional<Job> next_job() {
    for (const auto& plan : plans_) {
      const PlanWalk walk(*plan, results_);
      if (walk.outcome() != Outcome::waiting) continue;
      if (!walk.next()) return std::nullopt;  // the plans behind it wait until it is settled
      return Job{plan, walk.next()->index, walk.next()->compute};
    }
    return std::nullopt;
  }

  void run(const Job& job, std::unique_lock<std::mutex>& lock) {
    Result& result = results_.at(job.planned().key);
    if (!job.compute && !keeps_on_disk(job)) {
      result.not_on_disk = true;
      return;
    }
    result.running = true;
    result.cancelled = false;
    result.fraction = 0.0;
    if (job.compute) result.notes.clear();
    const Values inputs = job.compute ? gather(job) : Values();
    lock.unlock();
    announce();
    const auto start = std::chrono::steady_clock::now();
    std::optional<Values> values;
    std::vector<std::string> notes;
    std::exception_ptr failure;
    try {
      if (job.compute) {
        Values made = compute(job, inputs, result);
        check_files(job.planned());
        values = std::move(made);
      } else {
        values = cache_.load(job.planned().key, job.step().op->out, *job.plan->recipe->registry);
        if (values) notes = cache_.notes(job.planned().key);
      }
    } catch (...) {
      if (job.compute) failure = std::current_exception();  // what cannot be loaded is computed
    }
    const double seconds = seconds_since(start);
    lock.lock();
    finish(job, result, std::move(notes), seconds);
    if (values && job.compute && keeps_on_disk(job)) unsaved_.push_back({job.planned().key, *values, result.notes});
    if (values) {
      keep(job, result, std::move(*values));
    } else if (failure && !is_cancelled(failure)) {
      result.failure = failure;
    }
    tidy();
    lock.unlock();
    announce();
    lock.lock();
    while (must_save()) save_one(lock);
  }

  /// Do results that wait to be written take too much of the memory?
  bool must_save() const {
    uint64_t bytes = 0;
    for (const Unsaved& unsaved : unsaved_) {
      for (const auto& [port, value] : unsaved.values) bytes += value.bytes();
    }
    return !unsaved_.empty() && (unsaved_.size() > kMostUnsaved || bytes > options_.memory_bytes / 4);
  }

  /// Writes a computed result to the disk, where that keeps nobody from seeing it or from going on with it.
  void save_one(std::unique_lock<std::mutex>& lock) {
    const Unsaved unsaved = std::move(unsaved_.front());
    unsaved_.pop_front();
    lock.unlock();
    cache_.store(unsaved.key, unsaved.values, unsaved.notes);
    lock.lock();
  }

  /// A result belongs to its key only if what was read is what was hashed.
  static void check_files(const PlannedStep& planned) {
    for (const auto& file : planned.files) {
      if (!file->still_valid()) throw IoError(file->path(), "was written to while it was read; run again");
    }
  }

  bool keeps_on_disk(const Job& job) const { return !options_.cache_folder.empty() && job.step().op->cached; }

  void finish(const Job& job, Result& result, std::vector<std::string> notes, double seconds) {
    result.running = false;
    result.fraction = 0.0;
    if (!job.compute) {
      result.not_on_disk = true;
      if (!result.done) result.notes = std::move(notes);
    }
    if (!result.done) result.seconds = seconds;
  }

  void keep(const Job& job, Result& result, Values values) {
    if (!result.done) result.cached = !job.compute;
    result.done = true;
    result.not_on_disk = !keeps_on_disk(job);
    if (options_.memory_bytes == 0)
      std::erase_if(values, [&](const auto& item) { return !job.planned().ports.contains(item.first); });
    results_.keep(result, std::move(values));
  }

  static bool is_cancelled(const std::exception_ptr& failure) {
    try {
      std::rethrow_exception(failure);
    } catch (const Cancelled&) {
      return true;
    } catch (...) {
      return false;
    }
  }

  Values gather(const Job& job) {
    Values inputs;
    for (const auto& [port, source] : job.step().in) {
      if (source.from_file()) continue;
      Result& producer = results_.at(job.plan->steps[job.plan->index_of.at(source.step)].key);
      results_.touch(producer);
      inputs[port] = producer.values->at(source.port);
    }
    return inputs;
  }

  Values compute(const Job& job, const Values& inputs, Result& result) {
    RunContext run;
    run.threads = arena_.max_concurrency() == 1 ? 1 : 0;  // 0: loops use the arena that they are called in
    run.cancelled = &result.cancelled;
    std::atomic told = std::chrono::steady_clock::now().time_since_epoch();
    run.progress = [&](double fraction) {
      if (fraction < result.fraction.load() + 0.01) return;
      result.fraction = fraction;
      const auto now = std::chrono::steady_clock::now().time_since_epoch();
      if (now - told.load() < kProgressEvery) return;
      told = now;
      announce();
    };
    run.note = [&](const std::string& line) {
      {
        const std::lock_guard lock(mutex_);
        result.notes.push_back(line);
      }
      if (options_.note) options_.note(job.step(), line);
    };
    return arena_.execute([&] {
      run.check_cancelled();
      return run_step(*job.plan->recipe, job.step(), inputs, run);
    });
  }

  /// Lets go of what nothing needs, and wakes those who wait for something to do or to be done.
  void tidy() {
    Keys in_use;
    for (const auto& plan : plans_) {
      for_each_open_end(*plan, results_, [&](const PlannedStep& planned, const Result* result) {
        if (result != nullptr && result->values) in_use.insert(planned.key);
      });
    }
    results_.shrink(in_use);
    wake_.notify_all();
  }

  void announce() const {
    if (options_.changed) options_.changed();
  }

  const SchedulerOptions options_;
  Cache cache_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool stopping_ = false;
  ResultStore results_;
  std::vector<std::shared_ptr<const Plan>> plans_;
  std::deque<Unsaved> unsaved_;
  tbb::task_arena arena_;
  Background crew_;  // last: its threads use all of the above
};

Scheduler::Scheduler(const SchedulerOptions& options) : work_(std::make_unique<Work>(options)) {}
Scheduler::~Scheduler() = default;
void Scheduler::pursue(std::vector<std::shared_ptr<const Plan>> plans) { work_->pursue(std::move(plans)); }
void Scheduler::forget_failures() { work_->forget_failures(); }
bool Scheduler::wait_for(int milliseconds) const { return work_->wait_for(milliseconds); }
StepProgress Scheduler::progress(const Digest& key) const { return work_->progress(key); }
std::optional<Values> Scheduler::values(const Digest& key) const { return work_->values(key); }
Outcome Scheduler::outcome(const Plan& plan) const { return work_->outcome(plan).first; }
std::exception_ptr Scheduler::failure(const Plan& plan) const { return work_->outcome(plan).second; }
double Scheduler::fraction(const Plan& plan) const { return work_->fraction(plan); }
std::vector<bool> Scheduler::ahead(const Plan& plan) const { return work_->ahead(plan); }
std::vector<StepReport> Scheduler::reports(const Plan& plan) const { return work_->reports(plan); }
uint64_t Scheduler::bytes_in_memory() const { return work_->bytes(); }

}  // namespace seamount::recipe
