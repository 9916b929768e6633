#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <mutex>

#include "app.h"
#include "seamount/base/printable.h"
#include "seamount/tiles/run.h"
#include "seamount/tiles/spread.h"

namespace seamount::app {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Says what it can: a closed stderr is no reason to fail.
void write_quietly(std::string_view text) noexcept {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

/// "45 %, about 12 s left", redrawn in place at most ten times a second, or a new line every ten seconds.
class ProgressLine {
 public:
  explicit ProgressLine(bool in_place) : in_place_(in_place) {}

  void show(double fraction) {
    const std::lock_guard lock(mutex_);
    const auto now = Clock::now();
    if (now - drawn_ < std::chrono::milliseconds(in_place_ ? 100 : 10000)) return;
    drawn_ = now;
    const double elapsed = seconds_since(start_);
    std::string left;
    if (fraction > 0.02 && elapsed > 1.0)
      left = fmt::format(", about {:.0f} s left", elapsed * (1.0 - fraction) / fraction);
    const std::string line = fmt::format("{:3.0f} %{}", 100.0 * fraction, left);
    write_quietly(in_place_ ? "\r\033[K" + line : line + "\n");
    shown_ = in_place_;
  }
  void clear() noexcept {
    if (shown_) write_quietly("\r\033[K");
  }

 private:
  bool in_place_;
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

void print_message(std::string_view line) noexcept {
  try {
    write_quietly(printable(line) + "\n");
  } catch (const std::exception&) {
    write_quietly("(no memory to show a message)\n");
  }
}

std::string shown(const recipe::Json& json) { return json.dump(2, ' ', false, recipe::Json::error_handler_t::replace); }

void add_run_flags(Command command, RunFlags& flags) {
  command.add("--threads", &flags.threads, "threads to use; 0: all processors").between(0, 1024);
  command.add("--seed", &flags.seed, "seed of everything random").whole();
  command.add_switch("--no-cache", flags.no_cache, "compute every step, keep none");
  command.add_switch("--json", flags.json, "print the summary as JSON");
}

Session::Session(const RunFlags& flags, Shows shows) {
  run_.threads = flags.threads;
  run_.cancelled = &cancel_flag();
  if (shows == Shows::nothing) return;
  run_.note = [](const std::string& line) {
    if (current_line()) current_line()->clear();
    print_message("note: " + line);
  };
  const bool terminal = isatty(STDERR_FILENO) == 1;
  if (terminal || shows == Shows::lines) {
    current_line() = std::make_shared<ProgressLine>(terminal);
    run_.progress = [line = current_line()](double fraction) { line->show(fraction); };
  }
}

Session::~Session() {
  if (current_line()) current_line()->clear();
  current_line().reset();
}

std::string absolute_file(const std::string& flag, const std::string& file) {
  if (file.empty()) throw InvalidArgument(flag, "a file name is needed");
  return std::filesystem::absolute(file).lexically_normal().string();
}

namespace {

/// The flag that a JSON pointer into a document made from flags stands for: "--walk.stickiness"; of lists the place
/// within: "--edits/0/radius_m".
std::optional<std::string> flag_of(const std::string& pointer, const FlagNames& flags) {
  for (const auto& [beginning, flag] : flags) {
    if (!pointer.starts_with(beginning)) continue;
    std::string rest = pointer.substr(beginning.size());
    for (size_t slash = rest.find('/'); slash != std::string::npos; slash = rest.find('/', slash)) {
      if (slash + 1 < rest.size() && rest[slash + 1] >= '0' && rest[slash + 1] <= '9') break;
      rest[slash] = '.';
    }
    return flag + rest;
  }
  return std::nullopt;
}

}  // namespace

void throw_as_flag(const recipe::Diagnostic& defect, const std::string& command, const FlagNames& flags) {
  // "/steps/0/params/peak_m", "peak_m: 1e9 is outside [0, 9000]": the name is said once.
  std::string message = defect.message;
  const std::string name = defect.pointer.substr(defect.pointer.rfind('/') + 1) + ": ";
  if (message.starts_with(name)) message.erase(0, name.size());
  throw InvalidArgument(flag_of(defect.pointer, flags).value_or(command), message);
}

recipe::Recipe parse_made_recipe(const recipe::Json& document, const std::string& command, const FlagNames& flags,
                                 const recipe::RecipeChanges& changes, const recipe::Registry& registry) {
  const std::string text = document.dump(-1, ' ', false, recipe::Json::error_handler_t::replace);
  try {
    recipe::Recipe recipe = recipe::parse_recipe(text, command, "", changes, registry);
    for (recipe::Diagnostic& note : recipe.notes)
      note = {flag_of(note.pointer, flags).value_or(note.pointer), note.message};
    return recipe;
  } catch (const recipe::RecipeError& error) {
    // What was written wrongly says more than what is therefore missing.
    const auto& defects = error.diagnostics();
    const auto unknown = std::find_if(defects.begin(), defects.end(), [](const recipe::Diagnostic& defect) {
      return defect.message.starts_with("unknown");
    });
    throw_as_flag(unknown == defects.end() ? defects.front() : *unknown, command, flags);
  }
}

void run_and_report(const recipe::Recipe& recipe, const std::string& out_folder, const RunFlags& flags,
                    tiles::Ranks* ranks) {
  if (out_folder.empty()) throw InvalidArgument("--out", "a folder name is needed");
  const auto start = Clock::now();
  recipe::ExecuteOptions options{.out_folder = out_folder};
  if (flags.no_cache) options.cache_folder.clear();
  constexpr double kGigabyte = 1e9;
  const tiles::TileOptions tiled{out_folder, options.cache_folder, flags.tiles,
                                 static_cast<uint64_t>(flags.memory_gb.value_or(0.0) * kGigabyte), ranks};
  const bool quiet = ranks != nullptr && !ranks->first();
  recipe::ExecuteReport report;
  {
    RunFlags own = flags;
    if (ranks != nullptr && own.threads == 0) own.threads = tiles::threads_of(*ranks);
    const Session session(own, ranks == nullptr ? Shows::line : quiet ? Shows::nothing : Shows::lines);
    report = flags.tiles > 0 ? tiles::execute(recipe, tiled, session.run())
                             : recipe::execute(recipe, options, session.run());
  }
  if (quiet) return;
  for (const recipe::StepReport& step : report.steps) {
    print_message(
        fmt::format("{:>8.3f} s  {} ({}){}", step.seconds, step.id, step.op, step.cached ? ", from the cache" : ""));
  }
  for (const recipe::OutputReport& output : report.outputs)
    print_message(fmt::format("{:>8.3f} s  {}", output.seconds, output.path));
  print_message(fmt::format("{:>8.3f} s  in all", seconds_since(start)));
  if (flags.json) {
    recipe::Json summary = {{"notes", recipe::Json::array()},
                            {"outputs", recipe::Json::array()},
                            {"steps", recipe::Json::array()},
                            {"seconds", seconds_since(start)}};
    for (const recipe::Diagnostic& note : recipe.notes)
      summary["notes"].push_back(recipe::diagnostic_line(recipe.file, note));
    for (const auto& step : report.steps)
      for (const std::string& note : step.notes)
        summary["notes"].push_back(fmt::format("step '{}': {}", step.id, note));
    for (const auto& output : report.outputs) {
      summary["outputs"].push_back(
          {{"path", output.path}, {"as", output.format}, {"files", output.files}, {"notes", output.notes}});
      for (const std::string& note : output.notes)
        summary["notes"].push_back(fmt::format("output '{}': {}", output.path, note));
    }
    for (const auto& step : report.steps) {
      summary["steps"].push_back({{"id", step.id},
                                  {"op", step.op},
                                  {"seconds", step.seconds},
                                  {"cached", step.cached},
                                  {"notes", step.notes}});
    }
    std::cout << shown(summary) << "\n";
  } else {
    for (const auto& output : report.outputs) std::cout << printable(output.path) << "\n";
  }
}

}  // namespace seamount::app
