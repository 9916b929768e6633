#include "seamount/recipe/executor.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <set>

#include "seamount/base/parallel.h"
#include "seamount/base/version.h"
#include "seamount/recipe/file_values.h"
#include "seamount/recipe/kinds.h"
#include "seamount/recipe/output_files.h"

namespace seamount::recipe {
namespace {

namespace fs = std::filesystem;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// "step 'reef' (island.coral): " before a message; the kind of error stays.
[[noreturn]] void rethrow_with_step(const Step& step) {
  const std::string place = step.output.empty() ? fmt::format("step '{}' ({})", step.id, step.op->name)
                                                : fmt::format("output '{}' ({})", step.output, step.op->name);
  const std::string prefix = place + ": ";
  try {
    throw;
  } catch (const Cancelled&) {
    throw;
  } catch (const IoError&) {
    throw;  // it names its file
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(place, error.what());
  } catch (const IncompatibleInputs& error) {
    throw IncompatibleInputs(prefix + error.what());
  } catch (const std::bad_alloc&) {
    throw Error(prefix + "not enough memory");
  } catch (const std::exception& error) {
    throw Error(prefix + error.what());
  }
}

/// Fraction of the whole from the fractions of the steps, passed on one call at a time.
class Progress {
 public:
  Progress(const RunContext& run, size_t parts) : run_(run), fractions_(parts) {}

  RunContext part(size_t index) {
    RunContext sub = run_;
    if (run_.progress) sub.progress = [this, index](double fraction) { set(index, fraction); };
    return sub;
  }
  void set(size_t index, double fraction) {
    if (!run_.progress) return;
    const std::lock_guard lock(mutex_);
    fractions_[index] = std::max(fractions_[index], fraction);
    double sum = 0;
    for (const double f : fractions_) sum += f;
    run_.report(sum / static_cast<double>(fractions_.size()));
  }

 private:
  const RunContext& run_;
  std::vector<double> fractions_;
  std::mutex mutex_;
};

/// Runs the steps of a recipe as their inputs become ready and keeps values as long as somebody still needs them.
class StepRunner {
 public:
  StepRunner(const Recipe& recipe, const std::vector<Source>& wanted, Cache& cache, const RunContext& run,
             Progress& progress)
      : recipe_(recipe), cache_(cache), run_(run), progress_(progress), states_(recipe.steps.size()) {
    for (size_t i = 0; i < recipe.steps.size(); ++i) index_[recipe.steps[i].id] = i;
    for (const Source& source : wanted) need(source);
    if (wanted.empty()) {
      for (State& state : states_) state.needed = true;
    }
    for (size_t i = recipe.steps.size(); i-- > 0;) {
      if (!states_[i].needed) continue;
      for (const auto& [port, source] : recipe.steps[i].in) {
        if (source.from_file()) continue;
        need(source);
        states_[index_.at(source.step)].dependents.push_back(i);
        ++states_[i].waiting_for;
      }
    }
  }

  void run_all() {
    std::vector<size_t> ready;  // found before the first one runs: from then on, steps start those that follow
    for (size_t i = 0; i < states_.size(); ++i) {
      if (states_[i].needed && states_[i].waiting_for == 0) ready.push_back(i);
    }
    tbb::task_group group;
    for (const size_t i : ready) group.run([this, i, &group] { run_step(i, group); });
    group.wait();
    if (failure_) std::rethrow_exception(failure_);
  }

  const Value& value(const Source& source) const { return states_[index_.at(source.step)].values.at(source.port); }

  std::vector<StepReport> reports() const {
    std::vector<StepReport> all;
    for (size_t i = 0; i < states_.size(); ++i) {
      if (states_[i].needed) all.push_back(states_[i].report);
    }
    return all;
  }

 private:
  struct State {
    bool needed = false;
    std::set<std::string> wanted;  ///< ports that somebody uses; the others are let go at once
    int users = 0;                 ///< inputs and outputs that have not fetched their value yet
    int waiting_for = 0;
    std::vector<size_t> dependents;
    Digest key;
    Values values;
    StepReport report;
  };

  void need(const Source& source) {
    State& state = states_[index_.at(source.step)];
    state.needed = true;
    state.wanted.insert(source.port);
    ++state.users;
  }

  void run_step(size_t index, tbb::task_group& group) {
    const Step& step = recipe_.steps[index];
    State& state = states_[index];
    try {
      run_.check_cancelled();
      {
        const std::lock_guard lock(mutex_);
        if (failure_) return;
      }
      try {
        compute(step, state, progress_.part(index));
      } catch (...) {
        rethrow_with_step(step);
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      return;
    }
    progress_.set(index, 1.0);
    const std::lock_guard lock(mutex_);
    for (const auto& [port, source] : step.in) {
      if (source.from_file()) continue;
      State& producer = states_[index_.at(source.step)];
      if (--producer.users == 0) producer.values.clear();
    }
    for (const size_t dependent : state.dependents) {
      if (--states_[dependent].waiting_for == 0) group.run([this, dependent, &group] { run_step(dependent, group); });
    }
  }

  void compute(const Step& step, State& state, const RunContext& run) {
    const auto start = std::chrono::steady_clock::now();
    Hasher hasher;
    hasher.text(kVersion).text(step.op->name).number(static_cast<uint64_t>(step.op->revision)).text(step.params.dump());
    if (step.op->stochastic) hasher.number(step.seed.value);
    hash_domain(hasher);
    hash_files(step, hasher);
    for (const auto& [port, source] : step.in) {
      hasher.text(port);
      if (source.from_file()) {
        hasher.text(file_digest(resolve(source.file)).hex());
      } else {
        hasher.text(states_[index_.at(source.step)].key.hex()).text(source.port);
      }
    }
    state.key = hasher.digest();
    state.report = {step.id, step.op->name, 0.0, false};
    auto stored = step.op->cached ? cache_.load(state.key, step.op->out, *recipe_.registry) : std::nullopt;
    if (stored) {
      state.values = std::move(*stored);
      state.report.cached = true;
    } else {
      state.values = run_operator(step, run);
      if (step.op->cached) cache_.store(state.key, state.values);
    }
    std::erase_if(state.values, [&](const auto& item) { return !state.wanted.contains(item.first); });
    state.report.seconds = seconds_since(start);
  }

  Values run_operator(const Step& step, const RunContext& run) {
    Values in;
    GridFrame frame = recipe_.domain;
    for (const Port& port : step.op->in) {  // in their order: a terrain before the labels that may be painted over it
      const auto connected = step.in.find(port.name);
      if (connected == step.in.end()) continue;
      const Source& source = connected->second;
      in[port.name] = source.from_file() ? read_file(port, resolve(source.file), frame, run) : value(source);
      if (port.kind == &kinds::Terrain::kind()) frame = *in[port.name].frame();
    }
    RunContext named = run;
    if (run.note) named.note = [&run, &step](const std::string& line) { run.note("step '" + step.id + "': " + line); };
    return step.op->run(step.params, in, {recipe_.domain, step.seed, recipe_.folder, named});
  }

  static Value read_file(const Port& port, const std::string& path, const GridFrame& frame, const RunContext& run) {
    run.check_cancelled();
    if (!port.kind->read_file) throw IoError(path, "a " + port.kind->name + " is written, never read");
    return {*port.kind, port.kind->read_file({path, frame, run})};
  }

  void hash_domain(Hasher& hasher) const {
    const GridFrame& domain = recipe_.domain;
    hasher.text(fmt::format("{} {} {} {} {} {}", domain.width, domain.height, domain.cell_m, domain.west_m,
                            domain.north_m, domain.crs));
  }

  void hash_files(const Step& step, Hasher& hasher) const {
    for_each_file(step.op->params, step.params,
                  [&](const std::string& name) { hasher.text(file_digest(resolve(name)).hex()); });
  }

  std::string resolve(const std::string& file) const {
    const fs::path path(file);
    return path.is_absolute() ? file : (fs::path(recipe_.folder) / path).string();
  }

  const Recipe& recipe_;
  Cache& cache_;
  const RunContext& run_;
  Progress& progress_;
  std::map<std::string, size_t> index_;
  std::vector<State> states_;
  std::mutex mutex_;
  std::exception_ptr failure_;
};

/// All work happens in one arena of the wanted size; inner loops share it.
template <class Function>
void in_arena(const RunContext& run, Function function) {
  RunContext inner = run;
  tbb::task_arena arena(std::max(1, std::min(thread_count(run), thread_count({}))));
  if (run.threads != 1) inner.threads = 0;
  arena.execute([&] { function(inner); });
}

std::vector<Source> output_sources(const Recipe& recipe) {
  std::vector<Source> wanted;
  for (const Output& output : recipe.outputs) {
    wanted.push_back(output.from);
    for (const auto& [name, source] : output.prepared) wanted.push_back(source);
  }
  return wanted;
}

}  // namespace

ExecuteReport execute(const Recipe& recipe, const ExecuteOptions& options, const RunContext& run) {
  check_nothing_overwritten(recipe, options.out_folder);
  for (const Diagnostic& note : recipe.notes) run.say(diagnostic_line(recipe.file, note));
  ExecuteReport report;
  Cache cache(options.cache_folder);
  Progress progress(run, recipe.steps.size() + recipe.outputs.size());
  in_arena(run, [&](const RunContext& inner) {
    StepRunner runner(recipe, output_sources(recipe), cache, inner, progress);
    runner.run_all();
    report.steps = runner.reports();
    report.outputs = write_outputs(
        recipe, options.out_folder, [&](const Source& source) -> const Value& { return runner.value(source); },
        [&](size_t i) { return progress.part(recipe.steps.size() + i); }, inner);
  });
  return report;
}

std::vector<Value> evaluate(const Recipe& recipe, const std::vector<Source>& wanted, const ExecuteOptions& options,
                            const RunContext& run, ExecuteReport* report) {
  std::vector<Value> values;
  Cache cache(options.cache_folder);
  Progress progress(run, recipe.steps.size());
  in_arena(run, [&](const RunContext& inner) {
    StepRunner runner(recipe, wanted, cache, inner, progress);
    runner.run_all();
    for (const Source& source : wanted) values.push_back(runner.value(source));
    if (report != nullptr) report->steps = runner.reports();
  });
  return values;
}

}  // namespace seamount::recipe
