// Field tables: a parameter is documented once. A Params struct is an aggregate with sensible defaults and one table
//
//   struct CoralParams {
//     double subsidence = 0.0;
//     static constexpr auto fields() {
//       return std::tuple(field(&CoralParams::subsidence, "subsidence", "", between(0, 1), "share that has sunk"));
//     }
//   };
//
// from which range checks (here), recipe parsing, schema, command-line flags, help, reference pages and the studio's
// panels are generated. Member types: double, int, bool, std::string, FilePath, Colour, an enum with a Choices table,
// std::optional<double> (absent: derived), a std::vector of double, int or std::string, what people draw
// (model/drawn.h), another Params struct (a group of parameters that belong together), a std::vector of such (a list of
// groups), and a list of tools: a vector of std::variant of Params structs, each with a name and one line about it,
// written {"tool": "warp", ...}:
//
//   struct WarpTool {
//     static constexpr std::string_view kTool = "warp", kAbout = "drags contours along a stroke";
//     ... members and fields() as above
//   };
//
// A parameter that is renamed leaves its old name behind, so that what people have written is still read:
//
//   static constexpr std::array kFormerNames = {FormerName{"creep_m2", "creep_m2_yr"}};
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/text.h"

namespace seamount {

/// Allowed values, both ends included.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  constexpr bool bounded() const {
    return min > -std::numeric_limits<double>::infinity() || max < std::numeric_limits<double>::infinity();
  }
};

constexpr Range between(double min, double max) { return {min, max}; }
constexpr Range at_least(double min) { return {min, std::numeric_limits<double>::infinity()}; }

/// One row of a field table. For drawn things the unit and range hold for their values (a curve's y, say).
template <class Params, class T>
struct Field {
  using Type = T;
  T Params::*member;
  std::string_view name;
  std::string_view unit;  ///< "m", "deg", "1/m"; empty: a plain number, or no number at all
  Range range;
  std::string_view help;  ///< one line, no full stop
};

template <class Params, class T>
constexpr Field<Params, T> field(T Params::*member, std::string_view name, std::string_view unit, Range range,
                                 std::string_view help) {
  return {member, name, unit, range, help};
}

template <class Params, class T>
constexpr Field<Params, T> field(T Params::*member, std::string_view name, std::string_view help) {
  return {member, name, "", {}, help};
}

/// Names of an enum's enumerators, in order from 0, spelt as in JSON. Specialise beside the enum:
///   template <> struct Choices<Tint> { static constexpr std::array<std::string_view, 2> names = {"land", "depth"}; };
template <class Enum>
struct Choices;

template <class T>
concept Choice = std::is_enum_v<T> && requires {
  Choices<T>::names;
};

/// Calls visit(field) for each row of Params' table, in order.
template <class Params, class Visitor>
constexpr void for_each_field(Visitor&& visit) {
  std::apply([&](const auto&... row) { (visit(row), ...); }, Params::fields());
}

/// A name that a parameter had in earlier versions.
struct FormerName {
  std::string_view name;  ///< as it was written beside the others: "creep_m2"
  std::string_view now;   ///< as it is, a path where it moved into a group: "walk.stickiness"
  double factor = 1.0;    ///< what a number is multiplied with, where the unit changed
};

/// Former names of Params' own rows; those of its groups are their own.
template <class Params>
constexpr std::span<const FormerName> former_names() {
  if constexpr (requires { Params::kFormerNames; }) {
    return Params::kFormerNames;
  } else {
    return {};
  }
}

/// A struct with a field table.
template <class T>
concept HasFields = requires {
  T::fields();
};

/// A struct with a field table and a name under which it stands in a list of tools.
template <class T>
concept NamedTool = HasFields<T> && requires {
  { T::kTool } -> std::convertible_to<std::string_view>;
  { T::kAbout } -> std::convertible_to<std::string_view>;
};

/// Is T a std::variant of tools?
template <class T>
inline constexpr bool is_tool_choice = false;
template <NamedTool... Tools>
inline constexpr bool is_tool_choice<std::variant<Tools...>> = true;

template <class T>
concept ToolChoice = is_tool_choice<T>;

template <class Params>
void check_params(const Params& params, const std::string& prefix = "");

namespace detail {

inline void check_number(std::string_view name, double value, Range range) {
  if (std::isfinite(value) && value >= range.min && value <= range.max) return;
  throw InvalidArgument(std::string(name), format_number(value) + " is outside " + format_range(range.min, range.max));
}

/// Drawn things say which of their numbers a range holds for by a free function for_each_number(value, f) (found by
/// ADL).
template <class T>
void check_value(std::string_view name, const T& value, Range range) {
  if constexpr (std::is_same_v<T, bool> || std::is_enum_v<T>) {
    // Every value is allowed.
  } else if constexpr (std::is_arithmetic_v<T>) {
    check_number(name, static_cast<double>(value), range);
  } else if constexpr (std::is_same_v<T, std::optional<double>>) {
    if (value) check_number(name, *value, range);
  } else if constexpr (std::is_same_v<T, std::vector<double>> || std::is_same_v<T, std::vector<int>>) {
    for (const auto number : value) check_number(name, number, range);
  } else if constexpr (HasFields<T>) {
    check_params(value, std::string(name) + ".");
  } else if constexpr (requires { requires HasFields<typename T::value_type>; }) {
    for (size_t i = 0; i < value.size(); ++i)
      check_params(value[i], std::string(name) + "[" + std::to_string(i) + "].");
  } else if constexpr (requires { requires ToolChoice<typename T::value_type>; }) {
    for (size_t i = 0; i < value.size(); ++i) {
      const std::string place = std::string(name) + "[" + std::to_string(i) + "].";
      std::visit([&](const auto& tool) { check_params(tool, place); }, value[i]);
    }
  } else if constexpr (requires { for_each_number(value, [](double) {}); }) {
    for_each_number(value, [&](double number) { check_number(name, number, range); });
  }
}

}  // namespace detail

/// Throws InvalidArgument{field} for the first member outside its range: "subsidence: 1.5 is outside [0, 1]"; members
/// of a group and of tools by their path: "edits[2].radius_m". Operators call it first.
template <class Params>
void check_params(const Params& params, const std::string& prefix) {
  for_each_field<Params>([&](const auto& row) {
    detail::check_value(prefix.empty() ? row.name : std::string_view(prefix + std::string(row.name)),
                        params.*row.member, row.range);
  });
}

}  // namespace seamount
