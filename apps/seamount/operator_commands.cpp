// Every operator as a command of its own: a recipe of one step, made from flags.
#include <fmt/format.h>

#include <cmath>

#include "app.h"
#include "seamount/base/text.h"
#include "seamount/model/model_file.h"
#include "seamount/recipe/recipe.h"

namespace seamount::app {
namespace {

using recipe::Json;
using recipe::Operator;

struct OperatorFlags : RunFlags {
  std::string out;
  std::vector<std::string> in;
  std::string domain;
  std::optional<double> cell_m;
  std::optional<int> size;
  std::map<std::string, std::string> params;  ///< as typed, by name or group.name
};

/// "60000x40000" or "60000": width and height in metres.
void set_domain(Json& domain, const std::string& text) {
  const size_t cross = text.find('x');
  const auto number = [&](const std::string& part) {
    size_t used = 0;
    double value = 0;
    try {
      value = std::stod(part, &used);
    } catch (const std::exception&) {
      used = 0;
    }
    if (used == 0 || used != part.size() || !std::isfinite(value))
      throw InvalidArgument("--domain", "expected WIDTHxHEIGHT in metres, found '" + text + "'");
    return value;
  };
  domain["width_m"] = number(text.substr(0, cross));
  domain["height_m"] = cross == std::string::npos ? domain["width_m"] : Json(number(text.substr(cross + 1)));
}

/// "a.tif,b.tif", or a JSON list.
Json absolute_files(const std::string& flag, const std::string& text) {
  Json list = Json::parse(text, nullptr, false);
  if (!list.is_array()) {
    list = Json::array();
    for (size_t begin = 0; begin <= text.size();) {
      const size_t comma = std::min(text.find(',', begin), text.size());
      if (comma > begin) list.push_back(text.substr(begin, comma - begin));
      begin = comma + 1;
    }
  }
  for (Json& file : list) {
    if (!file.is_string()) throw InvalidArgument(flag, "expected file names, found '" + text + "'");
    file = absolute_file(flag, file.get<std::string>());
  }
  return list;
}

/// Puts the flag of one parameter into an object of parameters as `name`.
void set_param(Json& params, const std::string& name, const recipe::ParamInfo& info, const OperatorFlags& flags,
               const std::string& group = "") {
  const auto given = flags.params.find(group + name);
  if (given == flags.params.end()) return;
  if (params.contains(name))
    throw InvalidArgument("--" + group + name, "is given in --" + group.substr(0, group.size() - 1) + " too");
  recipe::ParamInfo shown = info;
  shown.name = given->first;
  if (info.kind == "file")
    params[name] = absolute_file("--" + given->first, given->second);
  else if (info.kind == "model" && !ModelFile{given->second}.is_word())
    params[name] = absolute_file("--" + given->first, given->second);
  else if (info.kind == "files")
    params[name] = absolute_files("--" + given->first, given->second);
  else
    params[name] = recipe::parse_flag(shown, given->second);
}

/// The flags of parameters, those of a group's members after the group as a whole.
void set_params(Json& params, const std::vector<recipe::ParamInfo>& infos, const std::string& group,
                const OperatorFlags& flags) {
  for (const recipe::ParamInfo& info : infos) {
    set_param(params, info.name, info, flags, group);
    if (info.kind != "group") continue;
    Json members = params.contains(info.name) ? params[info.name] : Json::object();
    if (!members.is_object()) continue;  // refused when the document is read
    set_params(members, info.tools[0].params, group + info.name + ".", flags);
    if (!members.empty()) params[info.name] = std::move(members);
  }
}

/// The document that the flags stand for. File names in it are absolute: there is no recipe file that they could be
/// relative to.
Json make_document(const Operator& op, const OperatorFlags& flags) {
  const std::string id = op.name.substr(op.name.find('.') + 1);
  Json step = {{"id", id},
               {"op", op.name},
               {"in", Json::object()},
               {"params", Json::object()},
               {"seed", flags.seed.value_or(0)}};
  set_params(step["params"], op.params, "", flags);
  for (const recipe::FormerParam& former : op.former) set_param(step["params"], former.name, former.info, flags);
  for (const std::string& assignment : flags.in) {
    const size_t equals = assignment.find('=');
    if (equals == std::string::npos) throw InvalidArgument("--in", "expected NAME=FILE, found '" + assignment + "'");
    const std::string name = assignment.substr(0, equals);
    if (step["in"].contains(name)) throw InvalidArgument("--in", "'" + name + "' is given twice");
    step["in"][name] = {{"file", absolute_file("--in " + name, assignment.substr(equals + 1))}};
  }
  Json document = {{"seamount", 1}, {"domain", Json::object()}, {"steps", {step}}, {"outputs", Json::array()}};
  if (!flags.domain.empty()) set_domain(document["domain"], flags.domain);
  if (flags.cell_m) document["domain"]["cell_m"] = *flags.cell_m;
  for (const recipe::Port& port : op.out) {
    for (const std::string& extension : port.kind->files)
      document["outputs"].push_back({{"from", id + "." + port.name}, {"path", port.name + extension}});
  }
  return document;
}

using ParamTexts = std::map<std::string, std::string>;

Flag add_param_flag(Command command, const std::string& name, const recipe::ParamInfo& info, ParamTexts& texts) {
  std::string names = "--" + name;
  std::string dashed = name;
  std::replace(dashed.begin(), dashed.end(), '_', '-');
  if (dashed != name) names += ",--" + dashed;
  return command
      .add(
          names, [&texts, name](const std::string& text) { texts[name] = text; },
          info.help + (info.unit.empty() ? "" : " [" + info.unit + "]"))
      .kind(info.kind);
}

/// A flag for each parameter; a group has one as a whole, in JSON, and one for each member: --walk.stickiness.
void add_param_flags(Command command, const std::vector<recipe::ParamInfo>& infos, const std::string& group,
                     ParamTexts& texts) {
  for (const recipe::ParamInfo& info : infos) {
    add_param_flag(command, group + info.name, info, texts).group("Parameters");
    if (info.kind == "group") add_param_flags(command, info.tools[0].params, group + info.name + ".", texts);
  }
}

void add_operator_command(Command program, const recipe::Registry& registry, const Operator& op) {
  const auto flags = std::make_shared<OperatorFlags>();
  Command command = program.add_command(op.name, op.summary, "Operators");
  command.add("--out", &flags->out, "folder for the results").required();
  if (!op.in.empty()) {
    command.add("--in", &flags->in, "an input: NAME=FILE");
  }
  command.add("--domain", &flags->domain, "width and height of the terrain in metres: 60000x40000");
  command.add("--cell", &flags->cell_m, "cell size in metres").finite();
  command.add("--size", &flags->size, "cells along the longer side").between(1, 65536);
  add_run_flags(command, *flags);
  add_param_flags(command, op.params, "", flags->params);
  // Former names work and are not shown: help has no heading for them.
  for (const recipe::FormerParam& former : op.former)
    add_param_flag(command, former.name, former.info, flags->params).group("");
  for (const recipe::Port& port : op.in) {
    for (const std::string& name : {port.name, port.former}) {
      if (name.empty() || command.has("--" + name)) continue;  // none, or a parameter's; --in NAME=FILE remains
      command
          .add(
              "--" + name, [flags, name](const std::string& file) { flags->in.push_back(name + "=" + file); },
              port.help)
          .kind("FILE")
          .group(name == port.name ? "Inputs" : "");
    }
  }
  command.does([flags, &registry, &op] {
    const Json document = make_document(op, *flags);
    static const FlagNames kFlags = {{"/steps/0/params/", "--"},   {"/steps/0/in/", "--in "}, {"/steps/0/in", "--in"},
                                     {"/domain/cell_m", "--cell"}, {"/domain/", "--domain "}, {"/domain", "--domain"}};
    const recipe::Recipe recipe = parse_made_recipe(document, op.name, kFlags, {.size = flags->size}, registry);
    run_and_report(recipe, flags->out, *flags);
  });
}

}  // namespace

void add_operator_commands(Command program, const recipe::Registry& registry) {
  for (const auto& op : registry.operators()) add_operator_command(program, registry, *op);
}

}  // namespace seamount::app
