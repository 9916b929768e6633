#include "sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "seamount/base/error.h"

namespace seamount::app {
namespace {

constexpr int kMostRuns = 9999;

/// One name and the values that it takes.
struct Axis {
  std::string name;
  std::vector<std::string> values;
};

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  throw InvalidArgument("--sweep", "expected NAME=FROM:TO:COUNT or NAME=VALUE,VALUE,..., found '" + text + "': " + why);
}

/// Parts between commas that are in no brackets and no quotes.
std::vector<std::string> split_list(const std::string& text) {
  std::vector<std::string> parts(1);
  int depth = 0;
  bool quoted = false;
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"' && (i == 0 || text[i - 1] != '\\')) quoted = !quoted;
    if (!quoted) depth += (c == '[' || c == '{') - (c == ']' || c == '}');
    if (c == ',' && depth == 0 && !quoted)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

std::vector<std::string> parse_range(const std::string& text, size_t begin) {
  const char *at = text.data() + begin, *end = text.data() + text.size();
  const auto number = [&](auto& value, const char* what) {
    const auto read = std::from_chars(at, end, value);
    if (read.ec != std::errc{} || !std::isfinite(static_cast<double>(value)))
      refuse(text, std::string(what) + " is no number");
    at = read.ptr;
  };
  const auto colon = [&] {
    if (at == end || *at++ != ':') refuse(text, "a colon is missing");
  };
  double from = 0, to = 0;
  int count = 0;
  number(from, "FROM");
  colon();
  number(to, "TO");
  colon();
  number(count, "COUNT");
  if (at != end) refuse(text, "something follows COUNT");
  if (count < 1 || count > kMostRuns) refuse(text, fmt::format("COUNT is outside [1, {}]", kMostRuns));
  std::vector<std::string> values;
  for (int k = 0; k < count; ++k)
    values.push_back(fmt::format("{}", k == count - 1 ? to : from + (to - from) * k / std::max(1, count - 1)));
  return values;
}

Axis parse_axis(const std::string& text) {
  const size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos) refuse(text, "no name");
  Axis axis{text.substr(0, equals), split_list(text.substr(equals + 1))};
  if (axis.values.size() == 1) axis.values = parse_range(text, equals + 1);
  if (std::any_of(axis.values.begin(), axis.values.end(), [](const std::string& value) { return value.empty(); }))
    refuse(text, "a value is missing");
  return axis;
}

/// "years" of "steps.worn.params.years"; more of it where another axis ends so too.
std::string short_name(const std::vector<Axis>& axes, const Axis& axis) {
  const std::string last = axis.name.substr(axis.name.rfind('.') + 1);
  const auto alike = std::count_if(axes.begin(), axes.end(), [&](const Axis& other) {
    return other.name == last || other.name.ends_with("." + last);
  });
  return alike > 1 ? axis.name : last;
}

}  // namespace

Sweep parse_sweeps(const std::vector<std::string>& texts) {
  std::vector<Axis> axes;
  size_t count = 1;
  for (const std::string& text : texts) {
    axes.push_back(parse_axis(text));
    const auto same = [&](const Axis& axis) { return axis.name == axes.back().name; };
    if (std::count_if(axes.begin(), axes.end(), same) > 1)
      throw InvalidArgument("--sweep", "'" + axes.back().name + "' is given twice");
    count *= axes.back().values.size();
    if (count > kMostRuns)
      throw InvalidArgument("--sweep", fmt::format("these are more than {} runs in all", kMostRuns));
  }
  Sweep sweep;
  sweep.columns = axes.size() > 1 ? static_cast<int>(axes.back().values.size())
                                  : static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count))));
  for (size_t k = 0; k < count; ++k) {
    SweepRun run;
    size_t rest = k, of_slower = count;
    for (const Axis& axis : axes) {
      of_slower /= axis.values.size();
      const std::string& value = axis.values[rest / of_slower];
      rest %= of_slower;
      run.sets.push_back(axis.name + "=" + value);
      run.caption += (run.caption.empty() ? "" : ", ") + short_name(axes, axis) + " = " + value;
    }
    sweep.runs.push_back(std::move(run));
  }
  return sweep;
}

}  // namespace seamount::app
