#include "seamount/recipe/json_text.h"

#include <optional>

namespace seamount::recipe {
namespace {

constexpr size_t kColumns = 120;

std::string scalar_text(const OrderedJson& value) {
  return value.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

/// Appends the value to a line that may have `room` columns more; false, and the line is of no use, if it does not fit.
bool append_line(const OrderedJson& value, size_t room, std::string& line) {
  const size_t end = line.size() + room;
  const auto left = [&] { return line.size() > end ? 0 : end - line.size(); };
  if (!value.is_structured() || value.empty()) {
    line += scalar_text(value);
    return line.size() <= end;
  }
  line += value.is_object() ? "{ " : "[";
  bool first = true;
  for (const auto& [key, item] : value.items()) {
    if (!first) line += ", ";
    first = false;
    if (value.is_object()) line += scalar_text(key) + ": ";
    if (left() == 0 || !append_line(item, left(), line)) return false;
  }
  line += value.is_object() ? " }" : "]";
  return line.size() <= end;
}

/// `used`: columns that stand before the value on its line; `after`: columns that follow it there.
void append(const OrderedJson& value, int depth, size_t used, size_t after, std::string& text) {
  if (std::string line; used + after < kColumns && append_line(value, kColumns - used - after, line)) {
    text += line;
    return;
  }
  if (!value.is_structured() || value.empty()) {
    text += scalar_text(value);
    return;
  }
  const std::string indent(2 * static_cast<size_t>(depth + 1), ' ');
  text += value.is_object() ? "{" : "[";
  size_t left = value.size();
  for (const auto& [key, item] : value.items()) {
    const std::string name = value.is_object() ? scalar_text(key) + ": " : "";
    text += "\n" + indent + name;
    --left;
    append(item, depth + 1, indent.size() + name.size(), left > 0 ? 1 : 0, text);
    if (left > 0) text += ",";
  }
  text += "\n" + indent.substr(2) + (value.is_object() ? "}" : "]");
}

}  // namespace

std::string readable_text(const OrderedJson& value) {
  std::string text;
  append(value, 0, 0, 0, text);
  return text + "\n";
}

}  // namespace seamount::recipe
