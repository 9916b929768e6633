#include "seamount/recipe/recipe.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <set>

#include "seamount/recipe/bypass.h"
#include "seamount/recipe/domain.h"
#include "seamount/recipe/kinds.h"
#include "seamount/recipe/output_files.h"
#include "seamount/recipe/output_water.h"
#include "seamount/recipe/prepare_output.h"
#include "seamount/recipe/read_sources.h"
#include "seamount/recipe/shorthand.h"
#include "seamount/recipe/step_order.h"
#include "seamount/recipe/variables.h"

namespace seamount::recipe {
namespace {

std::optional<Seed> read_seed(const Json& json, const ReadPlace& place) {
  if (json.is_number_unsigned()) return Seed{json.get<uint64_t>()};
  place.expected("a seed: a whole number from 0 to 2^64 - 1", json);
  return std::nullopt;
}

bool good_id(const std::string& id) {
  const auto allowed = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-'; };
  return !id.empty() && id.size() <= 64 && std::all_of(id.begin(), id.end(), allowed);
}

class RecipeReader {
 public:
  RecipeReader(const Json& root, Recipe& recipe, Diagnostics& defects, Diagnostics& missing, int64_t most_cells)
      : root_(root),
        recipe_(recipe),
        registry_(*recipe.registry),
        top_{"", defects},
        missing_(missing),
        most_cells_(most_cells) {}

  void read() {
    if (!root_.is_object()) return top_.expected("a recipe: an object", root_);
    refuse_unknown_keys(root_, {"$schema", "seamount", "about", "variables", "domain", "seed", "steps", "outputs"},
                        "member", top_);
    read_version();
    if (const auto seed = root_.find("seed"); seed != root_.end())
      recipe_.seed = read_seed(*seed, top_.at("seed")).value_or(Seed{});
    read_domain(root_.value("domain", Json::object()));
    read_steps();
    order_steps();
    leave_out_bypassed();
    read_outputs();
  }

 private:
  void read_version() {
    const auto version = root_.find("seamount");
    if (version == root_.end()) return top_.fail("\"seamount\": 1 is missing; is this a recipe?");
    if (*version != 1)
      top_.at("seamount").fail("version " + version->dump() + " is unknown; this program reads version 1");
  }

  void read_domain(const Json& json) {
    const ReadPlace place = top_.at("domain");
    const size_t before = place.diagnostics.items().size();
    const auto params = read_params<DomainParams>(json, place);
    if (place.diagnostics.items().size() > before) return;
    try {
      recipe_.domain = domain_frame(params, most_cells_);
      recipe_.domain_stated = json.is_object() && (json.contains("width_m") || json.contains("height_m"));
    } catch (const Error& error) {
      place.fail(error.what());
    }
  }

  void read_steps() {
    const auto steps = root_.find("steps");
    if (steps == root_.end()) return top_.fail("\"steps\" is missing");
    if (!steps->is_array()) return top_.at("steps").expected("a list of steps", *steps);
    std::map<std::string, size_t> first_use;
    for (size_t i = 0; i < steps->size(); ++i) {
      const ReadPlace place = top_.at("steps").at(i);
      DraftStep draft{{}, place};
      read_step((*steps)[i], draft);
      const std::string& id = draft.step.id;
      if (!id.empty() && !first_use.emplace(id, i).second) {
        place.at("id").fail(fmt::format("'{}' is already the id of step {}", id, first_use[id]));
        continue;
      }
      drafts_.push_back(std::move(draft));
    }
    for (DraftStep& draft : drafts_) connect_inputs(draft, drafts_, missing_);
  }

  void read_step(const Json& json, DraftStep& draft) {
    const ReadPlace& place = draft.place;
    if (!json.is_object()) return place.expected("a step {\"id\", \"op\", \"in\", \"params\"}", json);
    refuse_unknown_keys(json, {"id", "op", "in", "params", "seed", "bypass", "about"}, "member", place);
    draft.step.id = text_member(json, "id", place, true).value_or("");
    if (!draft.step.id.empty() && !good_id(draft.step.id)) {
      place.at("id").fail("'" + draft.step.id + "' is no id: up to 64 letters, digits, '_' and '-'");
    }
    draft.step.seed = recipe_.seed.derive(draft.step.id);
    if (const auto seed = json.find("seed"); seed != json.end()) {
      draft.step.seed = read_seed(*seed, place.at("seed")).value_or(Seed{});
    }
    if (const auto name = text_member(json, "op", place, true)) {
      draft.step.op = registry_.find_operator(*name);
      if (draft.step.op == nullptr)
        place.at("op").fail("unknown operator '" + *name + "'" + suggestion(*name, registry_.operator_names()));
    }
    if (draft.step.op != nullptr) {
      draft.step.params = draft.step.op->complete(json.value("params", Json::object()), place.at("params"));
    }
    if (const auto in = json.find("in"); in != json.end()) draft.in = &*in;
    if (const auto bypass = json.find("bypass"); bypass != json.end())
      read_json(*bypass, draft.bypass, place.at("bypass"));
  }

  const DraftStep* find_draft(const std::string& id) const {
    for (const DraftStep& draft : drafts_) {
      if (draft.step.id == id) return &draft;
    }
    return nullptr;
  }

  /// Steps in an order in which each follows what it needs; names the steps of a cycle.
  void order_steps() {
    std::vector<Step> steps;
    for (const DraftStep& draft : drafts_) steps.push_back(draft.step);
    StepOrder order = order_of(std::move(steps));
    recipe_.steps = std::move(order.steps);
    if (order.cycle.empty()) return;
    const std::string& first = order.cycle.front();
    find_draft(first)->place.at("in").fail(
        fmt::format("the steps need each other in a circle: {} -> {}", fmt::join(order.cycle, " -> "), first));
  }

  /// Connects what was connected to bypassed steps to what these pass on.
  void leave_out_bypassed() {
    std::vector<Step> kept;
    for (Step& step : recipe_.steps) {
      const DraftStep* draft = find_draft(step.id);
      for (auto input = step.in.begin(); input != step.in.end();) {
        const auto followed = follow(recipe_.bypassed, input->second);
        if (followed) {
          (input++)->second = *followed;
          continue;
        }
        report_nothing(step, *input, draft->place.at("in").at(input->first), draft->bypass);
        input = step.in.erase(input);
      }
      (draft->bypass ? recipe_.bypassed : kept).push_back(std::move(step));
    }
    recipe_.steps = std::move(kept);
  }

  /// An input gets nothing from a bypassed step. A port that could pass nothing on is an error in any case.
  void report_nothing(Step& step, const std::pair<const std::string, Source>& input, const ReadPlace& place,
                      bool bypass) {
    const Operator& producer = *find_draft(input.second.step)->step.op;
    const std::string why = why_nothing(recipe_.bypassed, input.second);
    if (stand_in(producer, *producer.find_out(input.second.port)) == nullptr) {
      place.fail(why);
    } else if (step.op->find_in(input.first)->required && !bypass) {
      leave_open(step, place, fmt::format("{} needs the input '{}': {}", step.op->name, input.first, why), missing_);
    }
  }

  void read_outputs() {
    const auto outputs = root_.find("outputs");
    if (outputs == root_.end()) return;
    if (!outputs->is_array()) return top_.at("outputs").expected("a list of outputs", *outputs);
    for (size_t i = 0; i < outputs->size(); ++i) {
      Output output;
      if (read_output((*outputs)[i], top_.at("outputs").at(i), output)) recipe_.outputs.push_back(std::move(output));
    }
    if (recipe_.outputs.size() == outputs->size()) check_outputs_apart(recipe_.outputs, top_.at("outputs"));
  }

  /// Kinds that an output may be; where its step has none that the file's ending asks for, those that "as" would name.
  std::vector<const Kind*> wanted_kinds(const Json& from, const std::string& path,
                                        const std::optional<std::string>& as) const {
    std::vector<const Kind*> kinds = written_kinds(registry_, path, as);
    const DraftStep* draft = as || !from.is_string() ? nullptr : find_draft(from.get<std::string>());
    if (draft == nullptr || draft->step.op == nullptr) return kinds;
    const std::vector<Port>& ports = draft->step.op->out;
    const bool fits = std::any_of(ports.begin(), ports.end(), [&](const Port& port) {
      return std::find(kinds.begin(), kinds.end(), port.kind) != kinds.end();
    });
    const std::vector<const Kind*> named = fits ? std::vector<const Kind*>{} : kinds_by_name(registry_, path);
    return named.empty() ? kinds : named;
  }

  bool read_output(const Json& json, const ReadPlace& place, Output& output) {
    if (!json.is_object()) {
      place.expected("an output {\"from\", \"path\"}", json);
      return false;
    }
    const auto path = text_member(json, "path", place, true);
    const auto as = text_member(json, "as", place, false);
    const auto written = json.find("from");
    if (written == json.end() && drafts_.empty()) {
      place.fail("\"from\" is missing");
      return false;
    }
    const Json from = written == json.end() ? Json(drafts_.back().step.id) : *written;
    const auto source = read_source(from, place.at("from"),
                                    {wanted_kinds(from, path.value_or(""), as), "", written != json.end()}, drafts_);
    if (!path || !source || (json.contains("as") && !as)) return false;
    const std::filesystem::path relative = std::filesystem::path(*path).lexically_normal();
    if (relative.is_absolute() || relative.string().starts_with("..")) {
      place.at("path").fail("'" + *path + "' leaves the output folder");
      return false;
    }
    if (source->from_file()) {
      place.at("from").fail("an output comes from a step");
      return false;
    }
    const auto followed = follow_for_output(*source, place.at("from"));
    if (!followed) return false;
    output.from = *followed;
    output.path = relative.string();
    const Kind& kind = *find_draft(source->step)->step.op->find_out(source->port)->kind;
    if (!choose_format(registry_, kind, as, output, place)) return false;
    const std::optional<Source> labels = labels_for(json, *followed, place);
    const std::vector<std::string> waters = waters_of(registry_, *output.format);
    OutputWater water = read_water(json, waters, place, drafts_);
    for (auto& [input, given] : water.given) given = follow_for_output(given, place.at(input)).value_or(given);
    Json params = json;
    for (const char* key : {"from", "path", "as", "labels", "about"}) params.erase(key);
    for (const std::string& key : waters) params.erase(key);
    const size_t before = place.diagnostics.items().size();
    output.params = output.format->complete(params, place);
    if (place.diagnostics.items().size() > before) return true;
    prepare_output(recipe_, output, kind, labels, add_water(recipe_, output, water, place), place);
    return true;
  }

  /// The step that an output really comes from; reports a bypassed one that passes on nothing, or a file.
  std::optional<Source> follow_for_output(const Source& source, const ReadPlace& place) {
    const auto followed = follow(recipe_.bypassed, source);
    if (!followed) {
      const Operator& producer = *find_draft(source.step)->step.op;
      const bool open = stand_in(producer, *producer.find_out(source.port)) != nullptr;
      const std::string why = why_nothing(recipe_.bypassed, source);
      if (open) {
        missing_.add(place.pointer, why);
      } else {
        place.fail(why);
      }
    } else if (followed->from_file()) {
      place.fail(fmt::format("an output comes from a step; '{}.{}' is bypassed and passes on the file '{}'",
                             source.step, source.port, followed->file));
      return std::nullopt;
    }
    return followed;
  }

  /// "labels" as given, or the labels output of the same step.
  std::optional<Source> labels_for(const Json& json, const Source& from, const ReadPlace& place) {
    if (const auto given = json.find("labels"); given != json.end()) {
      const auto source = read_source(*given, place.at("labels"), {{&kinds::Labels::kind()}, "labels"}, drafts_);
      if (source && source->from_file()) place.at("labels").fail("the labels of an output come from a step");
      if (!source || source->from_file()) return std::nullopt;
      return follow_for_output(*source, place.at("labels"));
    }
    for (const Port& port : find_draft(from.step)->step.op->out) {
      if (port.kind == &kinds::Labels::kind()) return Source{from.step, port.name, ""};
    }
    return std::nullopt;
  }

  const Json& root_;
  Recipe& recipe_;
  const Registry& registry_;
  ReadPlace top_;
  Diagnostics& missing_;
  int64_t most_cells_;
  std::vector<DraftStep> drafts_;
};

}  // namespace

Recipe read_document(const Json& root, const std::string& file, const std::string& folder, Diagnostics& defects,
                     Diagnostics& missing, const Registry& registry, int64_t most_cells) {
  Recipe recipe;
  recipe.file = file;
  recipe.folder = folder;
  recipe.registry = &registry;
  const ReadPlace top{"", defects};
  const VariablesApplied variables(root, top);
  RecipeReader(variables.root(), recipe, defects, missing, most_cells).read();
  variables.name_variables();
  recipe.notes = defects.notes();
  return recipe;
}

}  // namespace seamount::recipe
