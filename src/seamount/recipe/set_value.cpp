#include "seamount/recipe/set_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "seamount/base/presets.h"
#include "seamount/base/text.h"
#include "seamount/recipe/domain.h"
#include "seamount/recipe/variables.h"

namespace seamount::recipe {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  size_t begin = 0;
  for (size_t end = text.find(separator); end != std::string::npos; end = text.find(separator, begin)) {
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  parts.push_back(text.substr(begin));
  return parts;
}

std::string text_of(const Json& object, const char* key) {
  return object.is_object() && object.contains(key) && object[key].is_string() ? object[key].get<std::string>() : "";
}

void add_params(const std::vector<ParamInfo>& params, const std::string& prefix, std::vector<std::string>& paths) {
  for (const ParamInfo& info : params) {
    paths.push_back(prefix + info.name);
    if (info.kind == "group") add_params(info.tools[0].params, prefix + info.name + ".", paths);
  }
}

template <class Visit>
void for_each_item(const Json& root, const char* list, Visit visit) {
  if (!root.is_object() || !root.contains(list) || !root[list].is_array()) return;
  for (size_t i = 0; i < root[list].size(); ++i) visit(root[list][i], i);
}

std::vector<std::string> step_ids(const Json& root) {
  std::vector<std::string> ids;
  for_each_item(root, "steps", [&](const Json& step, size_t) {
    if (const std::string id = text_of(step, "id"); !id.empty()) ids.push_back(id);
  });
  return ids;
}

/// Formats that an output may be written as.
std::vector<const OutputFormat*> formats_of(const Json& output, const Registry& registry) {
  if (const auto* named = registry.find_format(text_of(output, "as"))) return {named};
  const std::string extension = std::filesystem::path(text_of(output, "path")).extension().string();
  std::vector<const OutputFormat*> formats;
  for (const auto& format : registry.formats()) {
    if (std::find(format->claims.begin(), format->claims.end(), extension) != format->claims.end())
      formats.push_back(format.get());
  }
  return formats;
}

/// Every path that has a meaning in this document.
std::vector<std::string> settable_paths(const Json& root, const Registry& registry) {
  std::vector<std::string> paths = {"seed"};
  add_params(describe_params<DomainParams>(), "domain.", paths);
  if (root.is_object() && root.contains("variables") && root["variables"].is_object())
    for (const auto& [name, value] : root["variables"].items()) paths.push_back("variables." + name);
  for_each_item(root, "steps", [&](const Json& step, size_t i) {
    const std::string id = text_of(step, "id");
    const std::string prefix = "steps." + (id.empty() ? std::to_string(i) : id) + ".";
    paths.push_back(prefix + "seed");
    paths.push_back(prefix + "bypass");
    if (const Operator* op = registry.find_operator(text_of(step, "op")))
      add_params(op->params, prefix + "params.", paths);
  });
  for_each_item(root, "outputs", [&](const Json& output, size_t i) {
    for (const OutputFormat* format : formats_of(output, registry))
      add_params(format->params, fmt::format("outputs.{}.", i), paths);
  });
  return paths;
}

/// Paths that end as these parts do, with as many of them as any path has; where that is the last alone, those of the
/// step or output that the others name: "relief" and "steps.isle.relief" both mean "steps.isle.params.relief".
std::vector<std::string> paths_ending_so(const std::vector<std::string>& tokens,
                                         const std::vector<std::string>& paths) {
  std::vector<std::string> found;
  for (auto first = tokens.begin(); first != tokens.end() && found.empty(); ++first) {
    const std::string end = fmt::format(".{}", fmt::join(first, tokens.end(), "."));
    for (const std::string& path : paths)
      if (("." + path).ends_with(end)) found.push_back(path);
  }
  const auto named = [&](const std::string& path) {
    return std::any_of(tokens.begin(), tokens.end() - 1, [&](const std::string& token) {
      return token != "steps" && token != "outputs" && path.find("." + token + ".") != std::string::npos;
    });
  };
  std::vector<std::string> of_named;
  std::copy_if(found.begin(), found.end(), std::back_inserter(of_named), named);
  return of_named.empty() ? found : of_named;
}

[[noreturn]] void refuse(const Json& root, const std::string& path, const std::string& why, const Registry& registry) {
  constexpr size_t kMost = 6;
  const std::vector<std::string> paths = settable_paths(root, registry);
  std::vector<std::string> found = paths_ending_so(split(path, '.'), paths);
  if (const auto near = nearest_name(path, paths); found.empty() && near) found = {*near};
  std::string meant;
  for (size_t i = 0; i < std::min(kMost, found.size()); ++i)
    meant += (i == 0 ? "" : i + 1 == found.size() ? " or " : ", ") + ("'" + found[i] + "'");
  if (found.size() > kMost) meant += ", ...";
  const std::vector<std::string> ids = step_ids(root);
  throw InvalidArgument("--set",
                        why + (meant.empty() ? fmt::format("; paths are steps.ID.params.NAME (ID: {}), "
                                                           "outputs.INDEX.NAME, variables.NAME, domain.NAME, seed",
                                                           fmt::join(ids, ", "))
                                             : ", did you mean " + meant + "?"));
}

/// "preset" alone is that of the only step that has presets; other paths, and with several such steps, as they are.
std::string full_path(const Json& root, const std::string& path, const Registry& registry) {
  if (path != kPresetKey) return path;
  std::string found;
  for (const std::string& candidate : settable_paths(root, registry)) {
    if (!candidate.starts_with("steps.") || !candidate.ends_with(".params." + path)) continue;
    if (!found.empty()) return path;
    found = candidate;
  }
  return found.empty() ? path : found;
}

/// The member that a path token names: a key, an index, or the id of a step.
Json* descend(Json& json, const std::string& token, bool create) {
  if (json.is_array()) {
    for (Json& item : json) {
      if (item.is_object() && item.contains("id") && item["id"] == token) return &item;
    }
    const bool digits =
        !token.empty() && token.size() < 7 && token.find_first_not_of("0123456789") == std::string::npos;
    if (digits && std::stoul(token) < json.size()) return &json[std::stoul(token)];
    return nullptr;
  }
  if (json.is_null() && create) json = Json::object();
  if (!json.is_object()) return nullptr;
  if (!json.contains(token) && !create) return nullptr;
  return &json[token];
}

/// A member that no recipe has there.
bool unknown_member(const Json& root, const std::vector<std::string>& tokens) {
  const auto in = [](const std::string& token, std::initializer_list<const char*> known) {
    return std::find(known.begin(), known.end(), token) != known.end();
  };
  if (!in(tokens[0], {"$schema", "seamount", "about", "variables", "domain", "seed", "steps", "outputs"})) return true;
  if (tokens[0] == "steps" && tokens.size() > 2)
    return !in(tokens[2], {"id", "op", "in", "params", "seed", "bypass", "about"});
  if (tokens[0] != "variables" || tokens.size() < 2) return false;
  return !root.contains("variables") || !root["variables"].is_object() || !root["variables"].contains(tokens[1]);
}

/// A variable that is used on the way to a value: the use gets a copy of its own.
void copy_variable(const Json& root, Json& value) {
  const auto name = variable_name(value);
  if (name && root.contains("variables") && root["variables"].is_object() && root["variables"].contains(*name))
    value = Json(root["variables"][*name]);
}

}  // namespace

void set_value(Json& root, const std::string& assignment, const Registry& registry) {
  const size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0)
    refuse(root, assignment.substr(0, equals), "expected PATH=VALUE, found '" + assignment + "'", registry);
  const std::string path = full_path(root, assignment.substr(0, equals), registry);
  const std::string text = assignment.substr(equals + 1);
  const auto tokens = split(path, '.');
  if (root.is_object() && unknown_member(root, tokens))
    refuse(root, path, "there is no '" + path + "' in a recipe like this", registry);
  Json* target = &root;
  bool among_params = false;  // a group that the recipe leaves out may be named
  for (size_t i = 0; i < tokens.size(); ++i) {
    const bool may_create = among_params || i + 1 == tokens.size() || tokens[i] == "params" || tokens[i] == "domain";
    among_params = among_params || tokens[i] == "params" || (tokens[0] == "outputs" && i == 1);
    copy_variable(root, *target);
    target = descend(*target, tokens[i], may_create);
    if (target == nullptr)
      refuse(root, path, "'" + path + "' leads nowhere: the recipe has no '" + tokens[i] + "' there", registry);
  }
  const Json value = Json::parse(text, nullptr, false);
  *target = value.is_discarded() ? Json(text) : value;
}

}  // namespace seamount::recipe
