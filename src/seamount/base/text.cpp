#include "seamount/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace seamount {
namespace {

/// Optimal string alignment distance: insertions, deletions, substitutions and swaps of neighbours.
size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<size_t>> d(a.size() + 1, std::vector<size_t>(b.size() + 1));
  for (size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t cost = a[i - 1] == b[j - 1] ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + cost});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

/// The name without the dashes of a flag.
std::string_view bare(std::string_view name) {
  while (name.starts_with('-')) name.remove_prefix(1);
  return name;
}

/// Candidates of which `name` is some of the parts between these separators.
std::vector<std::string> names_with_part(std::string_view name, const std::vector<std::string>& candidates,
                                         std::string_view separators) {
  const std::string_view part = bare(name);
  std::vector<std::string> found;
  const auto parts = [&](std::string_view whole, size_t i) {
    return i >= whole.size() || separators.find(whole[i]) != std::string_view::npos;
  };
  for (const std::string& candidate : candidates) {
    const std::string_view whole = bare(candidate);
    for (size_t at = part.empty() ? whole.npos : whole.find(part); at != whole.npos; at = whole.find(part, at + 1)) {
      if ((at > 0 && !parts(whole, at - 1)) || !parts(whole, at + part.size())) continue;
      found.push_back(candidate);
      break;
    }
  }
  return found;
}

/// ", did you mean 'A', 'B' or 'C'?" of at most six.
std::string question(const std::vector<std::string>& names) {
  constexpr size_t kMost = 6;
  const size_t shown = std::min(kMost, names.size());
  std::string text = ", did you mean ";
  for (size_t i = 0; i < shown; ++i) text += (i == 0 ? "'" : i + 1 == names.size() ? " or '" : ", '") + names[i] + "'";
  return text + (names.size() > shown ? ", ...?" : "?");
}

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else if (c == '"')
      escaped += "&quot;";
    else if (static_cast<unsigned char>(c) >= ' ')
      escaped += c;
  }
  return escaped;
}

std::string format_number(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return fmt::format("{}", value);
}

std::string format_range(double min, double max) {
  return (std::isinf(min) ? "(-inf" : "[" + format_number(min)) + ", " +
         (std::isinf(max) ? "inf)" : format_number(max) + "]");
}

std::optional<std::string> nearest_name(std::string_view name, std::span<const std::string> candidates) {
  constexpr size_t kLongestName = 64;  // keeps the cost of hostile input bounded
  if (name.size() > kLongestName) return std::nullopt;
  std::optional<std::string> best;
  size_t best_distance = std::max<size_t>(2, name.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const size_t distance = edit_distance(name, candidate);
    if (distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

std::string suggestion(std::string_view name, const std::vector<std::string>& candidates) {
  if (candidates.empty()) return "";
  if (const auto whole_parts = names_with_part(name, candidates, "."); !whole_parts.empty())
    return question(whole_parts);
  if (const auto near = nearest_name(name, candidates)) return question({*near});
  if (const auto words = names_with_part(name, candidates, "._-"); !words.empty()) return question(words);
  constexpr size_t kMostNames = 12;
  std::string text = ", known are: ";
  for (size_t i = 0; i < std::min(kMostNames, candidates.size()); ++i) text += (i == 0 ? "" : ", ") + candidates[i];
  if (candidates.size() > kMostNames) text += ", ...";
  return text;
}

}  // namespace seamount
