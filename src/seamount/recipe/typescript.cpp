#include "seamount/recipe/typescript.h"

#include <fmt/format.h>

#include <map>

namespace seamount::recipe {
namespace {

const char* const kHead = R"(// Made by `seamount schema typescript`; see src/seamount/recipe/typescript.h.

/** x east, y north, metres. */
export type Point = [number, number];
export type Curve = Point[];
/** A colour as "#rrggbb". */
export type Colour = string;
export interface Stroke {
  points: Point[];
  width_m?: number;
  strength_m?: number;
}
export type PolarOutline = number | number[];
export type Polygon = Point[] | { outer: Point[]; holes?: Point[][] };
export type Region =
  | Point[]
  | { name?: string; ring: Point[]; height_m?: number | null; peak_m?: number | null; basin?: boolean };
export type River = Point[] | { points: Point[]; bed_m?: number[]; source_width_m?: number; mouth_width_m?: number };

)";

std::string members(const std::vector<ParamInfo>& params, const std::string& indent);

std::string choice_type(const std::vector<std::string>& choices) {
  std::string text;
  for (const std::string& choice : choices) text += (text.empty() ? "\"" : " | \"") + choice + "\"";
  return text.empty() ? "string" : text;
}

std::string tool_type(const ToolInfo& tool, const std::string& indent) {
  const std::string name = tool.name.empty() ? "" : fmt::format("{}  tool: \"{}\";\n", indent, tool.name);
  return "{\n" + name + members(tool.params, indent + "  ") + indent + "}";
}

std::string type_of(const ParamInfo& info, const std::string& indent) {
  static const std::map<std::string, std::string> kTypes = {
      {"number", "number"},      {"integer", "number"},   {"switch", "boolean"},   {"text", "string"},
      {"file", "string"},        {"model", "string"},     {"files", "string[]"},   {"colour", "Colour"},
      {"point", "Point"},        {"curve", "Curve"},      {"numbers", "number[]"}, {"integers", "number[]"},
      {"texts", "string[]"},     {"points", "Point[]"},   {"strokes", "Stroke[]"}, {"outlines", "PolarOutline[]"},
      {"polygons", "Polygon[]"}, {"regions", "Region[]"}, {"rivers", "River[]"}};
  if (const auto found = kTypes.find(info.kind); found != kTypes.end())
    return info.default_value.is_null() && info.kind != "preset" ? found->second + " | null" : found->second;
  if (info.kind == "group") return tool_type(info.tools[0], indent);
  if (info.kind == "groups") return tool_type(info.tools[0], indent) + "[]";
  if (info.kind == "tools") {
    std::string either;
    for (const ToolInfo& tool : info.tools) either += "\n" + indent + "  | " + tool_type(tool, indent + "    ");
    return "(" + either + "\n" + indent + ")[]";
  }
  return choice_type(info.choices);
}

std::string members(const std::vector<ParamInfo>& params, const std::string& indent) {
  std::string text;
  for (const ParamInfo& info : params) {
    const std::string unit = info.unit.empty() ? "" : " [" + info.unit + "]";
    text +=
        fmt::format("{}/** {}{} */\n{}{}?: {};\n", indent, info.help, unit, indent, info.name, type_of(info, indent));
  }
  return text;
}

}  // namespace

std::string typescript_types(const Registry& registry) {
  std::string text = kHead;
  text += "export interface OperatorParams {\n";
  for (const auto& op : registry.operators())
    text += fmt::format("  /** {} */\n  \"{}\": {{\n{}  }};\n", op->summary, op->name, members(op->params, "    "));
  text += "}\n\nexport type OperatorName = keyof OperatorParams;\n";
  return text;
}

}  // namespace seamount::recipe
