#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "app.h"

namespace seamount::app {
namespace {

/// A value of the recipe that goes evenly from one number to another: frames of an animation, variants.
struct Sweep {
  std::string name;
  double from = 0, to = 0;
  int count = 0;

  std::string assignment(int k) const {
    return fmt::format("{}={}", name, k == count - 1 ? to : from + (to - from) * k / std::max(1, count - 1));
  }
};

constexpr int kMostRuns = 9999;

/// Reads "steps.worn.params.years=0:100000:11".
Sweep parse_sweep(const std::string& text) {
  const auto refuse = [&](const std::string& why) {
    throw InvalidArgument("--sweep", "expected NAME=FROM:TO:COUNT, found '" + text + "': " + why);
  };
  Sweep sweep;
  const size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos) refuse("no name");
  sweep.name = text.substr(0, equals);
  const char *at = text.data() + equals + 1, *end = text.data() + text.size();
  const auto number = [&](auto& value, const char* what) {
    const auto read = std::from_chars(at, end, value);
    if (read.ec != std::errc{} || !std::isfinite(static_cast<double>(value)))
      refuse(std::string(what) + " is no number");
    at = read.ptr;
  };
  const auto colon = [&] {
    if (at == end || *at++ != ':') refuse("a colon is missing");
  };
  number(sweep.from, "FROM");
  colon();
  number(sweep.to, "TO");
  colon();
  number(sweep.count, "COUNT");
  if (at != end) refuse("something follows COUNT");
  if (sweep.count < 1 || sweep.count > kMostRuns) refuse(fmt::format("COUNT is outside [1, {}]", kMostRuns));
  return sweep;
}

}  // namespace

void add_run_command(Command program, const recipe::Registry& registry) {
  struct Flags : RunFlags {
    std::string file;
    std::string out = "out";
    std::vector<std::string> sets;
    std::string sweep;
    std::optional<int> size;
  };
  const auto flags = std::make_shared<Flags>();
  Command command = program.add_command("run", "Run a recipe and write its outputs");
  command.add("recipe", &flags->file, "recipe file (JSON)").required();
  command.add("--out", &flags->out, "folder for the outputs");
  command.add("--set", &flags->sets, "change a value: steps.isle.params.relief=0.5, domain.cell_m=5");
  command.add("--sweep", &flags->sweep,
              "run COUNT times while a value goes from FROM to TO, into folders 0001, 0002, ... of --out: frames "
              "of an animation, variants. steps.worn.params.years=0:100000:11, seed=1:8:8");
  command.add("--size", &flags->size, "cells along the longer side: a quick preview, or more detail").between(1, 65536);
  add_run_flags(command, *flags);
  command.does([flags, &registry] {
    const auto read = [&](const std::vector<std::string>& sets) {
      return recipe::read_recipe(flags->file, {.sets = sets, .seed = flags->seed, .size = flags->size}, registry,
                                 {.cancelled = &cancel_flag()});
    };
    if (flags->sweep.empty()) return run_and_report(read(flags->sets), flags->out, *flags);
    if (flags->out.empty()) throw InvalidArgument("--out", "a folder name is needed");
    const Sweep sweep = parse_sweep(flags->sweep);
    std::vector<recipe::Recipe> runs;  // all are checked before the first begins
    for (int k = 0; k < sweep.count; ++k) {
      std::vector<std::string> sets = flags->sets;
      sets.push_back(sweep.assignment(k));
      runs.push_back(read(sets));
    }
    for (size_t k = 0; k < runs.size(); ++k)
      run_and_report(runs[k], fmt::format("{}/{:04}", flags->out, k + 1), *flags);
  });
}

}  // namespace seamount::app
