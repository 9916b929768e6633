#include "seamount/recipe/domain.h"
#include "seamount/recipe/output_water.h"
#include "seamount/recipe/recipe.h"

namespace seamount::recipe {
namespace {

const char* const kVariable = "^\\$[A-Za-z_][A-Za-z0-9_]*$";

/// The schema of a value where "$name" may stand too, in it and in the members of a group.
Json or_variable(Json schema) {
  if (schema.contains("properties"))
    for (auto& [name, member] : schema["properties"].items()) member = or_variable(member);
  if (schema.contains("enum")) {
    schema["anyOf"] = {{{"enum", schema["enum"]}}, {{"pattern", kVariable}}};
    schema.erase("enum");
  } else if (schema.contains("pattern")) {
    schema["pattern"] = schema["pattern"].get<std::string>() + "|" + kVariable;
  } else if (schema.value("type", Json()) != "string") {
    Json types = schema["type"].is_array() ? schema["type"] : Json::array({schema["type"]});
    types.push_back("string");
    schema["type"] = types;
    schema["pattern"] = kVariable;
  }
  return schema;
}

Json params_schema(const std::vector<ParamInfo>& params) {
  Json properties = Json::object();
  for (const ParamInfo& info : params) properties[info.name] = or_variable(param_schema(info));
  return {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
}

const char* const kSource = "^[A-Za-z0-9_-]+(\\.[A-Za-z0-9_]+)?$";

Json source_schema() {
  return {{"anyOf",
           {{{"type", "string"}, {"pattern", kSource}, {"description", "\"step.port\", or \"step\""}},
            {{"type", "object"},
             {"properties", {{"file", {{"type", "string"}}}}},
             {"required", {"file"}},
             {"additionalProperties", false}}}}};
}

Json step_schema(const Operator& op) {
  Json in = Json::object();
  Json required = Json::array();
  for (const Port& port : op.in) {
    in[port.name] = source_schema();
    in[port.name]["description"] = port.help;
    in[port.name]["x-kind"] = port.kind->name;
    if (port.required) required.push_back(port.name);
  }
  Json schema = {
      {"type", "object"},
      {"description", op.summary},
      {"x-looks", op.looks.empty() ? "at everything" : op.looks},
      {"properties",
       {{"id", {{"type", "string"}, {"pattern", "^[A-Za-z0-9_-]{1,64}$"}}},
        {"op", {{"const", op.name}}},
        {"about", {{"type", "string"}}},
        {"seed", {{"type", "integer"}, {"minimum", 0}}},
        {"bypass", {{"type", "boolean"}, {"description", "leave the step out: what it would be given is passed on"}}},
        {"in",
         {{"type", {"object", "string", "array"}},
          {"items", {{"type", "string"}}},
          {"pattern", kSource},
          {"description",
           "inputs, or a step whose outputs go to the inputs of the same names; left out: the step before"},
          {"properties", in},
          {"required", required},
          {"additionalProperties", false}}},
        {"params", params_schema(op.params)}}},
      {"required", {"id", "op"}},
      {"additionalProperties", false}};
  if (!op.in_tiles.empty()) schema["x-in-tiles"] = op.in_tiles;
  return schema;
}

Json output_schema(const Registry& registry, const OutputFormat& format) {
  Json schema = params_schema(format.params);
  schema["description"] = format.summary;
  schema["properties"]["from"] = source_schema();
  schema["properties"]["labels"] = source_schema();
  for (const std::string& water : waters_of(registry, format))
    schema["properties"][water] = {
        {"type", {"string", "object", "boolean"}},
        {"description", "drawn in the picture: a step's, or true or parameters: found in the terrain"}};
  schema["properties"]["about"] = {{"type", "string"}};
  schema["properties"]["path"] = {{"type", "string"}};
  schema["properties"]["as"] = {{"const", format.name}};
  schema["required"] = {"path"};
  if (format.claims.empty()) schema["required"].push_back("as");
  return schema;
}

}  // namespace

Json recipe_schema(const Registry& registry) {
  Json steps = Json::array();
  for (const auto& op : registry.operators()) steps.push_back(step_schema(*op));
  Json outputs = Json::array();
  for (const auto& format : registry.formats()) outputs.push_back(output_schema(registry, *format));
  return {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
          {"title", "Seamount recipe"},
          {"type", "object"},
          {"properties",
           {{"$schema", {{"type", "string"}}},
            {"seamount", {{"const", 1}}},
            {"about", {{"type", "string"}}},
            {"variables",
             {{"type", "object"},
              {"description", "values by name, used as \"$name\""},
              {"propertyNames", {{"pattern", "^[A-Za-z_][A-Za-z0-9_]*$"}}}}},
            {"domain", params_schema(describe_params<DomainParams>())},
            {"seed", {{"type", "integer"}, {"minimum", 0}}},
            {"steps", {{"type", "array"}, {"items", {{"oneOf", steps}}}}},
            {"outputs", {{"type", "array"}, {"items", {{"anyOf", outputs}}}}}}},
          {"required", {"seamount", "steps"}},
          {"additionalProperties", false}};
}

}  // namespace seamount::recipe
