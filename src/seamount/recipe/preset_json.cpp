#include "seamount/recipe/preset_json.h"

#include <algorithm>

#include "seamount/base/presets.h"

namespace seamount::recipe {

Json changed_members(const Json& before, const Json& now) {
  Json changed = Json::object();
  for (const auto& [name, value] : now.items()) {
    const Json& old = before.at(name);
    if (value == old) continue;
    changed[name] = value.is_object() && old.is_object() ? changed_members(old, value) : value;
  }
  return changed;
}

std::optional<size_t> read_preset(const Json& object, const std::vector<std::string>& names, const ReadPlace& place) {
  const auto member = object.find(std::string(kPresetKey));
  if (member == object.end()) return std::nullopt;
  const ReadPlace here = place.at(std::string(kPresetKey));
  if (!member->is_string()) {
    here.expected("the name of a preset", *member);
    return std::nullopt;
  }
  const auto name = member->get<std::string>();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<size_t>(found - names.begin());
  here.fail("unknown preset '" + name + "'" + suggestion(name, names));
  return std::nullopt;
}

std::string sets_text(const Json& sets, const std::string& group) {
  std::string text;
  for (const auto& [name, value] : sets.items()) {
    if (!text.empty()) text += ", ";
    if (value.is_object())
      text += sets_text(value, group + name + ".");
    else
      text += group + name + " " + (value.is_string() ? value.get<std::string>() : value.dump());
  }
  return text;
}

}  // namespace seamount::recipe
