#include "seamount/recipe/json_document.h"

#include <fmt/format.h>

#include "seamount/base/printable.h"
#include "seamount/recipe/json_places.h"

namespace seamount::recipe {
namespace {

constexpr size_t kDeepest = 64;

/// Builds the tree, looks for what is not allowed, and stops when it is asked to.
class TreeBuilder : public nlohmann::json_sax<Json> {
 public:
  TreeBuilder(Json& root, const RunContext& run) : root_(root), run_(run) {}

  bool too_deep() const { return too_deep_; }
  bool has_duplicate_keys() const { return has_duplicate_keys_; }
  size_t error_position() const { return error_position_; }
  /// The number that no double can hold; empty: none.
  const std::string& overflow() const { return overflow_; }
  const std::string& problem() const { return problem_; }

  bool null() override { return add(nullptr) != nullptr; }
  bool boolean(bool value) override { return add(value) != nullptr; }
  bool number_integer(int64_t value) override { return add(value) != nullptr; }
  bool number_unsigned(uint64_t value) override { return add(value) != nullptr; }
  bool number_float(double value, const std::string&) override { return add(value) != nullptr; }
  bool string(std::string& value) override { return add(std::move(value)) != nullptr; }
  bool binary(Json::binary_t&) override { return false; }  // no such thing in text

  bool start_object(size_t) override { return open(add(Json::object())); }
  bool start_array(size_t) override { return open(add(Json::array())); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(std::string& name) override {
    const auto [member, is_new] = open_.back()->get_ref<Json::object_t&>().emplace(std::move(name), nullptr);
    has_duplicate_keys_ |= !is_new;
    member_ = &member->second;
    return true;
  }

  bool parse_error(size_t position, const std::string& token, const nlohmann::detail::exception& error) override {
    error_position_ = position;
    if (dynamic_cast<const Json::out_of_range*>(&error) != nullptr) overflow_ = token;
    problem_ = error.what();
    return false;
  }

 private:
  /// The value in its place, or nullptr if it lies too deep.
  Json* add(Json&& value) {
    constexpr unsigned kPause = 4096;
    if (++values_ % kPause == 0) run_.check_cancelled();
    too_deep_ = open_.size() > kDeepest;
    if (too_deep_) return nullptr;
    if (open_.empty()) return &(root_ = std::move(value));
    if (open_.back()->is_object()) return &(*member_ = std::move(value));
    return &open_.back()->get_ref<Json::array_t&>().emplace_back(std::move(value));
  }

  bool open(Json* container) {
    if (container != nullptr) open_.push_back(container);
    return container != nullptr;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  Json& root_;
  const RunContext& run_;
  std::vector<Json*> open_;  ///< the containers that the next value is in, outermost first
  Json* member_ = nullptr;
  unsigned values_ = 0;
  bool too_deep_ = false, has_duplicate_keys_ = false;
  size_t error_position_ = 0;
  std::string overflow_, problem_;
};

[[noreturn]] void fail(const std::string& file, TextPlace place, std::string message) {
  throw RecipeError(file, {{"", std::move(message), place.line, place.column}});
}

/// The parser's own message without its code and repeated position: "expected ',' or '}'" and what it read.
std::string syntax_message(const std::string& what) {
  const size_t colon = what.find(": ", what.find("column"));
  return "not valid JSON: " + (colon == std::string::npos ? what : what.substr(colon + 2));
}

/// Where the token begins in which `position` lies, or which ends there.
size_t token_at(std::string_view text, size_t position) {
  constexpr std::string_view kSpace = " \t\r\n", kEnds = " \t\r\n,:[]{}\"";
  for (size_t at = text.find_first_not_of(kSpace); at < text.size(); at = text.find_first_not_of(kSpace, at)) {
    const size_t begin = at++;
    if (text[begin] == '"') {
      while (at < text.size() && text[at] != '"') at += text[at] == '\\' ? 2 : 1;
      ++at;
    } else if (kEnds.find(text[begin]) == std::string_view::npos) {
      at = std::min(text.find_first_of(kEnds, at), text.size());
    }
    if (at >= position) return begin;
  }
  return text.size();
}

/// Slips that are made by hand, by their own names and places: a comma after the last item, none between two, a remark.
/// `begin`: where the token stands that does not fit.
void fail_for_slip(const std::string& file, std::string_view text, size_t begin, const std::string& problem) {
  const size_t before = begin == 0 ? std::string_view::npos : text.find_last_not_of(" \t\r\n", begin - 1);
  if (begin >= text.size() || before == std::string_view::npos) return;
  const char found = text[begin], last = text[before];
  const bool ends = found == '}' || found == ']';
  const bool after_item = problem.ends_with("expected '}'") || problem.ends_with("expected ']'");
  const bool starts = std::string_view("\"{[-0123456789tfn").find(found) != std::string_view::npos;
  if (found == '/' || found == '#')
    fail(file, place_of(text, begin), "not valid JSON: JSON has no comments; \"about\" holds remarks");
  if (ends && last == ',')
    fail(file, place_of(text, before),
         fmt::format("not valid JSON: a comma before the '{}': none follows the last item", found));
  if (after_item && starts) fail(file, place_of(text, before + 1), "not valid JSON: a comma is missing here");
}

}  // namespace

std::string pointer_token(std::string_view key) {
  std::string token;
  for (const char c : key) {
    if (c == '~') {
      token += "~0";
    } else if (c == '/') {
      token += "~1";
    } else {
      token += c;
    }
  }
  return token;
}

JsonDocument parse_json(std::string_view text, const std::string& file, const RunContext& run) {
  if (text.size() > kLargestText) fail(file, {}, "longer than 64 MiB");
  JsonDocument document;
  TreeBuilder tree(document.root, run);
  const bool valid = Json::sax_parse(text, &tree);
  if (tree.too_deep()) fail(file, {}, fmt::format("nested deeper than {} levels", kDeepest));
  if (!tree.overflow().empty())
    fail(file, place_of(text, text.find(tree.overflow())), "the number " + tree.overflow() + " is too large");
  if (!valid) {
    const size_t position = tree.error_position();
    fail_for_slip(file, text, token_at(text, position), tree.problem());
    fail(file, place_of(text, position == 0 ? 0 : position - 1), syntax_message(tree.problem()));
  }
  if (tree.has_duplicate_keys()) throw RecipeError(file, find_duplicate_keys(text));
  document.text = text;
  return document;
}

void place_diagnostics(Diagnostics& diagnostics, const JsonDocument& document) {
  std::vector<std::string> pointers;
  const auto for_each_unplaced = [&](const auto& visit) {
    for (std::vector<Diagnostic>* items : {&diagnostics.items(), &diagnostics.notes()})
      for (Diagnostic& item : *items)
        if (item.line == 0) visit(item);
  };
  for_each_unplaced([&](const Diagnostic& item) { pointers.push_back(item.pointer); });
  const auto places = find_places(document.text, pointers);
  for_each_unplaced([&](Diagnostic& item) {
    item.line = places.at(item.pointer).line;
    item.column = places.at(item.pointer).column;
  });
}

std::string diagnostic_line(const std::string& file, const Diagnostic& diagnostic) {
  std::string text = printable(file);
  if (diagnostic.line > 0) text += fmt::format(":{}:{}", diagnostic.line, diagnostic.column);
  return text + ": " +
         printable(diagnostic.pointer.empty() ? diagnostic.message : diagnostic.pointer + ": " + diagnostic.message);
}

RecipeError::RecipeError(const std::string& file, std::vector<Diagnostic> diagnostics)
    : Error([&] {
        std::string text;
        for (const Diagnostic& d : diagnostics) text += (text.empty() ? "" : "\n") + diagnostic_line(file, d);
        return text;
      }()),
      diagnostics_(std::move(diagnostics)) {}

}  // namespace seamount::recipe
