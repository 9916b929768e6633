// The bridge between field tables and JSON: one read, write and schema rule per type of parameter. From them come
// recipe parsing with all its errors at once, canonical parameters for the cache key, the JSON Schema and the reference
// pages.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/base/presets.h"
#include "seamount/model/drawn.h"
#include "seamount/model/model_file.h"
#include "seamount/recipe/diagnostics.h"
#include "seamount/recipe/former_names.h"
#include "seamount/recipe/json_document.h"
#include "seamount/recipe/preset_json.h"

namespace seamount::recipe {

// One overload per parameter type; each reports to `place` and leaves `value` as it was when the JSON does not fit.
void read_json(const Json& json, double& value, const ReadPlace& place);
void read_json(const Json& json, int& value, const ReadPlace& place);
void read_json(const Json& json, bool& value, const ReadPlace& place);
void read_json(const Json& json, std::string& value, const ReadPlace& place);
void read_json(const Json& json, FilePath& value, const ReadPlace& place);
void read_json(const Json& json, ModelFile& value, const ReadPlace& place);
void read_json(const Json& json, Colour& value, const ReadPlace& place);
void read_json(const Json& json, std::optional<double>& value, const ReadPlace& place);
void read_json(const Json& json, Vec2& value, const ReadPlace& place);
void read_json(const Json& json, std::optional<Vec2>& value, const ReadPlace& place);
void read_json(const Json& json, Knot& value, const ReadPlace& place);
void read_json(const Json& json, Curve& value, const ReadPlace& place);
void read_json(const Json& json, Stroke& value, const ReadPlace& place);
void read_json(const Json& json, PolarOutline& value, const ReadPlace& place);
void read_json(const Json& json, Polygon& value, const ReadPlace& place);
void read_json(const Json& json, RegionOutline& value, const ReadPlace& place);
void read_json(const Json& json, RiverLine& value, const ReadPlace& place);

Json write_json(double value);
Json write_json(int value);
Json write_json(bool value);
Json write_json(const std::string& value);
Json write_json(const FilePath& value);
Json write_json(const ModelFile& value);
Json write_json(const Colour& value);
Json write_json(const std::optional<double>& value);
Json write_json(const Vec2& value);
Json write_json(const std::optional<Vec2>& value);
Json write_json(const Knot& value);
Json write_json(const Curve& value);
Json write_json(const Stroke& value);
Json write_json(const PolarOutline& value);
Json write_json(const Polygon& value);
Json write_json(const RegionOutline& value);
Json write_json(const RiverLine& value);

template <HasFields T>
void read_json(const Json& json, T& value, const ReadPlace& place);
template <HasFields T>
Json write_json(const T& value);
template <NamedTool... Tools>
void read_json(const Json& json, std::variant<Tools...>& value, const ReadPlace& place);
template <NamedTool... Tools>
Json write_json(const std::variant<Tools...>& value);

template <class T>
void read_json(const Json& json, std::vector<T>& value, const ReadPlace& place) {
  if (!json.is_array()) return place.expected("a list", json);
  std::vector<T> items(json.size());
  for (size_t i = 0; i < json.size(); ++i) read_json(json[i], items[i], place.at(i));
  value = std::move(items);
}

template <class T>
Json write_json(const std::vector<T>& value) {
  Json list = Json::array();
  for (const T& item : value) list.push_back(write_json(item));
  return list;
}

template <Choice T>
void read_json(const Json& json, T& value, const ReadPlace& place) {
  if (!json.is_string()) return place.expected("a name", json);
  const auto name = json.get<std::string>();
  const std::vector<std::string> names(Choices<T>::names.begin(), Choices<T>::names.end());
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return place.fail("unknown choice '" + name + "'" + suggestion(name, names));
  value = static_cast<T>(found - names.begin());
}

template <Choice T>
Json write_json(T value) {
  return std::string(Choices<T>::names[static_cast<size_t>(value)]);
}

struct ToolInfo;

/// What a row of a field table says, without its C++ types.
struct ParamInfo {
  std::string name;
  /// "number", "integer", "switch", "choice", "preset", "text", "file", "colour", "numbers", "curve", ...
  std::string kind;
  std::string unit;
  Range range;
  std::vector<std::string> choices;
  std::string help;
  Json default_value;
  std::vector<ToolInfo> tools;      ///< of the kind "tools": each of them; of "group" and "groups": one without a name
  std::vector<PresetInfo> presets;  ///< of the kind "preset", which is no parameter but chooses values for some
};

/// A struct with a field table within a parameter.
struct ToolInfo {
  std::string name;
  std::string about;  ///< one line, no full stop
  std::vector<ParamInfo> params;
};

/// Kind of a parameter type, as the studio and the reference pages name it.
template <class T>
constexpr std::string_view param_kind() {
  if constexpr (std::is_same_v<T, bool>)
    return "switch";
  else if constexpr (std::is_same_v<T, int>)
    return "integer";
  else if constexpr (std::is_same_v<T, double> || std::is_same_v<T, std::optional<double>>)
    return "number";
  else if constexpr (std::is_same_v<T, std::string>)
    return "text";
  else if constexpr (std::is_same_v<T, FilePath>)
    return "file";
  else if constexpr (std::is_same_v<T, ModelFile>)
    return "model";
  else if constexpr (std::is_same_v<T, std::vector<FilePath>>)
    return "files";
  else if constexpr (std::is_same_v<T, Colour>)
    return "colour";
  else if constexpr (std::is_same_v<T, Vec2> || std::is_same_v<T, std::optional<Vec2>>)
    return "point";
  else if constexpr (std::is_same_v<T, Curve>)
    return "curve";
  else if constexpr (std::is_same_v<T, std::vector<double>>)
    return "numbers";
  else if constexpr (std::is_same_v<T, std::vector<int>>)
    return "integers";
  else if constexpr (std::is_same_v<T, std::vector<std::string>>)
    return "texts";
  else if constexpr (std::is_same_v<T, Polyline>)
    return "points";
  else if constexpr (std::is_same_v<T, std::vector<Stroke>>)
    return "strokes";
  else if constexpr (std::is_same_v<T, std::vector<PolarOutline>>)
    return "outlines";
  else if constexpr (std::is_same_v<T, std::vector<Polygon>>)
    return "polygons";
  else if constexpr (std::is_same_v<T, std::vector<RegionOutline>>)
    return "regions";
  else if constexpr (std::is_same_v<T, std::vector<RiverLine>>)
    return "rivers";
  else if constexpr (HasFields<T>)
    return "group";
  else if constexpr (requires { requires HasFields<typename T::value_type>; })
    return "groups";
  else if constexpr (requires { requires ToolChoice<typename T::value_type>; })
    return "tools";
  else {
    static_assert(Choice<T>, "give the type a kind, a read_json and a write_json");
    return "choice";
  }
}

template <class Params>
Json write_params(const Params& params);

/// The row by which one of these presets is chosen.
ParamInfo preset_param(std::vector<PresetInfo> presets);

template <class Params>
std::vector<PresetInfo> describe_presets() {
  std::vector<PresetInfo> infos;
  for (const auto& row : Params::presets()) {
    Params params;
    row.set(params);
    infos.push_back(
        {std::string(row.name), std::string(row.about), changed_members(write_params(Params{}), write_params(params))});
  }
  return infos;
}

template <class Params>
std::vector<ParamInfo> describe_params();

template <class Choice>
struct ToolsOf;
template <NamedTool... Tools>
struct ToolsOf<std::variant<Tools...>> {
  static std::vector<ToolInfo> describe() {
    return {ToolInfo{std::string(Tools::kTool), std::string(Tools::kAbout), describe_params<Tools>()}...};
  }
};

template <class Params>
std::vector<ParamInfo> describe_params() {
  std::vector<ParamInfo> infos;
  if constexpr (HasPresets<Params>) infos.push_back(preset_param(describe_presets<Params>()));
  const Params defaults;
  for_each_field<Params>([&](const auto& row) {
    using T = typename std::decay_t<decltype(row)>::Type;
    ParamInfo info{std::string(row.name),
                   std::string(param_kind<T>()),
                   std::string(row.unit),
                   row.range,
                   {},
                   std::string(row.help),
                   write_json(defaults.*row.member),
                   {},
                   {}};
    if constexpr (Choice<T>) info.choices.assign(Choices<T>::names.begin(), Choices<T>::names.end());
    if constexpr (HasFields<T>) info.tools = {{"", "", describe_params<T>()}};
    if constexpr (requires { requires HasFields<typename T::value_type>; })
      info.tools = {{"", "", describe_params<typename T::value_type>()}};
    if constexpr (requires { requires ToolChoice<typename T::value_type>; }) {
      info.tools = ToolsOf<typename T::value_type>::describe();
    }
    infos.push_back(std::move(info));
  });
  return infos;
}

/// A former name of a parameter, and which one it was.
struct FormerParam {
  std::string name;  ///< a path, as it was written on the command line
  ParamInfo info;    ///< of the present parameter, but for its name: that is the path
};

/// The parameter at a path such as "walk.stickiness"; nullptr if there is none.
const ParamInfo* find_param(const std::vector<ParamInfo>& infos, std::string_view path);

/// Former names of Params' own rows (those of its groups are read in documents only).
template <class Params>
std::vector<FormerParam> describe_former_names() {
  const std::vector<ParamInfo> infos = describe_params<Params>();
  std::vector<FormerParam> former;
  for (const FormerName& row : former_names<Params>()) {
    ParamInfo info = *find_param(infos, row.now);
    info.name = row.now;
    former.push_back({std::string(row.name), std::move(info)});
  }
  return former;
}

/// Reports members of `object` that are not in `names`, with a suggestion.
void refuse_unknown_keys(const Json& object, const std::vector<std::string>& names, const std::string& what,
                         const ReadPlace& place);

/// Gives params the values of the preset that an object names; reports one that there is not.
template <HasPresets Params>
void apply_preset(const Json& object, Params& params, const ReadPlace& place) {
  const auto presets = Params::presets();
  std::vector<std::string> names;
  names.reserve(std::size(presets));
  for (const auto& row : presets) names.emplace_back(row.name);
  const std::optional<size_t> chosen = read_preset(object, names, place);
  if (chosen) presets[*chosen].set(params);
}

/// Reads a whole Params: unknown keys, wrong types and values out of range are all reported, former names are noted.
/// What is not stated has the value of the preset that is named, else that of `params`.
template <class Params>
Params read_params(const Json& given, const ReadPlace& place, Params params = {}) {
  if (!given.is_object()) {
    place.expected("an object of parameters", given);
    return params;
  }
  PresentNames present(given, former_names<Params>(), place);
  const Json& object = present.object();
  std::vector<std::string> names;
  if constexpr (HasPresets<Params>) {
    names.emplace_back(kPresetKey);
    apply_preset(object, params, place);
  }
  for_each_field<Params>([&](const auto& row) {
    names.emplace_back(row.name);
    const auto member = object.find(std::string(row.name));
    if (member == object.end()) return;
    const ReadPlace here = place.at(pointer_token(row.name));
    const size_t before = here.diagnostics.items().size();
    read_json(*member, params.*row.member, here);
    if (here.diagnostics.items().size() > before) return;
    try {
      seamount::detail::check_value(row.name, params.*row.member, row.range);
    } catch (const InvalidArgument& error) {
      here.fail(error.what());
    }
  });
  refuse_unknown_keys(object, names, "parameter", place);
  present.move_defects();
  return params;
}

template <class Params>
Json write_params(const Params& params) {
  Json object = Json::object();
  for_each_field<Params>([&](const auto& row) { object[std::string(row.name)] = write_json(params.*row.member); });
  return object;
}

template <HasFields T>
void read_json(const Json& json, T& value, const ReadPlace& place) {
  value = read_params<T>(json, place, value);
}

template <HasFields T>
Json write_json(const T& value) {
  return write_params(value);
}

/// The member "tool" of a tool's object, checked against the names that there are; empty after a defect.
std::string read_tool_name(const Json& json, const std::vector<std::string>& names, const ReadPlace& place);

template <NamedTool... Tools>
void read_json(const Json& json, std::variant<Tools...>& value, const ReadPlace& place) {
  const std::string name = read_tool_name(json, {std::string(Tools::kTool)...}, place);
  if (name.empty()) return;
  Json rest = json;
  rest.erase("tool");
  const auto read_if_named = [&]<class Tool>(std::type_identity<Tool>) {
    if (name == Tool::kTool) value = read_params<Tool>(rest, place);
  };
  (read_if_named(std::type_identity<Tools>{}), ...);
}

template <NamedTool... Tools>
Json write_json(const std::variant<Tools...>& value) {
  return std::visit(
      [](const auto& tool) {
        Json object = write_params(tool);
        object["tool"] = std::string(tool.kTool);
        return object;
      },
      value);
}

/// Calls visit(name) for each file that complete parameters name, those of groups and tools too; empty names are none.
void for_each_file(const std::vector<ParamInfo>& infos, const Json& params,
                   const std::function<void(const std::string&)>& visit);
/// The same for each model that is named by its word; those named by their file are files.
void for_each_model(const std::vector<ParamInfo>& infos, const Json& params,
                    const std::function<void(const std::string&)>& visit);

/// JSON Schema (2020-12) of one parameter.
Json param_schema(const ParamInfo& info);

/// What a user types on the command line, as JSON: --subsidence 0.5, --coast kauai.geojson, --strokes '[...]' or
/// --strokes @file.json. Throws InvalidArgument with the parameter's name.
Json parse_flag(const ParamInfo& info, const std::string& text);

}  // namespace seamount::recipe
