// What the commands share: where messages go, cancellation, progress, exit codes. No algorithm lives here.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "command_line.h"
#include "seamount/recipe/executor.h"
#include "seamount/tiles/ranks.h"

namespace seamount::app {

/// Exit codes of every command.
enum ExitCode { kDone = 0, kFailed = 1, kWrongInput = 2 };

/// Flags that every command which runs something has.
struct RunFlags {
  int threads = 0;
  bool json = false;
  bool no_cache = false;
  std::optional<uint64_t> seed;
  int tiles = 0;                    ///< cells along a tile; 0: all at once
  std::optional<double> memory_gb;  ///< of what looks at everything in tiles; half of the machine's if left out
};

void add_run_flags(Command command, RunFlags& flags);

/// Set by Ctrl-C, and by a terminal that is closed.
std::atomic<bool>& cancel_flag();

/// What a run shows on stderr: a line of progress if that is a terminal; one now and then, since what mpirun passes on
/// is none; nothing, notes neither, for another rank shows it.
enum class Shows { line, lines, nothing };

/// A context with the flags' threads, Ctrl-C, and progress on stderr.
class Session {
 public:
  explicit Session(const RunFlags& flags, Shows shows = Shows::line);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  const RunContext& run() const { return run_; }

 private:
  RunContext run_;
};

/// A line on stderr, made printable; where stderr is closed or its disk is full, nothing.
void print_message(std::string_view line) noexcept;

/// JSON as it is printed, of text that may be no UTF-8.
std::string shown(const recipe::Json& json);

/// Runs a recipe and prints its summary: written files to stdout (or JSON), timings to stderr. `ranks`: who run it in
/// tiles together, of which rank 0 prints; nullptr: this process alone.
void run_and_report(const recipe::Recipe& recipe, const std::string& out_folder, const RunFlags& flags,
                    tiles::Ranks* ranks = nullptr);

/// Calls work(ranks) where the process was started as one of several by mpirun, work(nullptr) where it was not. What
/// one rank throws ends all, and is said by rank 0 alone. Throws InvalidArgument for several without --tiles.
void run_as_ranks(const RunFlags& flags, const std::function<void(tiles::Ranks* ranks)>& work);

/// Beginnings of JSON pointers into a document that was made from flags, and the flags that they came from.
using FlagNames = std::vector<std::pair<std::string, std::string>>;
/// Throws InvalidArgument for a defect of such a document, by its flag.
[[noreturn]] void throw_as_flag(const recipe::Diagnostic& defect, const std::string& command, const FlagNames& flags);

/// A recipe made from flags. Throws InvalidArgument for the first defect.
recipe::Recipe parse_made_recipe(const recipe::Json& document, const std::string& command, const FlagNames& flags,
                                 const recipe::RecipeChanges& changes = {},
                                 const recipe::Registry& registry = recipe::standard_registry());

/// A file name that does not depend on where the program runs. Throws InvalidArgument{flag} for an empty one.
std::string absolute_file(const std::string& flag, const std::string& file);

// Each adds its commands to the program.
void add_run_command(Command program, const recipe::Registry& registry);
void add_operator_commands(Command program, const recipe::Registry& registry);
void add_discover_commands(Command program, const recipe::Registry& registry);
void add_chore_commands(Command program, const recipe::Registry& registry);
void add_dataset_command(Command program);
void add_studio_command(Command program, const recipe::Registry& registry);

}  // namespace seamount::app
