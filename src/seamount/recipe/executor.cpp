#include "seamount/recipe/executor.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <mutex>

#include "seamount/base/parallel.h"
#include "seamount/recipe/output_files.h"

namespace seamount::recipe {
namespace {

/// How long a waiting caller takes to notice that it should stop.
constexpr int kPollMilliseconds = 5;

/// Passes fractions on that only grow, one call at a time.
class GrowingFraction {
 public:
  explicit GrowingFraction(const RunContext& run) : run_(run) {}

  void report(double fraction) {
    const std::lock_guard lock(mutex_);
    if (fraction <= highest_) return;
    highest_ = fraction;
    run_.report(fraction);
  }

 private:
  const RunContext& run_;
  double highest_ = 0.0;
  std::mutex mutex_;
};

/// One fraction from those of several parts that are worked on side by side.
class JointProgress {
 public:
  JointProgress(const RunContext& run, size_t parts) : whole_(run), fractions_(parts) {}

  RunContext part(size_t index, RunContext run) {
    run.progress = [this, index](double fraction) { set(index, fraction); };
    return run;
  }

 private:
  void set(size_t index, double fraction) {
    double sum = 0;
    {
      const std::lock_guard lock(mutex_);
      fractions_[index] = std::max(fractions_[index], fraction);
      for (const double f : fractions_) sum += f;
    }
    whole_.report(sum / static_cast<double>(fractions_.size()));
  }

  GrowingFraction whole_;
  std::vector<double> fractions_;
  std::mutex mutex_;
};

/// The steps of one recipe, run once.
class StepsRun {
 public:
  StepsRun(const Recipe& recipe, const std::vector<Source>& wanted, const ExecuteOptions& options,
           const RunContext& run)
      : run_(run),
        progress_(run),
        plan_(std::make_shared<const Plan>(
            make_plan(std::shared_ptr<const Recipe>(std::shared_ptr<const Recipe>(), &recipe), wanted, files_))),
        scheduler_({.threads = run.threads,
                    .cache_folder = options.cache_folder,
                    .memory_bytes = 0,
                    .changed = [this] { report_progress(); },
                    .note = [this](const Step& step, const std::string& line) { say(step, line); }}) {}

  /// `share`: the part of the whole that the steps are.
  void finish(double share) {
    share_ = share;
    run_.check_cancelled();
    scheduler_.pursue({plan_});
    while (!scheduler_.failure(*plan_) && !scheduler_.wait_for(kPollMilliseconds)) run_.check_cancelled();
    if (const auto failure = scheduler_.failure(*plan_)) std::rethrow_exception(failure);
    progress_.report(share);
    for (const StepReport& report : reports()) {
      if (!report.cached) continue;
      for (const std::string& line : report.notes) say(plan_->recipe->steps[plan_->index_of.at(report.id)], line);
    }
  }

  std::map<Source, Value> values(const std::vector<Source>& sources) const {
    std::map<Source, Value> values;
    for (const Source& source : sources)
      values[source] = scheduler_.values(plan_->steps[plan_->index_of.at(source.step)].key)->at(source.port);
    return values;
  }

  std::vector<StepReport> reports() const { return scheduler_.reports(*plan_); }

 private:
  void report_progress() {
    if (run_.progress) progress_.report(share_ * scheduler_.fraction(*plan_));
  }
  void say(const Step& step, const std::string& line) {
    const std::lock_guard lock(saying_);
    run_.say("step '" + step.id + "': " + line);
  }

  const RunContext& run_;
  FileSnapshots files_;
  GrowingFraction progress_;
  double share_ = 1.0;
  std::mutex saying_;
  std::shared_ptr<const Plan> plan_;
  Scheduler scheduler_;  // last: its threads use all of the above
};

}  // namespace

ExecuteReport execute(const Recipe& recipe, const ExecuteOptions& options, const RunContext& run) {
  check_nothing_overwritten(recipe, options.out_folder);
  for (const Diagnostic& note : recipe.notes) run.say(diagnostic_line(recipe.file, note));
  std::vector<Source> wanted = output_sources(recipe);
  if (wanted.empty()) {
    for (const Step& step : recipe.steps) wanted.push_back({step.id, "", ""});
  }
  StepsRun steps(recipe, wanted, options, run);
  const double all = static_cast<double>(recipe.steps.size() + recipe.outputs.size());
  const double share = static_cast<double>(recipe.steps.size()) / std::max(1.0, all);
  steps.finish(share);
  ExecuteReport report;
  report.steps = steps.reports();
  report.outputs =
      write_outputs_from(recipe, options.out_folder, steps.values(output_sources(recipe)), run.part(share, 1.0));
  return report;
}

std::vector<Value> evaluate(const Recipe& recipe, const std::vector<Source>& wanted, const ExecuteOptions& options,
                            const RunContext& run, ExecuteReport* report) {
  StepsRun steps(recipe, wanted, options, run);
  steps.finish(1.0);
  const std::map<Source, Value> made = steps.values(wanted);
  std::vector<Value> values;
  values.reserve(wanted.size());
  for (const Source& source : wanted) values.push_back(made.at(source));
  if (report != nullptr) report->steps = steps.reports();
  return values;
}

std::vector<Source> output_sources(const Recipe& recipe) {
  std::vector<Source> wanted;
  for (const Output& output : recipe.outputs) {
    wanted.push_back(output.from);
    for (const auto& [name, source] : output.prepared) wanted.push_back(source);
  }
  return wanted;
}

std::vector<OutputReport> write_outputs_from(const Recipe& recipe, const std::string& out_folder,
                                             const std::map<Source, Value>& values, const RunContext& run) {
  JointProgress progress(run, recipe.outputs.size());
  RunContext inner = run;
  if (run.threads != 1) inner.threads = 0;  // loops share the arena
  tbb::task_arena arena(std::max(1, std::min(thread_count(run), thread_count({}))));
  return arena.execute([&] {
    return write_outputs(
        recipe, out_folder, [&](const Source& source) -> const Value& { return values.at(source); },
        [&](size_t i) { return progress.part(i, inner); }, inner);
  });
}

}  // namespace seamount::recipe
