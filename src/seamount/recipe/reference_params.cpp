#include "seamount/recipe/reference_params.h"

#include <fmt/format.h>

#include "seamount/base/text.h"

namespace seamount::recipe {
namespace {

std::string range_text(const ParamInfo& info) {
  if (!info.choices.empty()) return fmt::format("{}", fmt::join(info.choices, ", "));
  return info.range.bounded() ? format_range(info.range.min, info.range.max) : "";
}

std::string default_text(const ParamInfo& info) {
  if (info.kind == "preset") return "none";
  if (info.default_value.is_null()) return "derived";
  if (info.default_value.is_string() && info.default_value.get<std::string>().empty()) return "none";
  if (info.default_value.is_array() && info.default_value.empty()) return "none";
  if (info.default_value.is_string()) return info.default_value.get<std::string>();
  return info.default_value.dump();
}

/// Rows of a table; the members of a group as group.member.
std::string params_rows(const std::vector<ParamInfo>& params, const std::string& prefix) {
  std::string text;
  for (const ParamInfo& info : params) {
    const std::string shown = info.kind == "group" ? "" : cell("`" + default_text(info) + "`");
    text += fmt::format("| `{}{}` | {} | {} | {} | {} | {} |\n", prefix, info.name, info.kind, info.unit, shown,
                        cell(range_text(info)), cell(info.help));
    if (info.kind == "group") text += params_rows(info.tools[0].params, prefix + info.name + ".");
  }
  return text;
}

/// A paragraph for each preset, those of groups too.
std::string preset_paragraphs(const std::vector<ParamInfo>& params, const std::string& prefix) {
  std::string text;
  for (const ParamInfo& info : params) {
    for (const PresetInfo& preset : info.presets)
      text += fmt::format("`{}{}` `{}`: {} ({}).\n\n", prefix, info.name, preset.name, preset.about,
                          sets_text(preset.sets));
    if (info.kind == "group") text += preset_paragraphs(info.tools[0].params, prefix + info.name + ".");
  }
  return text;
}

}  // namespace

std::string param_text(const ParamInfo& info, const std::string& indent, const std::string& prefix) {
  std::string text = fmt::format("{}{}{} <{}>{}\n{}    {}\n", indent, prefix, info.name, info.kind,
                                 info.unit.empty() ? "" : "  " + info.unit, indent, info.help);
  if (info.kind != "group") {
    const std::string range = range_text(info);
    text += fmt::format("{}    default {}{}\n", indent, default_text(info),
                        range.empty() ? "" : (info.choices.empty() ? "; range " : "; one of ") + range);
  }
  for (const PresetInfo& preset : info.presets) {
    text += fmt::format("{}    {}  {}\n", indent, preset.name, preset.about);
    text += fmt::format("{}        {}\n", indent, sets_text(preset.sets));
  }
  for (const ToolInfo& tool : info.tools) {
    if (!tool.name.empty()) text += fmt::format("{}    \"tool\": \"{}\"  {}\n", indent, tool.name, tool.about);
    const std::string inner_prefix = info.kind == "group" && !prefix.empty() ? prefix + info.name + "." : "";
    const std::string inner_indent = indent + (inner_prefix.empty() ? "      " : "  ");
    for (const ParamInfo& inner : tool.params) text += param_text(inner, inner_indent, inner_prefix);
  }
  return text;
}

std::string cell(std::string text) {
  for (size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.replace(at, 1, "\\|");
  return text;
}

std::string params_table(const std::vector<ParamInfo>& params) {
  if (params.empty()) return "";
  const std::string head = "| parameter | type | unit | default | range | |\n|---|---|---|---|---|---|\n";
  std::string text = head + params_rows(params, "") + "\n" + preset_paragraphs(params, "");
  for (const ParamInfo& info : params) {
    if (info.kind != "tools") continue;
    for (const ToolInfo& tool : info.tools) {
      text += fmt::format("`{}`: `{{\"tool\": \"{}\", ...}}` {}.\n\n", info.name, tool.name, tool.about);
      text += tool.params.empty() ? "" : head + params_rows(tool.params, "") + "\n";
    }
  }
  return text;
}

}  // namespace seamount::recipe
