#include "seamount/recipe/json_document.h"

#include <fmt/format.h>

#include <set>

namespace seamount::recipe {
namespace {

constexpr int kDeepest = 64;

TextPlace place_of(std::string_view text, size_t offset) {
  TextPlace place;
  for (size_t i = 0; i < std::min(offset, text.size()); ++i) {
    if (text[i] == '\n') {
      ++place.line;
      place.column = 1;
    } else {
      ++place.column;
    }
  }
  return place;
}

/// Walks text that is known to be valid JSON and notes where each value starts.
class PlaceScanner {
 public:
  PlaceScanner(std::string_view text, JsonDocument& document, Diagnostics& diagnostics)
      : text_(text), document_(document), diagnostics_(diagnostics) {}

  void scan() { value(""); }

 private:
  void advance() {
    if (text_[at_] == '\n') {
      ++place_.line;
      place_.column = 1;
    } else {
      ++place_.column;
    }
    ++at_;
  }

  void skip_space() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n' || text_[at_] == '\r'))
      advance();
  }

  std::string_view string_token() {
    const size_t begin = at_;
    advance();
    while (text_[at_] != '"') {
      if (text_[at_] == '\\') advance();
      advance();
    }
    advance();
    return text_.substr(begin, at_ - begin);
  }

  void value(const std::string& pointer) {
    skip_space();
    document_.places.try_emplace(pointer, place_);
    if (text_[at_] == '{') {
      object(pointer);
    } else if (text_[at_] == '[') {
      array(pointer);
    } else if (text_[at_] == '"') {
      string_token();
    } else {
      while (at_ < text_.size() && std::string_view(",]} \t\r\n").find(text_[at_]) == std::string_view::npos) advance();
    }
    skip_space();
  }

  void object(const std::string& pointer) {
    std::set<std::string> keys;
    advance();
    skip_space();
    while (text_[at_] != '}') {
      skip_space();
      const TextPlace key_place = place_;
      const auto key = Json::parse(string_token()).get<std::string>();
      const std::string member = pointer + "/" + pointer_token(key);
      if (!keys.insert(key).second) {
        diagnostics_.items().push_back(
            {member, "the key '" + key + "' appears twice", key_place.line, key_place.column});
      }
      document_.places[member] = key_place;
      skip_space();
      advance();  // ':'
      value(member);
      if (text_[at_] == ',') advance();
      skip_space();
    }
    advance();
  }

  void array(const std::string& pointer) {
    advance();
    skip_space();
    for (size_t index = 0; text_[at_] != ']'; ++index) {
      value(pointer + "/" + std::to_string(index));
      if (text_[at_] == ',') advance();
      skip_space();
    }
    advance();
  }

  std::string_view text_;
  JsonDocument& document_;
  Diagnostics& diagnostics_;
  size_t at_ = 0;
  TextPlace place_;
};

[[noreturn]] void fail(const std::string& file, TextPlace place, std::string message) {
  throw RecipeError(file, {{"", std::move(message), place.line, place.column}});
}

/// The parser's own message without its code and repeated position: "expected ',' or '}'" and what it read.
std::string syntax_message(const std::string& what) {
  const size_t colon = what.find(": ", what.find("column"));
  return "not valid JSON: " + (colon == std::string::npos ? what : what.substr(colon + 2));
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

JsonDocument parse_json(std::string_view text, const std::string& file) {
  if (text.size() > kLargestText) fail(file, {}, "longer than 64 MiB");
  JsonDocument document;
  bool too_deep = false;
  const auto limit_depth = [&](int depth, Json::parse_event_t, Json&) {
    if (depth > kDeepest) too_deep = true;
    return !too_deep;
  };
  try {
    document.root = Json::parse(text, limit_depth);
  } catch (const Json::parse_error& error) {
    fail(file, place_of(text, error.byte == 0 ? 0 : error.byte - 1), syntax_message(error.what()));
  } catch (const Json::exception& error) {
    // "[json.exception.out_of_range.406] number overflow parsing '1e999'": the only other one that parsing throws.
    const std::string what = error.what();
    const size_t quote = what.find('\'');
    const std::string number = quote == std::string::npos ? what : what.substr(quote + 1, what.size() - quote - 2);
    fail(file, place_of(text, text.find(number)), "the number " + number + " is too large");
  }
  if (too_deep) fail(file, {}, fmt::format("nested deeper than {} levels", kDeepest));
  Diagnostics diagnostics;
  PlaceScanner(text, document, diagnostics).scan();
  if (!diagnostics.empty()) throw RecipeError(file, diagnostics.items());
  return document;
}

void place_diagnostics(Diagnostics& diagnostics, const JsonDocument& document) {
  const auto place = [&](Diagnostic& item) {
    if (item.line > 0) return;
    for (std::string pointer = item.pointer;; pointer.erase(pointer.rfind('/'))) {
      if (const auto found = document.places.find(pointer); found != document.places.end()) {
        item.line = found->second.line;
        item.column = found->second.column;
        break;
      }
      if (pointer.empty()) break;
    }
  };
  for (Diagnostic& item : diagnostics.items()) place(item);
  for (Diagnostic& note : diagnostics.notes()) place(note);
}

std::string diagnostic_line(const std::string& file, const Diagnostic& diagnostic) {
  std::string text = file;
  if (diagnostic.line > 0) text += fmt::format(":{}:{}", diagnostic.line, diagnostic.column);
  text += ": ";
  if (!diagnostic.pointer.empty()) text += diagnostic.pointer + ": ";
  return text + diagnostic.message;
}

RecipeError::RecipeError(const std::string& file, std::vector<Diagnostic> diagnostics)
    : Error([&] {
        std::string text;
        for (const Diagnostic& d : diagnostics) text += (text.empty() ? "" : "\n") + diagnostic_line(file, d);
        return text;
      }()),
      diagnostics_(std::move(diagnostics)) {}

}  // namespace seamount::recipe
