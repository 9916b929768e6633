#include "seamount/recipe/edit.h"

#include <fmt/format.h>

#include <algorithm>

#include "seamount/recipe/bypass.h"
#include "seamount/recipe/edit_shorthand.h"
#include "seamount/recipe/variables.h"

namespace seamount::recipe {
namespace {

constexpr int kDeepest = 60;  // of an edit's value: a document has 64 levels at most

std::vector<std::string> tokens_of(const std::string& pointer) {
  std::vector<std::string> tokens;
  if (pointer.empty()) return tokens;
  if (pointer.front() != '/') throw InvalidArgument(pointer, "is no JSON pointer: it starts with '/'");
  for (size_t at = 0; at < pointer.size();) {
    const size_t end = std::min(pointer.find('/', at + 1), pointer.size());
    std::string token;
    for (size_t i = at + 1; i < end; ++i) {
      if (pointer[i] == '~' && i + 1 < end && (pointer[i + 1] == '0' || pointer[i + 1] == '1')) {
        token += pointer[++i] == '0' ? '~' : '/';
      } else {
        token += pointer[i];
      }
    }
    tokens.push_back(std::move(token));
    at = end;
  }
  return tokens;
}

/// The index that a token names in a list: that of the item with this id, or the number itself.
std::optional<size_t> index_in(const OrderedJson& list, const std::string& token) {
  for (size_t i = 0; i < list.size(); ++i) {
    if (list[i].is_object() && list[i].contains("id") && list[i]["id"] == token) return i;
  }
  const bool digits = !token.empty() && token.size() < 9 && token.find_first_not_of("0123456789") == std::string::npos;
  if (digits && std::stoul(token) < list.size()) return std::stoul(token);
  return std::nullopt;
}

size_t member_index(const OrderedJson& object, const std::string& key) {
  const auto& members = object.get_ref<const OrderedJson::object_t&>();
  const auto found = std::find_if(members.begin(), members.end(), [&](const auto& m) { return m.first == key; });
  return static_cast<size_t>(found - members.begin());
}

/// How far a pointer leads into the document.
struct Way {
  std::string pointer;            ///< of what was reached, with indices only
  OrderedJson* value = nullptr;   ///< what was reached
  std::vector<std::string> rest;  ///< tokens that lead on to what is not there
};

Way walk(OrderedJson& root, const std::string& pointer) {
  Way way{"", &root, tokens_of(pointer)};
  while (!way.rest.empty()) {
    const std::string& token = way.rest.front();
    if (way.value->is_array()) {
      const auto index = index_in(*way.value, token);
      if (!index) throw InvalidArgument(pointer, fmt::format("there is no '{}' in the list", token));
      way.value = &(*way.value)[*index];
      way.pointer += fmt::format("/{}", *index);
    } else if (way.value->is_object()) {
      const auto member = way.value->find(token);
      if (member == way.value->end()) break;
      way.value = &*member;
      way.pointer += "/" + pointer_token(token);
    } else {
      const auto variable = variable_name(Json(*way.value));
      throw InvalidArgument(
          pointer, variable ? fmt::format("'{}' leads into '${}': set /variables/{}", token, *variable, *variable)
                            : fmt::format("'{}' leads into a plain value", token));
    }
    way.rest.erase(way.rest.begin());
  }
  return way;
}

Way reach(OrderedJson& root, const std::string& pointer) {
  Way way = walk(root, pointer);
  if (!way.rest.empty()) throw InvalidArgument(pointer, fmt::format("there is no '{}'", way.rest.front()));
  return way;
}

/// The container of the value at a pointer with indices only, and the last token.
std::pair<OrderedJson*, std::string> parent_of(OrderedJson& root, const std::string& pointer) {
  std::vector<std::string> tokens = tokens_of(pointer);
  OrderedJson* parent = &root;
  for (size_t i = 0; i + 1 < tokens.size(); ++i)
    parent = parent->is_array() ? &(*parent)[std::stoul(tokens[i])] : &(*parent)[tokens[i]];
  return {parent, tokens.back()};
}

void put_in(OrderedJson& parent, const std::string& token, size_t index, const OrderedJson& value) {
  if (parent.is_array()) {
    parent.insert(parent.begin() + static_cast<std::ptrdiff_t>(index), value);
    return;
  }
  auto& members = parent.get_ref<OrderedJson::object_t&>();
  OrderedJson::object_t ordered;
  size_t at = 0;
  for (auto& [key, item] : members) {
    if (at++ == index) ordered.emplace_back(token, value);
    ordered.emplace_back(key, std::move(item));
  }
  if (index >= at) ordered.emplace_back(token, value);
  parent = std::move(ordered);
}

void take_out(OrderedJson& parent, const std::string& token, size_t index) {
  if (parent.is_array()) {
    parent.erase(index);
  } else {
    parent.erase(token);
  }
}

void turn(OrderedJson& root, const Change& change, const std::optional<OrderedJson>& value) {
  if (change.pointer.empty()) {
    root = *value;
    return;
  }
  const auto [parent, token] = parent_of(root, change.pointer);
  if (!value) {
    take_out(*parent, token, change.index);
  } else if (change.before && change.after) {
    (parent->is_array() ? (*parent)[change.index] : (*parent)[token]) = *value;
  } else {
    put_in(*parent, token, change.index, *value);
  }
}

int depth_of(const OrderedJson& value) {
  int deepest = 0;
  if (value.is_structured()) {
    for (const OrderedJson& item : value) deepest = std::max(deepest, 1 + depth_of(item));
  }
  return deepest;
}

/// Carries out edits and notes the changes.
class Editor {
 public:
  Editor(OrderedJson& root, const Registry& registry) : root_(root), registry_(registry) {}

  std::vector<Change> take_changes() { return std::move(changes_); }

  void operator()(const SetValue& edit) {
    write_out_before(edit.pointer);
    if (edit.value) check_depth(edit.pointer, *edit.value);
    const Way way = walk(root_, edit.pointer);
    if (!edit.value) {
      if (edit.pointer.empty()) throw InvalidArgument("the document", "cannot be taken out");
      if (way.rest.empty()) change_out(way.pointer);
      return;
    }
    if (way.rest.empty()) return change_value(way.pointer, *edit.value);
    OrderedJson value = *edit.value;
    for (size_t i = way.rest.size(); i-- > 1;) value = OrderedJson::object({{way.rest[i], std::move(value)}});
    change_in(way.pointer + "/" + pointer_token(way.rest.front()), way.value->size(), std::move(value));
  }

  void operator()(const InsertItem& edit) {
    check_depth(edit.list, edit.value);
    const Way way = walk(root_, edit.list);
    if (!way.rest.empty()) return (*this)(SetValue{edit.list, OrderedJson::array({edit.value})});
    const size_t index = edit.index.value_or(way.value->size());
    if (!way.value->is_array()) throw InvalidArgument(edit.list, "is no list");
    check_index(edit.list, index, way.value->size());
    change_in(fmt::format("{}/{}", way.pointer, index), index, edit.value);
  }

  void operator()(const RemoveItem& edit) {
    const Way way = reach(root_, edit.item);
    if (way.pointer.empty() || !parent_of(root_, way.pointer).first->is_array())
      throw InvalidArgument(edit.item, "is no item of a list");
    change_out(way.pointer);
  }

  void operator()(const MoveItem& edit) {
    const Way way = reach(root_, edit.item);
    if (way.pointer.empty() || !parent_of(root_, way.pointer).first->is_array())
      throw InvalidArgument(edit.item, "is no item of a list");
    const OrderedJson& list = *parent_of(root_, way.pointer).first;
    check_index(edit.item, edit.index, list.size() - 1);
    OrderedJson value = *way.value;
    change_out(way.pointer);
    const std::string before = way.pointer.substr(0, way.pointer.rfind('/'));
    change_in(fmt::format("{}/{}", before, edit.index), edit.index, std::move(value));
  }

  void operator()(const RenameStep& edit) {
    const std::string pointer = step_pointer(edit.id);
    const OrderedJson step = *reach(root_, pointer).value;
    const Operator* op = operator_of(step, registry_);
    if (op != nullptr && op->stochastic && !step.contains("seed") && edit.new_id != edit.id) {
      const OrderedJson seed = root_.value("seed", OrderedJson(0));
      const uint64_t number = seed.is_number_unsigned() ? seed.get<uint64_t>() : 0;
      (*this)(SetValue{pointer + "/seed", Seed{number}.derive(edit.id).value});
    }
    for_each_reference(edit.id, [&](const std::string& place, const std::string& port) {
      change_value(place, edit.new_id + (port.empty() ? "" : "." + port));
    });
    change_value(pointer + "/id", edit.new_id);
  }

  void operator()(const RemoveStep& edit) {
    const std::string pointer = step_pointer(edit.id);
    write_out_shorthand(edit.id);
    const OrderedJson step = *reach(root_, pointer).value;
    std::vector<std::string> dangling;  // outputs
    for_each_reference(edit.id, [&](const std::string& place, const std::string& port) {
      const OrderedJson instead = passed_on(step, port);
      const bool of_output = place.starts_with("/outputs/");
      if (instead.is_string() || (instead.is_object() && !of_output)) {
        change_value(place, instead);
      } else if (of_output && place.ends_with("/from")) {
        dangling.push_back(place.substr(0, place.rfind('/')));
      } else {
        change_out(place);
      }
    });
    for (size_t i = dangling.size(); i-- > 0;) change_out(dangling[i]);
    change_out(pointer);
  }

 private:
  /// An input of its own is given to a step whose "in" names a step as a whole.
  void write_out_before(const std::string& pointer) {
    const std::vector<std::string> tokens = tokens_of(pointer);
    if (tokens.size() < 4 || tokens[0] != "steps" || tokens[2] != "in") return;
    const auto steps = root_.find("steps");
    const auto index = steps == root_.end() ? std::nullopt : index_in(*steps, tokens[1]);
    if (index) write_out_inputs(fmt::format("/steps/{}", *index));
  }

  static void check_index(const std::string& pointer, size_t index, size_t last) {
    if (index > last) throw InvalidArgument(pointer, fmt::format("index {} is outside [0, {}]", index, last));
  }

  static void check_depth(const std::string& pointer, const OrderedJson& value) {
    if (const int depth = depth_of(value); depth > kDeepest)
      throw InvalidArgument(pointer, fmt::format("nested {} levels deep; at most {} are possible", depth, kDeepest));
  }

  std::string step_pointer(const std::string& id) {
    const auto steps = root_.find("steps");
    for (size_t i = 0; steps != root_.end() && i < steps->size(); ++i) {
      if ((*steps)[i].is_object() && (*steps)[i].value("id", OrderedJson()) == id) return fmt::format("/steps/{}", i);
    }
    throw InvalidArgument("/steps", "there is no step '" + id + "'");
  }

  /// Writes out "in": "isle" of a step.
  void write_out_inputs(const std::string& step_pointer) {
    const OrderedJson& step = *reach(root_, step_pointer).value;
    if (step.contains("in") && (step["in"].is_string() || step["in"].is_array()))
      change_value(step_pointer + "/in", written_out_inputs(root_, step, registry_));
  }

  /// Writes out the connections of the step with this id, and those to it.
  void write_out_shorthand(const std::string& id) {
    write_out_inputs(step_pointer(id));
    for_each_reference(id, [&](const std::string& place, const std::string&) {
      const std::vector<std::string> tokens = tokens_of(place);
      if (tokens[0] != "steps" || tokens[2] != "in") return;
      const std::string step = "/steps/" + tokens[1];
      if (tokens.size() == 3 || reach(root_, step).value->at("in").is_array()) write_out_inputs(step);
    });
    for_each_reference(id, [&](const std::string& place, const std::string& port) {
      if (!port.empty()) return;
      const std::string key = place.substr(place.rfind('/') + 1);
      const OrderedJson& item = *reach(root_, place.substr(0, place.find('/', place.find('/', 1) + 1))).value;
      const std::string meant = place.starts_with("/outputs/")
                                    ? written_out_port(root_, item, key, registry_)
                                    : written_out_input_port(root_, item, key, id, registry_);
      if (!meant.empty()) change_value(place, id + "." + meant);
    });
  }

  /// Where a step's output comes from once the step is gone: a source as it is written, or null.
  OrderedJson passed_on(const OrderedJson& step, const std::string& port) const {
    const Operator* op = operator_of(step, registry_);
    const Port* out = op == nullptr ? nullptr : op->find_out(port);
    const Port* in = out == nullptr ? nullptr : stand_in(*op, *out);
    const auto inputs = step.find("in");
    if (in == nullptr || inputs == step.end() || !inputs->is_object()) return {};
    return inputs->value(in->name, OrderedJson());
  }

  /// Calls visit(pointer, port) for each place where "id.port" is written, or "id" alone (no port). visit may change or
  /// take out the value there, not items of lists.
  template <class Visit>
  void for_each_reference(const std::string& id, Visit visit) {
    std::vector<std::pair<std::string, std::string>> found;
    const auto look = [&](const OrderedJson& value, const std::string& pointer) {
      if (!value.is_string()) return;
      const auto& text = value.get_ref<const std::string&>();
      if (text == id) found.emplace_back(pointer, "");
      if (text.size() > id.size() && text.starts_with(id) && text[id.size()] == '.')
        found.emplace_back(pointer, text.substr(id.size() + 1));
    };
    for (const char* list : {"steps", "outputs"}) {
      const auto items = root_.find(list);
      for (size_t i = 0; items != root_.end() && i < items->size(); ++i) {
        const OrderedJson& item = (*items)[i];
        const std::string place = fmt::format("/{}/{}", list, i);
        for (const char* key : {"labels", "from", "rivers", "lake"}) {
          if (item.is_object() && item.contains(key)) look(item[key], place + "/" + key);
        }
        if (!item.is_object() || !item.contains("in")) continue;
        look(item["in"], place + "/in");
        for (size_t k = 0; item["in"].is_array() && k < item["in"].size(); ++k)
          look(item["in"][k], fmt::format("{}/in/{}", place, k));
        if (!item["in"].is_object()) continue;
        for (const auto& [port, source] : item["in"].items()) look(source, place + "/in/" + pointer_token(port));
      }
    }
    for (const auto& [pointer, port] : found) visit(pointer, port);
  }

  void change_value(const std::string& pointer, OrderedJson value) {
    OrderedJson& place = *reach(root_, pointer).value;
    if (place == value) return;
    add({pointer, place_index(pointer), place, std::move(value)});
  }
  void change_in(const std::string& pointer, size_t index, OrderedJson value) {
    add({pointer, index, std::nullopt, std::move(value)});
  }
  void change_out(const std::string& pointer) {
    add({pointer, place_index(pointer), *reach(root_, pointer).value, std::nullopt});
  }

  size_t place_index(const std::string& pointer) {
    if (pointer.empty()) return 0;
    const auto [parent, token] = parent_of(root_, pointer);
    return parent->is_array() ? std::stoul(token) : member_index(*parent, token);
  }

  void add(Change change) {
    turn(root_, change, change.after);
    changes_.push_back(std::move(change));
  }

  OrderedJson& root_;
  const Registry& registry_;
  std::vector<Change> changes_;
};

}  // namespace

std::vector<Change> carry_out(OrderedJson& root, const Edit& edit, const Registry& registry) {
  Editor editor(root, registry);
  try {
    std::visit(editor, edit);
  } catch (...) {
    take_back(root, editor.take_changes());
    throw;
  }
  return editor.take_changes();
}

void take_back(OrderedJson& root, const std::vector<Change>& changes) {
  for (size_t i = changes.size(); i-- > 0;) turn(root, changes[i], changes[i].before);
}

void make_again(OrderedJson& root, const std::vector<Change>& changes) {
  for (const Change& change : changes) turn(root, change, change.after);
}

void join(std::vector<Change>& changes, std::vector<Change> later) {
  for (Change& change : later) {
    const bool same = !changes.empty() && changes.back().pointer == change.pointer && changes.back().after &&
                      change.before && change.after;
    if (same) {
      changes.back().after = std::move(change.after);
    } else {
      changes.push_back(std::move(change));
    }
  }
}

}  // namespace seamount::recipe
