// What a window asks of the studio, and how it is read.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "seamount/server/session.h"

namespace seamount::server {

struct Request {
  std::string method, path;
  std::map<std::string, std::string> query;
  std::string body;
};

/// Hands over the body of a request piece by piece; false: it did not come to its end.
using Receive = std::function<bool(const std::function<bool(const char*, size_t)>&)>;

/// The members of a request's body. Each function throws InvalidArgument for what is missing or of another type.
class Body {
 public:
  /// Throws Error for what is no JSON object, as strictly as recipes are read.
  explicit Body(const std::string& text);

  bool has(const char* name) const { return json_.contains(name); }
  std::string text(const char* name) const;
  std::string text_or(const char* name, const std::string& absent) const;
  bool flag(const char* name) const;
  double number_or(const char* name, double absent) const;
  const OrderedJson& list(const char* name) const;
  Asker asker() const;
  std::string window() const;

 private:
  OrderedJson json_;
};

/// Of the address behind "?". Both throw InvalidArgument.
int whole_number(const Request& request, const char* name, int absent);
std::string query_text(const Request& request, const char* name);

}  // namespace seamount::server
