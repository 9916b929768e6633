#include "seamount/server/request.h"

#include <charconv>

namespace seamount::server {
namespace {

OrderedJson parse_body(const std::string& text) {
  recipe::parse_json(text, "the request");  // strict: depth, duplicate keys, numbers
  OrderedJson json = OrderedJson::parse(text);
  if (!json.is_object()) throw InvalidArgument("the request", "is no JSON object");
  return json;
}

}  // namespace

Body::Body(const std::string& text) : json_(parse_body(text)) {}

std::string Body::text(const char* name) const {
  const auto found = json_.find(name);
  if (found == json_.end() || !found->is_string()) throw InvalidArgument(name, "is missing, or no text");
  return found->get<std::string>();
}

std::string Body::text_or(const char* name, const std::string& absent) const {
  return json_.contains(name) ? text(name) : absent;
}

bool Body::flag(const char* name) const {
  const auto found = json_.find(name);
  if (found == json_.end()) return false;
  if (!found->is_boolean()) throw InvalidArgument(name, "is true or false");
  return found->get<bool>();
}

double Body::number_or(const char* name, double absent) const {
  const auto found = json_.find(name);
  if (found == json_.end()) return absent;
  if (!found->is_number()) throw InvalidArgument(name, "is no number");
  return found->get<double>();
}

const OrderedJson& Body::list(const char* name) const {
  const auto found = json_.find(name);
  if (found == json_.end() || !found->is_array()) throw InvalidArgument(name, "is missing, or no list");
  return *found;
}

Asker Body::asker() const {
  const auto base = json_.find("base");
  if (base == json_.end() || !base->is_number_unsigned()) throw InvalidArgument("base", "is missing, or no revision");
  return {window(), base->get<uint64_t>()};
}

std::string Body::window() const {
  std::string name = text("window");
  if (name.empty() || name.size() > 64) throw InvalidArgument("window", "is empty or longer than 64 bytes");
  return name;
}

int whole_number(const Request& request, const char* name, int absent) {
  const auto found = request.query.find(name);
  if (found == request.query.end()) return absent;
  int number = 0;
  const std::string& text = found->second;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || rest != text.data() + text.size()) throw InvalidArgument(name, "is no whole number");
  return number;
}

std::string query_text(const Request& request, const char* name) {
  const auto found = request.query.find(name);
  if (found == request.query.end() || found->second.empty()) throw InvalidArgument(name, "is missing");
  return found->second;
}

}  // namespace seamount::server
