#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <iostream>
#include <mutex>

#include "app.h"

namespace seamount::app {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// "45 %, about 12 s left", redrawn in place at most ten times a second.
class ProgressLine {
 public:
  void show(double fraction) {
    const std::lock_guard lock(mutex_);
    const auto now = Clock::now();
    if (now - drawn_ < std::chrono::milliseconds(100)) return;
    drawn_ = now;
    const double elapsed = seconds_since(start_);
    std::string left;
    if (fraction > 0.02 && elapsed > 1.0)
      left = fmt::format(", about {:.0f} s left", elapsed * (1.0 - fraction) / fraction);
    fmt::print(stderr, "\r\033[K{:3.0f} %{}", 100.0 * fraction, left);
    std::fflush(stderr);
    shown_ = true;
  }
  void clear() {
    if (shown_) fmt::print(stderr, "\r\033[K");
  }

 private:
  std::mutex mutex_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point drawn_ = start_;
  bool shown_ = false;
};

std::shared_ptr<ProgressLine>& current_line() {
  static std::shared_ptr<ProgressLine> line;
  return line;
}

}  // namespace

std::atomic<bool>& cancel_flag() {
  static std::atomic<bool> flag{false};
  return flag;
}

void add_run_flags(CLI::App& command, RunFlags& flags) {
  command.add_option("--threads", flags.threads, "threads to use; 0: all processors")->check(CLI::Range(0, 1024));
  command.add_option("--seed", flags.seed, "seed of everything random");
  command.add_flag("--no-cache", flags.no_cache, "compute every step, keep none");
  command.add_flag("--json", flags.json, "print the summary as JSON");
}

Session::Session(const RunFlags& flags) {
  run_.threads = flags.threads;
  run_.cancelled = &cancel_flag();
  if (isatty(STDERR_FILENO) == 1) {
    current_line() = std::make_shared<ProgressLine>();
    run_.progress = [line = current_line()](double fraction) { line->show(fraction); };
  }
}

Session::~Session() {
  if (current_line()) current_line()->clear();
  current_line().reset();
}

void run_and_report(const recipe::Recipe& recipe, const std::string& out_folder, const RunFlags& flags) {
  const auto start = Clock::now();
  recipe::ExecuteOptions options{.out_folder = out_folder};
  if (flags.no_cache) options.cache_folder.clear();
  recipe::ExecuteReport report;
  {
    const Session session(flags);
    report = recipe::execute(recipe, options, session.run());
  }
  for (const recipe::StepReport& step : report.steps) {
    fmt::print(stderr, "{:>8.3f} s  {} ({}){}\n", step.seconds, step.id, step.op,
               step.cached ? ", from the cache" : "");
  }
  for (const recipe::OutputReport& output : report.outputs)
    fmt::print(stderr, "{:>8.3f} s  {}\n", output.seconds, output.path);
  fmt::print(stderr, "{:>8.3f} s  in all\n", seconds_since(start));
  if (flags.json) {
    recipe::Json summary = {
        {"outputs", recipe::Json::array()}, {"steps", recipe::Json::array()}, {"seconds", seconds_since(start)}};
    for (const auto& output : report.outputs)
      summary["outputs"].push_back({{"path", output.path}, {"as", output.format}});
    for (const auto& step : report.steps) {
      summary["steps"].push_back(
          {{"id", step.id}, {"op", step.op}, {"seconds", step.seconds}, {"cached", step.cached}});
    }
    std::cout << summary.dump(2) << "\n";
  } else {
    for (const auto& output : report.outputs) std::cout << output.path << "\n";
  }
}

void add_run_command(CLI::App& program, Work& work) {
  struct Flags : RunFlags {
    std::string file;
    std::string out = "out";
    std::vector<std::string> sets;
    std::optional<int> size;
  };
  const auto flags = std::make_shared<Flags>();
  CLI::App* command = program.add_subcommand("run", "Run a recipe and write its outputs");
  command->add_option("recipe", flags->file, "recipe file (JSON)")->required();
  command->add_option("--out", flags->out, "folder for the outputs");
  command->add_option("--set", flags->sets, "change a value: steps.isle.params.relief=0.5, domain.cell_m=5")
      ->allow_extra_args(false);
  command->add_option("--size", flags->size, "cells along the longer side: a quick preview, or more detail")
      ->check(CLI::Range(1, 65536));
  add_run_flags(*command, *flags);
  command->callback([flags, &work] {
    work = [flags] {
      const recipe::Recipe read =
          recipe::read_recipe(flags->file, {.sets = flags->sets, .seed = flags->seed, .size = flags->size});
      run_and_report(read, flags->out, *flags);
    };
  });
}

}  // namespace seamount::app
