#include "seamount/server/edit_json.h"

#include <fmt/format.h>

#include <algorithm>

namespace seamount::server {
namespace {

constexpr uint64_t kLargestIndex = 1u << 24;

/// Members of a JSON object, each refused by its place when it is missing or of another type.
class Members {
 public:
  Members(const OrderedJson& json, std::string place) : json_(json), place_(std::move(place)) {
    if (!json.is_object()) throw InvalidArgument(place_, "is no object");
  }
  std::string text(const char* name) const {
    const auto found = json_.find(name);
    if (found == json_.end() || !found->is_string())
      throw InvalidArgument(place_, fmt::format("needs a text '{}'", name));
    return found->get<std::string>();
  }
  std::optional<size_t> index(const char* name) const {
    const auto found = json_.find(name);
    if (found == json_.end()) return std::nullopt;
    if (!found->is_number_unsigned() || found->get<uint64_t>() > kLargestIndex)
      throw InvalidArgument(place_, fmt::format("'{}' is no index", name));
    return found->get<size_t>();
  }
  std::optional<OrderedJson> value() const {
    const auto found = json_.find("value");
    return found == json_.end() ? std::nullopt : std::optional(*found);
  }
  OrderedJson needed_value() const {
    if (const auto found = value()) return *found;
    throw InvalidArgument(place_, "needs a 'value'");
  }
  size_t needed_index() const {
    if (const auto found = index("index")) return *found;
    throw InvalidArgument(place_, "needs an 'index'");
  }

 private:
  const OrderedJson& json_;
  std::string place_;
};

struct Writer {
  OrderedJson operator()(const recipe::SetValue& edit) const {
    OrderedJson json = {{"do", "set"}, {"pointer", edit.pointer}};
    if (edit.value) json["value"] = *edit.value;
    return json;
  }
  OrderedJson operator()(const recipe::InsertItem& edit) const {
    OrderedJson json = {{"do", "insert"}, {"list", edit.list}};
    if (edit.index) json["index"] = *edit.index;
    json["value"] = edit.value;
    return json;
  }
  OrderedJson operator()(const recipe::RemoveItem& edit) const { return {{"do", "remove"}, {"item", edit.item}}; }
  OrderedJson operator()(const recipe::MoveItem& edit) const {
    return {{"do", "move"}, {"item", edit.item}, {"index", edit.index}};
  }
  OrderedJson operator()(const recipe::RenameStep& edit) const {
    return {{"do", "rename"}, {"id", edit.id}, {"new_id", edit.new_id}};
  }
  OrderedJson operator()(const recipe::RemoveStep& edit) const { return {{"do", "remove_step"}, {"id", edit.id}}; }
};

bool same_keys(const OrderedJson& from, const OrderedJson& to) {
  if (from.size() != to.size()) return false;
  auto a = from.items().begin();
  auto b = to.items().begin();
  for (; a != from.items().end(); ++a, ++b) {
    if (a.key() != b.key()) return false;
  }
  return true;
}

void compare(const OrderedJson& from, const OrderedJson& to, const std::string& pointer,
             std::vector<recipe::Edit>& edits) {
  if (from == to && from.type() == to.type()) return;
  const bool objects = from.is_object() && to.is_object();
  const bool lists = from.is_array() && to.is_array() && from.size() == to.size();
  if (objects && (pointer.empty() || same_keys(from, to))) {
    for (const auto& [key, value] : from.items()) {
      if (!to.contains(key)) edits.emplace_back(recipe::SetValue{pointer + "/" + recipe::pointer_token(key), {}});
    }
    for (const auto& [key, value] : to.items()) {
      const std::string place = pointer + "/" + recipe::pointer_token(key);
      if (from.contains(key)) {
        compare(from[key], value, place, edits);
      } else {
        edits.emplace_back(recipe::SetValue{place, value});
      }
    }
  } else if (lists) {
    for (size_t i = 0; i < from.size(); ++i) compare(from[i], to[i], fmt::format("{}/{}", pointer, i), edits);
  } else {
    edits.emplace_back(recipe::SetValue{pointer, to});
  }
}

}  // namespace

recipe::Edit read_edit(const OrderedJson& json, const std::string& place) {
  const Members members(json, place);
  const std::string what = members.text("do");
  if (what == "set") return recipe::SetValue{members.text("pointer"), members.value()};
  if (what == "insert") return recipe::InsertItem{members.text("list"), members.index("index"), members.needed_value()};
  if (what == "remove") return recipe::RemoveItem{members.text("item")};
  if (what == "move") return recipe::MoveItem{members.text("item"), members.needed_index()};
  if (what == "rename") return recipe::RenameStep{members.text("id"), members.text("new_id")};
  if (what == "remove_step") return recipe::RemoveStep{members.text("id")};
  throw InvalidArgument(place, fmt::format("'{}' is no edit: set, insert, remove, move, rename or remove_step", what));
}

std::vector<recipe::Edit> read_edits(const OrderedJson& json) {
  if (!json.is_array()) throw InvalidArgument("edits", "is no list");
  std::vector<recipe::Edit> edits;
  for (size_t i = 0; i < json.size(); ++i) edits.push_back(read_edit(json[i], fmt::format("edits[{}]", i)));
  return edits;
}

OrderedJson write_edit(const recipe::Edit& edit) { return std::visit(Writer{}, edit); }

OrderedJson write_changes(const std::vector<recipe::Change>& changes) {
  OrderedJson list = OrderedJson::array();
  for (const recipe::Change& change : changes) {
    OrderedJson json = {{"pointer", change.pointer}, {"index", change.index}};
    if (change.before) json["before"] = *change.before;
    if (change.after) json["after"] = *change.after;
    list.push_back(std::move(json));
  }
  return list;
}

OrderedJson write_diagnostics(const std::vector<recipe::Diagnostic>& diagnostics) {
  OrderedJson list = OrderedJson::array();
  for (const recipe::Diagnostic& item : diagnostics)
    list.push_back(
        {{"pointer", item.pointer}, {"message", item.message}, {"line", item.line}, {"column", item.column}});
  return list;
}

std::string one_line(const OrderedJson& json) {
  return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

std::vector<recipe::Change> inverse(const std::vector<recipe::Change>& changes) {
  std::vector<recipe::Change> back(changes.rbegin(), changes.rend());
  for (recipe::Change& change : back) std::swap(change.before, change.after);
  return back;
}

std::vector<recipe::Edit> differences(const OrderedJson& from, const OrderedJson& to) {
  std::vector<recipe::Edit> edits;
  compare(from, to, "", edits);
  return edits;
}

}  // namespace seamount::server
