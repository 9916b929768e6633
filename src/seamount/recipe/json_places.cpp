#include "seamount/recipe/json_places.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "seamount/recipe/json_document.h"

namespace seamount::recipe {
namespace {

/// The pointers that are looked for, as a tree of their parts.
struct Wanted {
  std::map<std::string, Wanted, std::less<>> below;
  size_t offset = 0;  ///< where the value, or its key, starts
  bool found = false;
};

/// Walks text that is known to be valid JSON. Values that nobody asked for cost no more than reading them.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
  }

  /// Notes where what is wanted stands.
  void scan(Wanted& wanted) {
    skip_space();
    found(&wanted, at_);
    value(&wanted);
  }

  /// Notes keys that appear twice too.
  std::vector<Diagnostic> scan_keys() {
    check_keys_ = true;
    skip_space();
    value(nullptr);
    return std::move(duplicates_);
  }

 private:
  static void found(Wanted* wanted, size_t offset) {
    if (wanted == nullptr || wanted->found) return;
    wanted->found = true;
    wanted->offset = offset;
  }

  static Wanted* child(Wanted* wanted, std::string_view part) {
    if (wanted == nullptr) return nullptr;
    const auto next = wanted->below.find(part);
    return next == wanted->below.end() ? nullptr : &next->second;
  }

  void skip_space() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n' || text_[at_] == '\r'))
      ++at_;
  }

  std::string_view string_token() {
    const size_t begin = at_++;
    for (; text_[at_] != '"'; ++at_) {
      if (text_[at_] == '\\') ++at_;
    }
    return text_.substr(begin, ++at_ - begin);
  }

  void value(Wanted* wanted) {
    if (text_[at_] == '{') {
      object(wanted);
    } else if (text_[at_] == '[') {
      array(wanted);
    } else if (text_[at_] == '"') {
      string_token();
    } else {
      while (at_ < text_.size() && std::string_view(",]} \t\r\n").find(text_[at_]) == std::string_view::npos) ++at_;
    }
    skip_space();
  }

  void object(Wanted* wanted) {
    std::set<std::string> keys;
    const bool named = check_keys_ || (wanted != nullptr && !wanted->below.empty());
    ++at_;
    for (skip_space(); text_[at_] != '}'; skip_space()) {
      const size_t key_at = at_;
      const std::string_view token = string_token();
      const std::string key = named ? nlohmann::json::parse(token).get<std::string>() : std::string();
      Wanted* next = named ? child(wanted, pointer_token(key)) : nullptr;
      found(next, key_at);
      if (check_keys_ && !keys.insert(key).second) report(key, key_at);
      path_.push_back(check_keys_ ? pointer_token(key) : std::string());
      skip_space();
      ++at_;  // ':'
      skip_space();
      value(next);
      path_.pop_back();
      if (text_[at_] == ',') ++at_;
    }
    ++at_;
  }

  void array(Wanted* wanted) {
    ++at_;
    skip_space();
    for (size_t index = 0; text_[at_] != ']'; ++index) {
      const bool named = check_keys_ || (wanted != nullptr && !wanted->below.empty());
      const std::string part = named ? std::to_string(index) : std::string();
      Wanted* next = named ? child(wanted, part) : nullptr;
      found(next, at_);
      path_.push_back(part);
      value(next);
      path_.pop_back();
      if (text_[at_] == ',') ++at_;
      skip_space();
    }
    ++at_;
  }

  void report(const std::string& key, size_t offset) {
    std::string pointer;
    for (const std::string& part : path_) pointer += "/" + part;
    const TextPlace place = place_of(text_, offset);
    duplicates_.push_back(
        {pointer + "/" + pointer_token(key), "the key '" + key + "' appears twice", place.line, place.column});
  }

  std::string_view text_;
  size_t at_ = 0;
  bool check_keys_ = false;
  std::vector<std::string> path_;
  std::vector<Diagnostic> duplicates_;
};

/// The nodes of the tree that were found, by their offset.
void collect(Wanted& node, std::vector<Wanted*>& all) {
  if (node.found) all.push_back(&node);
  for (auto& [part, below] : node.below) collect(below, all);
}

std::vector<std::string> parts_of(const std::string& pointer) {
  std::vector<std::string> parts;
  for (size_t begin = pointer.find('/'); begin != std::string::npos;) {
    const size_t end = pointer.find('/', begin + 1);
    parts.push_back(pointer.substr(begin + 1, end == std::string::npos ? end : end - begin - 1));
    begin = end;
  }
  return parts;
}

}  // namespace

TextPlace place_of(std::string_view text, size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const size_t line_begin = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  return {1 + static_cast<int>(std::count(before.begin(), before.end(), '\n')),
          1 + static_cast<int>(before.size() - line_begin)};
}

std::map<std::string, TextPlace> find_places(std::string_view text, const std::vector<std::string>& pointers) {
  Wanted root;
  for (const std::string& pointer : pointers) {
    Wanted* node = &root;
    for (const std::string& part : parts_of(pointer)) node = &node->below[part];
  }
  Scanner(text).scan(root);
  std::vector<Wanted*> nodes;
  collect(root, nodes);
  std::sort(nodes.begin(), nodes.end(), [](const Wanted* a, const Wanted* b) { return a->offset < b->offset; });
  std::map<const Wanted*, TextPlace> places;
  TextPlace place;
  size_t line_begin = 0, at = 0;
  for (const Wanted* node : nodes) {
    for (; at < node->offset; ++at) {
      if (text[at] != '\n') continue;
      ++place.line;
      line_begin = at + 1;
    }
    place.column = 1 + static_cast<int>(at - line_begin);
    places[node] = place;
  }
  std::map<std::string, TextPlace> result;
  for (const std::string& pointer : pointers) {
    const Wanted* node = &root;
    for (const std::string& part : parts_of(pointer)) {
      const Wanted& next = node->below.at(part);
      if (!next.found) break;
      node = &next;
    }
    result[pointer] = places[node];
  }
  return result;
}

std::vector<Diagnostic> find_duplicate_keys(std::string_view text) { return Scanner(text).scan_keys(); }

}  // namespace seamount::recipe
