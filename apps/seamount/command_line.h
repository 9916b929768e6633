// Commands and flags, as this program needs them. CLI11, which takes seconds to compile, is known to command_line.cpp
// only.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace seamount::app {

/// A command's work, run after the whole line was read.
using Work = std::function<void()>;

/// Where the value of a flag goes. A list takes one value each time that its flag is given; a function is called with
/// the text.
using Target = std::variant<std::string*, std::vector<std::string>*, int*, uint64_t*, std::optional<int>*,
                            std::optional<uint64_t>*, std::optional<double>*, std::function<void(const std::string&)>>;

/// A flag ("--out", "--peak_m,--peak-m") or an argument without dashes ("file") of a command. A handle: copies are the
/// same flag.
class Flag {
 public:
  explicit Flag(CLI::Option* option) : option_(option) {}
  Flag required();
  Flag between(int64_t low, int64_t high);
  Flag whole();                         ///< digits that fit into 64 bits
  Flag finite();                        ///< a number that is not nan or inf
  Flag kind(const std::string& name);   ///< what help calls its value
  Flag group(const std::string& name);  ///< the heading in help that it stands under

 private:
  CLI::Option* option_;
};

/// A command, or the whole program. A handle: copies are the same command.
class Command {
 public:
  explicit Command(CLI::App* app, Work* chosen) : app_(app), chosen_(chosen) {}
  /// A command of this one, under a heading in help.
  Command add_command(const std::string& name, const std::string& summary, const std::string& group = "Subcommands");
  Flag add(const std::string& names, Target target, const std::string& help);
  /// A flag without a value.
  Flag add_switch(const std::string& name, bool& target, const std::string& help);
  bool has(const std::string& name) const;
  /// One of its commands must be given.
  void require_command();
  /// What it does when it is the one that was chosen.
  void does(Work work);

 private:
  CLI::App* app_;
  Work* chosen_;
};

/// Reads a command line by the commands that `add_commands` adds, and does the work of the chosen one. Returns the exit
/// code: 0, also after help; 2 for wrong usage, which is said on stderr in one line, with the nearest command or flag
/// where one was mistyped. Errors of the work are thrown on.
int run_command_line(int argc, char** argv, const std::function<void(Command)>& add_commands);

}  // namespace seamount::app
