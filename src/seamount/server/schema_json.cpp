#include "seamount/server/schema_json.h"

#include <cmath>

#include "seamount/base/version.h"
#include "seamount/recipe/domain.h"

namespace seamount::server {
namespace {

using recipe::Json;

Json params_json(const std::vector<recipe::ParamInfo>& params);

Json param_json(const recipe::ParamInfo& info) {
  Json json = {{"name", info.name},
               {"kind", info.kind},
               {"unit", info.unit},
               {"help", info.help},
               {"default", info.default_value}};
  if (std::isfinite(info.range.min)) json["min"] = info.range.min;
  if (std::isfinite(info.range.max)) json["max"] = info.range.max;
  if (!info.choices.empty()) json["choices"] = info.choices;
  for (const recipe::ToolInfo& tool : info.tools)
    json["tools"].push_back({{"name", tool.name}, {"about", tool.about}, {"params", params_json(tool.params)}});
  for (const recipe::PresetInfo& preset : info.presets)
    json["presets"].push_back({{"name", preset.name}, {"about", preset.about}, {"values", preset.sets}});
  return json;
}

Json params_json(const std::vector<recipe::ParamInfo>& params) {
  Json list = Json::array();
  for (const recipe::ParamInfo& info : params) list.push_back(param_json(info));
  return list;
}

Json ports_json(const std::vector<recipe::Port>& ports) {
  Json list = Json::array();
  for (const recipe::Port& port : ports)
    list.push_back({{"name", port.name}, {"kind", port.kind->name}, {"help", port.help}, {"required", port.required}});
  return list;
}

}  // namespace

Json schema_json(const recipe::Registry& registry) {
  Json json = {{"version", std::string(kVersion)},
               {"operators", Json::array()},
               {"formats", Json::array()},
               {"kinds", Json::array()},
               {"domain", params_json(recipe::describe_params<recipe::DomainParams>())}};
  for (const auto& op : registry.operators())
    json["operators"].push_back({{"name", op->name},
                                 {"summary", op->summary},
                                 {"source", op->source},
                                 {"stochastic", op->stochastic},
                                 {"needs_one", op->needs_one},
                                 {"in", ports_json(op->in)},
                                 {"out", ports_json(op->out)},
                                 {"params", params_json(op->params)}});
  for (const auto& format : registry.formats()) {
    Json accepts = Json::array();
    for (const recipe::Kind* kind : format->accepts) accepts.push_back(kind->name);
    json["formats"].push_back({{"name", format->name},
                               {"summary", format->summary},
                               {"extensions", format->extensions},
                               {"accepts", accepts},
                               {"params", params_json(format->params)}});
  }
  for (const recipe::Kind* kind : registry.kinds())
    json["kinds"].push_back({{"name", kind->name}, {"about", kind->about}, {"files", kind->files}});
  return json;
}

}  // namespace seamount::server
