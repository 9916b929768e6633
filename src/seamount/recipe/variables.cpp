#include "seamount/recipe/variables.h"

#include <fmt/format.h>

#include <algorithm>

#include "seamount/base/text.h"

namespace seamount::recipe {
namespace {

constexpr int kDeepest = 64;
constexpr size_t kMostValues = 1'000'000;

bool good_name(std::string_view name) {
  const auto allowed = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  return !name.empty() && name.size() <= 64 && std::isdigit(static_cast<unsigned char>(name[0])) == 0 &&
         std::all_of(name.begin(), name.end(), allowed);
}

bool begins_with_dollar(const Json& value) {
  if (value.is_string()) return value.get_ref<const std::string&>().starts_with('$');
  return value.is_structured() && std::any_of(value.begin(), value.end(), begins_with_dollar);
}

std::vector<std::string> names_of(const Json& variables) {
  std::vector<std::string> names;
  for (const auto& [name, value] : variables.items()) names.push_back(name);
  return names;
}

/// Values in all, and levels below.
void measure(const Json& value, size_t& size, int& depth) {
  size = 1;
  depth = 0;
  if (!value.is_structured()) return;
  for (const Json& item : value) {
    size_t of_item = 0;
    int below = 0;
    measure(item, of_item, below);
    size += of_item;
    depth = std::max(depth, below + 1);
  }
}

}  // namespace

std::optional<std::string> variable_name(const Json& value) {
  if (!value.is_string()) return std::nullopt;
  const auto& text = value.get_ref<const std::string&>();
  if (!text.starts_with('$') || !good_name(std::string_view(text).substr(1))) return std::nullopt;
  return text.substr(1);
}

VariablesApplied::VariablesApplied(const Json& root, const ReadPlace& top) : root_(root), top_(top) {
  if (root.is_object() && (root.contains("variables") || begins_with_dollar(root))) {
    filled_ = root;
    if (root.contains("variables")) variables_ = &root["variables"];
    fill_document();
  }
  defects_before_ = top.diagnostics.items().size();
  notes_before_ = top.diagnostics.notes().size();
}

void VariablesApplied::fill_document() {
  const ReadPlace place = top_.at("variables");
  if (!variables_->is_object()) return place.expected("an object of variables", *variables_);
  for (const std::string& name : names_of(*variables_)) {
    if (good_name(name))
      resolve(name);
    else
      place.at(pointer_token(name)).fail("'" + name + "' is no name: letters, digits and '_', the first no digit");
  }
  if (filled_->contains("domain")) fill((*filled_)["domain"], top_.at("domain"), 1);
  const auto for_each_item = [&](const char* list, const auto& visit) {
    if (!filled_->contains(list) || !(*filled_)[list].is_array()) return;
    Json& items = (*filled_)[list];
    for (size_t i = 0; i < items.size(); ++i)
      if (items[i].is_object()) visit(items[i], top_.at(list).at(i));
  };
  for_each_item("steps", [&](Json& step, const ReadPlace& item) {
    if (step.contains("params")) fill(step["params"], item.at("params"), 3);
    if (!step.contains("in") || !step["in"].is_object()) return;
    for (auto& [port, source] : step["in"].items())
      if (source.is_object()) fill(source, item.at("in").at(pointer_token(port)), 4);
  });
  for_each_item("outputs", [&](Json& output, const ReadPlace& item) {
    fill_members(output, {"from", "path", "as", "labels", "about"}, item, 2);
  });
  for (const std::string& name : names_of(*variables_))
    if (!used_.contains(name)) place.at(pointer_token(name)).note("nothing uses '$" + name + "'");
}

void VariablesApplied::fill_members(Json& object, const std::vector<std::string>& kept, const ReadPlace& place,
                                    int depth) {
  for (auto& [key, value] : object.items()) {
    if (std::find(kept.begin(), kept.end(), key) == kept.end()) fill(value, place.at(pointer_token(key)), depth + 1);
  }
}

/// False: a variable in it has no value.
bool VariablesApplied::fill(Json& value, const ReadPlace& place, int depth) {
  bool whole = true;
  if (value.is_object()) {
    for (auto& [key, member] : value.items()) whole &= fill(member, place.at(pointer_token(key)), depth + 1);
  } else if (value.is_array()) {
    for (size_t i = 0; i < value.size(); ++i)
      if (value[i].is_structured() || value[i].is_string()) whole &= fill(value[i], place.at(i), depth + 1);
  } else if (const auto name = variable_name(value)) {
    whole = put_in(value, *name, place, depth);
    if (open_.empty()) uses_.push_back({place.pointer, *name, !whole});
  } else if (value.is_string() && value.get_ref<const std::string&>().starts_with("$$")) {
    value = value.get<std::string>().substr(1);
  }
  return whole;
}

bool VariablesApplied::put_in(Json& value, const std::string& name, const ReadPlace& place, int depth) {
  used_.insert(name);
  if (!variables_->contains(name)) {
    const std::vector<std::string> names = names_of(*variables_);
    place.fail("there is no variable '" + name + "'" +
               (names.empty() ? ": the recipe has no \"variables\"" : suggestion(name, names)));
    return false;
  }
  if (std::find(open_.begin(), open_.end(), name) != open_.end()) {
    place.fail(fmt::format("the variables need each other in a circle: {} -> {}", fmt::join(open_, " -> "), name));
    return false;
  }
  const Resolved& resolved = resolve(name);
  if (resolved.failed) return false;
  if (depth + resolved.depth > kDeepest || (values_ += resolved.size) > kMostValues) {
    place.fail(depth + resolved.depth > kDeepest
                   ? fmt::format("'${}' makes the recipe deeper than {} levels", name, kDeepest)
                   : fmt::format("'${}' makes the recipe larger by more than {} values", name, kMostValues));
    return false;
  }
  value = resolved.value;
  return true;
}

const VariablesApplied::Resolved& VariablesApplied::resolve(const std::string& name) {
  if (const auto known = resolved_.find(name); known != resolved_.end()) return known->second;
  Resolved resolved{(*variables_)[name]};
  open_.push_back(name);
  resolved.failed = !fill(resolved.value, top_.at("variables").at(name), 1);
  open_.pop_back();
  measure(resolved.value, resolved.size, resolved.depth);
  return resolved_.emplace(name, std::move(resolved)).first->second;
}

void VariablesApplied::name_variables() const {
  const auto of = [](const Diagnostic& item, const Use& use) {
    return item.pointer == use.pointer || item.pointer.starts_with(use.pointer + "/");
  };
  for (std::vector<Diagnostic>* items : {&top_.diagnostics.items(), &top_.diagnostics.notes()}) {
    const size_t before = items == &top_.diagnostics.items() ? defects_before_ : notes_before_;
    for (size_t i = items->size(); i-- > before;) {
      const auto use = std::find_if(uses_.begin(), uses_.end(), [&](const Use& one) { return of((*items)[i], one); });
      if (use == uses_.end()) continue;
      if (use->failed)  // said already
        items->erase(items->begin() + static_cast<std::ptrdiff_t>(i));
      else
        (*items)[i].message += " ($" + use->name + ")";
    }
  }
}

}  // namespace seamount::recipe
