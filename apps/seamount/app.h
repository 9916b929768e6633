// What the commands share: where messages go, cancellation, progress, exit codes. No algorithm lives here.
#pragma once

#include <CLI/CLI.hpp>
#include <atomic>
#include <functional>
#include <optional>
#include <string>

#include "seamount/recipe/executor.h"

namespace seamount::app {

/// Exit codes of every command.
enum ExitCode { kDone = 0, kFailed = 1, kWrongInput = 2 };

/// Flags that every command which runs something has.
struct RunFlags {
  int threads = 0;
  bool json = false;
  bool no_cache = false;
  std::optional<uint64_t> seed;
};

void add_run_flags(CLI::App& command, RunFlags& flags);

/// Set by Ctrl-C.
std::atomic<bool>& cancel_flag();

/// A context with the flags' threads, Ctrl-C, and a progress line on stderr if that is a terminal.
class Session {
 public:
  explicit Session(const RunFlags& flags);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  const RunContext& run() const { return run_; }

 private:
  RunContext run_;
};

/// Runs a recipe and prints its summary: written files to stdout (or JSON), timings to stderr.
void run_and_report(const recipe::Recipe& recipe, const std::string& out_folder, const RunFlags& flags);

/// A command's work; set by its callback when it was chosen, run after parsing.
using Work = std::function<void()>;

// Each adds its commands to the program.
void add_run_command(CLI::App& program, Work& work);
void add_operator_commands(CLI::App& program, Work& work);
void add_discover_commands(CLI::App& program, Work& work);
void add_chore_commands(CLI::App& program, Work& work);
void add_dataset_command(CLI::App& program, Work& work);

}  // namespace seamount::app
