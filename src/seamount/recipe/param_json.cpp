#include "seamount/recipe/param_json.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "seamount/io/input_file.h"

namespace seamount::recipe {
namespace {

/// [a, b]: two numbers.
bool read_pair(const Json& json, double& first, double& second, const std::string& what, const ReadPlace& place) {
  if (!json.is_array() || json.size() != 2 || !json[0].is_number() || !json[1].is_number()) {
    place.expected(what, json);
    return false;
  }
  first = json[0].get<double>();
  second = json[1].get<double>();
  return true;
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

void read_json(const Json& json, double& value, const ReadPlace& place) {
  if (!json.is_number()) return place.expected("a number", json);
  value = json.get<double>();
}

void read_json(const Json& json, int& value, const ReadPlace& place) {
  const double number = json.is_number() ? json.get<double>() : std::nan("");
  if (!(std::abs(number) <= std::numeric_limits<int>::max()) || number != std::floor(number)) {
    return place.expected("a whole number", json);
  }
  value = static_cast<int>(number);
}

void read_json(const Json& json, bool& value, const ReadPlace& place) {
  if (!json.is_boolean()) return place.expected("true or false", json);
  value = json.get<bool>();
}

void read_json(const Json& json, std::string& value, const ReadPlace& place) {
  if (!json.is_string()) return place.expected("a text", json);
  value = json.get<std::string>();
}

void read_json(const Json& json, FilePath& value, const ReadPlace& place) {
  if (!json.is_string()) return place.expected("a file name", json);
  value.path = json.get<std::string>();
}

void read_json(const Json& json, ModelFile& value, const ReadPlace& place) {
  if (!json.is_string()) return place.expected("the name of a model or a file", json);
  value.name = json.get<std::string>();
}

void read_json(const Json& json, Colour& value, const ReadPlace& place) {
  const std::string text = json.is_string() ? json.get<std::string>() : "";
  std::array<int, 6> digit{};
  bool fits = text.size() == 7 && text[0] == '#';
  for (size_t i = 0; fits && i < 6; ++i) fits = (digit[i] = hex_digit(text[i + 1])) >= 0;
  if (!fits) return place.expected("a colour as \"#rrggbb\"", json);
  const auto channel = [&](size_t i) { return static_cast<unsigned char>(16 * digit[i] + digit[i + 1]); };
  value = {channel(0), channel(2), channel(4)};
}

void read_json(const Json& json, std::optional<double>& value, const ReadPlace& place) {
  if (json.is_null()) {
    value.reset();
  } else if (json.is_number()) {
    value = json.get<double>();
  } else {
    place.expected("a number (or null: derived)", json);
  }
}

void read_json(const Json& json, Vec2& value, const ReadPlace& place) {
  read_pair(json, value.x, value.y, "a point [x, y] in metres", place);
}

void read_json(const Json& json, std::optional<Vec2>& value, const ReadPlace& place) {
  if (json.is_null()) return value.reset();
  Vec2 given;
  if (read_pair(json, given.x, given.y, "a point [x, y] in metres (or null: derived)", place)) value = given;
}

void read_json(const Json& json, Knot& value, const ReadPlace& place) {
  read_pair(json, value.x, value.y, "a knot [x, y]", place);
}

void read_json(const Json& json, Curve& value, const ReadPlace& place) {
  Curve curve;
  const size_t before = place.diagnostics.items().size();
  read_json(json, curve.knots, place);
  if (place.diagnostics.items().size() > before) return;
  for (size_t i = 1; i < curve.knots.size(); ++i) {
    if (!(curve.knots[i - 1].x < curve.knots[i].x)) {
      return place.at(i).fail(fmt::format("x = {} does not follow x = {}: knots ascend",
                                          format_number(curve.knots[i].x), format_number(curve.knots[i - 1].x)));
    }
  }
  value = std::move(curve);
}

void read_json(const Json& json, Stroke& value, const ReadPlace& place) {
  if (!json.is_object()) return place.expected("a stroke {\"points\", \"width_m\", \"strength_m\"}", json);
  refuse_unknown_keys(json, {"points", "width_m", "strength_m"}, "member", place);
  if (const auto points = json.find("points"); points == json.end()) {
    place.fail("a stroke needs \"points\"");
  } else {
    read_json(*points, value.points, place.at("points"));
    if (points->is_array() && points->size() < 2) place.at("points").fail("a stroke needs at least two points");
  }
  if (const auto width = json.find("width_m"); width != json.end()) {
    read_json(*width, value.width_m, place.at("width_m"));
    if (!(value.width_m > 0)) place.at("width_m").fail(format_number(value.width_m) + " is not above 0");
  }
  if (const auto strength = json.find("strength_m"); strength != json.end()) {
    read_json(*strength, value.strength_m, place.at("strength_m"));
  }
}

void read_json(const Json& json, PolarOutline& value, const ReadPlace& place) {
  if (json.is_number()) {
    value.radii_m = {json.get<double>()};
  } else if (json.is_array() && !json.empty()) {
    read_json(json, value.radii_m, place);
  } else {
    place.expected("a radius, or a list of radii at equal steps of angle", json);
  }
}

void read_json(const Json& json, Polygon& value, const ReadPlace& place) {
  if (json.is_array()) return read_json(json, value.outer, place);
  if (!json.is_object()) return place.expected("a ring [[x, y], ...] or {\"outer\", \"holes\"}", json);
  refuse_unknown_keys(json, {"outer", "holes"}, "member", place);
  if (json.contains("outer")) read_json(json["outer"], value.outer, place.at("outer"));
  if (json.contains("holes")) read_json(json["holes"], value.holes, place.at("holes"));
}

void read_json(const Json& json, RegionOutline& value, const ReadPlace& place) {
  if (json.is_array()) return read_json(json, value.ring, place);
  if (!json.is_object()) {
    return place.expected(R"(a ring [[x, y], ...] or {"name", "ring", "height_m", "basin", "peak_m"})", json);
  }
  refuse_unknown_keys(json, {"name", "ring", "height_m", "basin", "peak_m"}, "member", place);
  if (json.contains("name")) read_json(json["name"], value.name, place.at("name"));
  if (json.contains("ring")) {
    read_json(json["ring"], value.ring, place.at("ring"));
  } else {
    place.fail("a region needs \"ring\"");
  }
  if (json.contains("height_m")) read_json(json["height_m"], value.height_m, place.at("height_m"));
  if (json.contains("basin")) read_json(json["basin"], value.basin, place.at("basin"));
  if (json.contains("peak_m")) read_json(json["peak_m"], value.peak_m, place.at("peak_m"));
}

void read_json(const Json& json, RiverLine& value, const ReadPlace& place) {
  if (json.is_array()) return read_json(json, value.points, place);
  if (!json.is_object()) {
    return place.expected(R"(points [[x, y], ...] or {"points", "bed_m", "source_width_m", "mouth_width_m"})", json);
  }
  refuse_unknown_keys(json, {"points", "bed_m", "source_width_m", "mouth_width_m"}, "member", place);
  if (json.contains("points")) {
    read_json(json["points"], value.points, place.at("points"));
  } else {
    place.fail("a river needs \"points\"");
  }
  if (json.contains("bed_m")) read_json(json["bed_m"], value.bed_m, place.at("bed_m"));
  for (const auto& [name, width] :
       {std::pair{"source_width_m", &value.source_width_m}, {"mouth_width_m", &value.mouth_width_m}}) {
    if (!json.contains(name)) continue;
    read_json(json[name], *width, place.at(name));
    if (*width < 0) place.at(name).fail(format_number(*width) + " is below 0");
  }
}

// Whole numbers are written as such, so that 5 and 5.0 give the same canonical text.
Json write_json(double value) {
  constexpr double kLargestExact = 9007199254740992.0;
  if (value == std::floor(value) && std::abs(value) < kLargestExact) return static_cast<int64_t>(value);
  return value;
}
Json write_json(int value) { return value; }
Json write_json(bool value) { return value; }
Json write_json(const std::string& value) { return value; }
Json write_json(const FilePath& value) { return value.path; }
Json write_json(const ModelFile& value) { return value.name; }
Json write_json(const Colour& value) { return fmt::format("#{:02x}{:02x}{:02x}", value.r, value.g, value.b); }
Json write_json(const std::optional<double>& value) { return value ? write_json(*value) : Json(nullptr); }
Json write_json(const Vec2& value) { return {write_json(value.x), write_json(value.y)}; }
Json write_json(const std::optional<Vec2>& value) { return value ? write_json(*value) : Json(nullptr); }
Json write_json(const Knot& value) { return {write_json(value.x), write_json(value.y)}; }
Json write_json(const Curve& value) { return write_json(value.knots); }

Json write_json(const Stroke& value) {
  return {{"points", write_json(value.points)},
          {"width_m", write_json(value.width_m)},
          {"strength_m", write_json(value.strength_m)}};
}

Json write_json(const PolarOutline& value) {
  return value.radii_m.size() == 1 ? write_json(value.radii_m[0]) : write_json(value.radii_m);
}

Json write_json(const Polygon& value) {
  if (value.holes.empty()) return write_json(value.outer);
  return {{"outer", write_json(value.outer)}, {"holes", write_json(value.holes)}};
}

Json write_json(const RegionOutline& value) {
  return {{"name", value.name},
          {"ring", write_json(value.ring)},
          {"height_m", write_json(value.height_m)},
          {"basin", value.basin},
          {"peak_m", write_json(value.peak_m)}};
}

Json write_json(const RiverLine& value) {
  return {{"points", write_json(value.points)},
          {"bed_m", write_json(value.bed_m)},
          {"source_width_m", write_json(value.source_width_m)},
          {"mouth_width_m", write_json(value.mouth_width_m)}};
}

const ParamInfo* find_param(const std::vector<ParamInfo>& infos, std::string_view path) {
  const size_t dot = path.find('.');
  for (const ParamInfo& info : infos) {
    if (info.name != path.substr(0, dot)) continue;
    if (dot == std::string_view::npos) return &info;
    return info.kind == "group" ? find_param(info.tools[0].params, path.substr(dot + 1)) : nullptr;
  }
  return nullptr;
}

void refuse_unknown_keys(const Json& object, const std::vector<std::string>& names, const std::string& what,
                         const ReadPlace& place) {
  for (const auto& [key, value] : object.items()) {
    if (std::find(names.begin(), names.end(), key) != names.end()) continue;
    place.at(pointer_token(key)).fail("unknown " + what + " '" + key + "'" + suggestion(key, names));
  }
}

std::string read_tool_name(const Json& json, const std::vector<std::string>& names, const ReadPlace& place) {
  if (!json.is_object()) {
    place.expected("a tool {\"tool\": name, ...}", json);
    return "";
  }
  const auto tool = json.find("tool");
  if (tool == json.end()) {
    place.fail(fmt::format("\"tool\" is missing: one of {}", fmt::join(names, ", ")));
    return "";
  }
  if (!tool->is_string()) {
    place.at("tool").expected("a tool's name", *tool);
    return "";
  }
  auto name = tool->get<std::string>();
  if (std::find(names.begin(), names.end(), name) != names.end()) return name;
  place.at("tool").fail("unknown tool '" + name + "'" + suggestion(name, names));
  return "";
}

namespace {

/// Calls visit(kind, name) for each file and model.
void visit_names(const std::vector<ParamInfo>& infos, const Json& params,
                 const std::function<void(const std::string& kind, const std::string& name)>& visit) {
  for (const ParamInfo& info : infos) {
    if (info.kind == "preset") continue;  // chooses values, has none itself
    const Json& value = params.at(info.name);
    if (info.kind == "file" || info.kind == "model") {
      if (const auto name = value.get<std::string>(); !name.empty()) visit(info.kind, name);
    } else if (info.kind == "files") {
      for (const Json& name : value) visit("file", name.get<std::string>());
    } else if (info.kind == "group") {
      visit_names(info.tools[0].params, value, visit);
    } else if (info.kind == "groups") {
      for (const Json& item : value) visit_names(info.tools[0].params, item, visit);
    } else if (info.kind == "tools") {
      for (const Json& item : value) {
        for (const ToolInfo& tool : info.tools) {
          if (item.at("tool") == tool.name) visit_names(tool.params, item, visit);
        }
      }
    }
  }
}

}  // namespace

void for_each_file(const std::vector<ParamInfo>& infos, const Json& params,
                   const std::function<void(const std::string&)>& visit) {
  visit_names(infos, params, [&](const std::string& kind, const std::string& name) {
    if (kind == "file" || !ModelFile{name}.is_word()) visit(name);
  });
}

void for_each_model(const std::vector<ParamInfo>& infos, const Json& params,
                    const std::function<void(const std::string&)>& visit) {
  visit_names(infos, params, [&](const std::string& kind, const std::string& name) {
    if (kind == "model" && ModelFile{name}.is_word()) visit(name);
  });
}

namespace {

Json tool_schema(const ToolInfo& tool) {
  Json properties = Json::object();
  for (const ParamInfo& info : tool.params) properties[info.name] = param_schema(info);
  Json schema = {{"type", "object"}, {"additionalProperties", false}};
  if (!tool.name.empty()) {
    properties["tool"] = {{"const", tool.name}};
    schema["required"] = {"tool"};
    schema["description"] = tool.about;
  }
  schema["properties"] = properties;
  return schema;
}

}  // namespace

ParamInfo preset_param(std::vector<PresetInfo> presets) {
  ParamInfo info;
  info.name = kPresetKey;
  info.kind = "preset";
  info.help = "values that belong together, by a word; what is stated besides wins";
  for (const PresetInfo& preset : presets) info.choices.push_back(preset.name);
  info.presets = std::move(presets);
  return info;
}

Json param_schema(const ParamInfo& info) {
  const Json number = {{"type", "number"}};
  const Json pair = {{"type", "array"}, {"items", number}, {"minItems", 2}, {"maxItems", 2}};
  const Json pairs = {{"type", "array"}, {"items", pair}};
  const Json stroke = {{"type", "object"},
                       {"properties", {{"points", pairs}, {"width_m", number}, {"strength_m", number}}},
                       {"required", {"points"}},
                       {"additionalProperties", false}};
  const Json polygon = {{"type", "object"},
                        {"properties", {{"outer", pairs}, {"holes", {{"type", "array"}, {"items", pairs}}}}},
                        {"required", {"outer"}},
                        {"additionalProperties", false}};
  const Json numbers = {{"type", "array"}, {"items", number}};
  const Json region = {{"type", "object"},
                       {"properties",
                        {{"name", {{"type", "string"}}},
                         {"ring", pairs},
                         {"height_m", {{"type", {"number", "null"}}}},
                         {"basin", {{"type", "boolean"}}},
                         {"peak_m", {{"type", {"number", "null"}}}}}},
                       {"required", {"ring"}},
                       {"additionalProperties", false}};
  const Json width = {{"type", "number"}, {"minimum", 0}};
  const Json river = {
      {"type", "object"},
      {"properties", {{"points", pairs}, {"bed_m", numbers}, {"source_width_m", width}, {"mouth_width_m", width}}},
      {"required", {"points"}},
      {"additionalProperties", false}};
  static const std::map<std::string, std::string> kScalars = {
      {"number", "number"}, {"integer", "integer"}, {"switch", "boolean"}, {"choice", "string"}, {"preset", "string"},
      {"text", "string"},   {"file", "string"},     {"model", "string"},   {"colour", "string"}};
  Json schema;
  if (const auto scalar = kScalars.find(info.kind); scalar != kScalars.end()) {
    schema["type"] =
        info.kind == "number" && info.default_value.is_null() ? Json({"number", "null"}) : Json(scalar->second);
    if (!std::isinf(info.range.min)) schema["minimum"] = write_json(info.range.min);
    if (!std::isinf(info.range.max)) schema["maximum"] = write_json(info.range.max);
    if (!info.choices.empty()) schema["enum"] = info.choices;
    if (info.kind == "colour") schema["pattern"] = "^#[0-9a-fA-F]{6}$";
  } else if (info.kind == "numbers") {
    schema = numbers;
  } else if (info.kind == "point") {
    schema = pair;
  } else if (info.kind == "curve" || info.kind == "points") {
    schema = pairs;
  } else if (info.kind == "strokes") {
    schema = {{"type", "array"}, {"items", stroke}};
  } else if (info.kind == "outlines") {
    schema = {{"type", "array"},
              {"items", {{"anyOf", {number, {{"type", "array"}, {"items", number}, {"minItems", 1}}}}}}};
  } else if (info.kind == "polygons") {
    schema = {{"type", "array"}, {"items", {{"anyOf", {pairs, polygon}}}}};
  } else if (info.kind == "regions") {
    schema = {{"type", "array"}, {"items", {{"anyOf", {pairs, region}}}}};
  } else if (info.kind == "rivers") {
    schema = {{"type", "array"}, {"items", {{"anyOf", {pairs, river}}}}};
  } else if (info.kind == "files" || info.kind == "texts") {
    schema = {{"type", "array"}, {"items", {{"type", "string"}}}};
  } else if (info.kind == "integers") {
    schema = {{"type", "array"}, {"items", {{"type", "integer"}}}};
  } else if (info.kind == "group") {
    schema = tool_schema(info.tools[0]);
  } else if (info.kind == "groups") {
    schema = {{"type", "array"}, {"items", tool_schema(info.tools[0])}};
  } else if (info.kind == "tools") {
    Json tools = Json::array();
    for (const ToolInfo& tool : info.tools) tools.push_back(tool_schema(tool));
    schema = {{"type", "array"}, {"items", {{"oneOf", tools}}}};
  }
  schema["description"] = info.help + (info.unit.empty() ? "" : " [" + info.unit + "]");
  if (info.kind != "preset") schema["default"] = info.default_value;
  schema["x-kind"] = info.kind;
  if (!info.unit.empty()) schema["x-unit"] = info.unit;
  return schema;
}

Json parse_flag(const ParamInfo& info, const std::string& text) {
  if (info.kind == "text" || info.kind == "file" || info.kind == "model" || info.kind == "choice" ||
      info.kind == "preset" || info.kind == "colour")
    return text;
  if (!text.empty() && text[0] == '@') {
    const std::string file = text.substr(1);
    try {
      return parse_json(io::read_text(file, kLargestText + 1), file).root;
    } catch (const IoError& error) {
      throw InvalidArgument("--" + info.name, error.what());
    }
  }
  try {
    return parse_json(text, "--" + info.name).root;
  } catch (const RecipeError&) {
    throw InvalidArgument("--" + info.name, "expected a value of the kind '" + info.kind + "', found '" + text + "'");
  }
}

}  // namespace seamount::recipe
