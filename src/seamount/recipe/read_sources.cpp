#include "seamount/recipe/read_sources.h"

#include <fmt/format.h>

#include <algorithm>

#include "seamount/base/text.h"
#include "seamount/recipe/shorthand.h"

namespace seamount::recipe {
namespace {

const DraftStep* find_draft(const std::vector<DraftStep>& drafts, const std::string& id) {
  const auto found =
      std::find_if(drafts.begin(), drafts.end(), [&](const DraftStep& draft) { return draft.step.id == id; });
  return found == drafts.end() ? nullptr : &*found;
}

/// The name under which a port is connected: its own, or with a note its former one.
std::string written_name(const Port& port, const Json& in, const ReadPlace& place) {
  if (port.former.empty() || !in.contains(port.former)) return port.name;
  const ReadPlace former = place.at(port.former);
  if (in.contains(port.name)) {
    former.fail(renamed_text(port.former, port.name) + ", which is given too: leave one out");
    return port.name;
  }
  former.note(renamed_text(port.former, port.name));
  return port.former;
}

/// An output by its name, or with a note by its former one.
const Port* find_output(const DraftStep& draft, const std::string& name, const ReadPlace& place) {
  if (const Port* port = draft.step.op->find_out(name)) return port;
  for (const Port& port : draft.step.op->out) {
    if (name.empty() || port.former != name) continue;
    place.note(renamed_text(draft.step.id + "." + name, draft.step.id + "." + port.name));
    return &port;
  }
  return nullptr;
}

/// A step by its id; reports one that does not exist. nullptr also for one whose operator was reported already.
const DraftStep* read_step_id(const std::string& id, const std::vector<DraftStep>& drafts, const ReadPlace& place) {
  const DraftStep* step = find_draft(drafts, id);
  if (step == nullptr) {
    std::vector<std::string> ids;
    ids.reserve(drafts.size());
    for (const DraftStep& draft : drafts) ids.push_back(draft.step.id);
    place.fail("there is no step '" + id + "'" + suggestion(id, ids));
    return nullptr;
  }
  return step->step.op == nullptr ? nullptr : step;
}

std::string kinds_text(const std::vector<const Kind*>& kinds) {
  std::string wanted;
  for (const Kind* kind : kinds) wanted += (wanted.empty() ? "" : " or ") + kind->name;
  return wanted;
}

/// "isle.terrain (terrain), isle.labels (labels)".
std::string outputs_text(const Step& step) {
  std::string text;
  for (const Port& port : step.op->out)
    text += fmt::format("{}{}.{} ({})", text.empty() ? "" : ", ", step.id, port.name, port.kind->name);
  return text;
}

/// The output that "step" alone means.
const Port* read_meant_output(const DraftStep& draft, const ReadPlace& place, const SourceUse& use) {
  const Port* port = meant_output(*draft.step.op, use.input, use.kinds);
  if (port != nullptr) return port;
  if (use.input.empty() && !use.kinds.empty()) port = meant_written(*draft.step.op, use.kinds);
  if (port != nullptr) {
    if (use.said)
      place.note(fmt::format("'{0}' means {0}.{1}, its first; it has {2}", draft.step.id, port->name,
                             outputs_text(draft.step)));
    return port;
  }
  place.fail(fmt::format("which output of '{}'?{} {}", draft.step.id,
                         use.kinds.empty() || use.kinds.size() > 4 ? "" : " " + kinds_text(use.kinds) + " is needed;",
                         "it has " + outputs_text(draft.step)));
  return nullptr;
}

/// "in": "step" or "step.port".
void connect_whole(DraftStep& draft, const std::string& text, const ReadPlace& place,
                   const std::vector<DraftStep>& drafts) {
  const size_t dot = text.find('.');
  const DraftStep* producer = read_step_id(text.substr(0, dot), drafts, place);
  if (producer == nullptr) return;
  const Operator& op = *draft.step.op;
  std::vector<std::string> inputs;
  for (const Port& port : op.in) inputs.push_back(fmt::format("{} ({})", port.name, port.kind->name));
  if (dot == std::string::npos) {
    const auto pairs = meant_connections(op, *producer->step.op);
    for (const auto& [input, output] : pairs) draft.step.in[input->name] = {producer->step.id, output->name, ""};
    if (pairs.empty())
      place.fail(fmt::format("no output of '{}' has the name and kind of an input of {}: it has {}; the inputs are {}",
                             text, op.name, outputs_text(producer->step), fmt::join(inputs, ", ")));
    return;
  }
  const auto source = read_source(text, place, {}, drafts);
  if (!source) return;
  const Port* input = meant_input(op, *producer->step.op->find_out(source->port));
  if (input == nullptr)
    return place.fail(
        fmt::format("for which input of {} is '{}'? They are {}", op.name, text, fmt::join(inputs, ", ")));
  draft.step.in[input->name] = *source;
}

/// "in": ["step", "step"]: one row of inputs each.
void connect_rows(DraftStep& draft, const Json& in, const ReadPlace& place, const std::vector<DraftStep>& drafts) {
  const Operator& op = *draft.step.op;
  const int rows = count_rows(op);
  if (rows == 0) return place.fail(op.name + " takes no list of steps: name its inputs, or one step");
  if (static_cast<int>(in.size()) > rows)
    return place.fail(fmt::format("{} steps; {} takes {} at most", in.size(), op.name, rows));
  for (size_t i = 0; i < in.size(); ++i) {
    if (!in[i].is_string()) {
      place.at(i).expected("a step", in[i]);
      continue;
    }
    const DraftStep* producer = read_step_id(in[i].get<std::string>(), drafts, place.at(i));
    if (producer == nullptr) continue;
    const auto pairs = row_connections(op, *producer->step.op, static_cast<int>(i));
    for (const auto& [input, output] : pairs) draft.step.in[input->name] = {producer->step.id, output->name, ""};
    if (pairs.empty())
      place.at(i).fail(fmt::format("no output of '{}' has the name and kind of an input of {}: it has {}",
                                   producer->step.id, op.name, outputs_text(producer->step)));
  }
}

/// The step before `draft`, which an operator that needs an input takes where no "in" is written.
const DraftStep* step_before(const DraftStep& draft, const std::vector<DraftStep>& drafts) {
  const std::vector<Port>& in = draft.step.op->in;
  const bool required = std::any_of(in.begin(), in.end(), [](const Port& port) { return port.required; });
  if (!required && !draft.step.op->needs_one) return nullptr;
  const auto at = std::find_if(drafts.begin(), drafts.end(), [&](const DraftStep& other) { return &other == &draft; });
  if (at == drafts.begin() || at == drafts.end()) return nullptr;
  const DraftStep& before = *std::prev(at);
  return before.step.op == nullptr || meant_connections(*draft.step.op, *before.step.op).empty() ? nullptr : &before;
}

void connect_before(DraftStep& draft, const DraftStep& before) {
  for (const auto& [input, output] : meant_connections(*draft.step.op, *before.step.op)) {
    if (draft.step.op->needs_one && !draft.step.in.empty()) break;
    draft.step.in[input->name] = {before.step.id, output->name, ""};
  }
}

}  // namespace

std::optional<std::string> text_member(const Json& object, const std::string& key, const ReadPlace& place,
                                       bool required) {
  const auto member = object.find(key);
  if (member == object.end()) {
    if (required) place.fail("\"" + key + "\" is missing");
    return std::nullopt;
  }
  if (!member->is_string()) {
    place.at(key).expected("a text", *member);
    return std::nullopt;
  }
  const auto& text = member->get_ref<const std::string&>();
  if (text.empty()) {
    place.at(key).fail("is empty");
    return std::nullopt;
  }
  if (std::any_of(text.begin(), text.end(), [](unsigned char c) { return c < ' '; })) {
    place.at(key).expected("a text without control characters", *member);
    return std::nullopt;
  }
  return member->get<std::string>();
}

std::optional<Source> read_source(const Json& json, const ReadPlace& place, const SourceUse& use,
                                  const std::vector<DraftStep>& drafts) {
  if (json.is_object() && json.contains("file")) {
    refuse_unknown_keys(json, {"file"}, "member", place);
    const auto file = text_member(json, "file", place, true);
    return file ? std::optional(Source{"", "", *file}) : std::nullopt;
  }
  if (!json.is_string()) {
    place.expected("\"step.port\", \"step\" or {\"file\": name}", json);
    return std::nullopt;
  }
  const auto text = json.get<std::string>();
  const size_t dot = text.find('.');
  const DraftStep* step = read_step_id(text.substr(0, dot), drafts, place);
  if (step == nullptr) return std::nullopt;
  if (dot == std::string::npos) {
    const Port* meant = read_meant_output(*step, place, use);
    return meant == nullptr ? std::nullopt : std::optional(Source{step->step.id, meant->name, ""});
  }
  const Port* port = find_output(*step, text.substr(dot + 1), place);
  if (port == nullptr) {
    std::vector<std::string> ports;
    for (const Port& known : step->step.op->out) ports.push_back(step->step.id + "." + known.name);
    place.fail("'" + text + "' is no output of " + step->step.op->name + suggestion(text, ports));
    return std::nullopt;
  }
  if (use.input.empty() || std::find(use.kinds.begin(), use.kinds.end(), port->kind) != use.kinds.end())
    return Source{step->step.id, port->name, ""};
  place.fail(fmt::format("'{}' is {}; {} is needed here", text, port->kind->name, kinds_text(use.kinds)));
  return std::nullopt;
}

void leave_open(Step& step, const ReadPlace& place, const std::string& why, Diagnostics& missing) {
  missing.add(place.pointer, why);
  if (step.incomplete.empty()) step.incomplete = why;
}

void connect_inputs(DraftStep& draft, const std::vector<DraftStep>& drafts, Diagnostics& missing) {
  const Operator* op = draft.step.op;
  if (op == nullptr) return;
  const Json nothing = Json::object();
  const bool whole = draft.in != nullptr && (draft.in->is_string() || draft.in->is_array());
  if (draft.in == nullptr) {
    if (const DraftStep* before = step_before(draft, drafts)) connect_before(draft, *before);
  }
  const Json& in = draft.in == nullptr || whole ? nothing : *draft.in;
  const ReadPlace place = draft.place.at("in");
  if (!in.is_object()) return place.expected("an object of inputs, a step, or a list of steps", in);
  const size_t before = place.diagnostics.items().size();
  if (whole && draft.in->is_array()) connect_rows(draft, *draft.in, place, drafts);
  if (whole && draft.in->is_string()) connect_whole(draft, draft.in->get<std::string>(), place, drafts);
  if (whole && place.diagnostics.items().size() > before) return;
  std::vector<std::string> names;
  for (const Port& port : op->in) {
    const std::string written = written_name(port, in, place);
    names.push_back(written);
    const auto member = in.find(written);
    if (member != in.end()) {
      if (auto source = read_source(*member, place.at(written), {{port.kind}, port.name}, drafts))
        draft.step.in[port.name] = *source;
    } else if (port.required && !draft.bypass && !draft.step.in.contains(port.name)) {
      leave_open(draft.step, draft.in == nullptr ? draft.place : place,
                 fmt::format("{} needs the input '{}': {}", op->name, port.name, port.help), missing);
    }
  }
  refuse_unknown_keys(in, names, "input", place);
}

}  // namespace seamount::recipe
