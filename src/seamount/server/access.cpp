#include "seamount/server/access.h"

#include <sys/random.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "seamount/base/error.h"

namespace seamount::server {
namespace {

constexpr size_t kLongestTarget = 2048;
constexpr uint64_t kLargestUpload = uint64_t{1} << 30;
constexpr uint64_t kLargestRequest = uint64_t{64} << 20;  // a recipe's text

/// Takes as long for every token of the right length.
bool same(const std::string& a, const std::string& b) {
  if (a.size() != b.size()) return false;
  unsigned char difference = 0;
  for (size_t i = 0; i < a.size(); ++i) difference |= static_cast<unsigned char>(a[i] ^ b[i]);
  return difference == 0;
}

std::optional<Refusal> refuse_body(const Asking& asking) {
  if (!asking.transfer_encoding.empty()) return Refusal{411, "a body needs a Content-Length"};
  if (!asking.content_encoding.empty()) return Refusal{415, "a body is sent as it is, without Content-Encoding"};
  if (!asking.range.empty()) return Refusal{416, "results are sent as a whole, without Range"};
  if (asking.content_length.empty())
    return asking.method == "POST" ? std::optional(Refusal{411, "a body needs a Content-Length"}) : std::nullopt;
  if (asking.method == "POST" && asking.content_type != "application/json" &&
      asking.content_type != "application/octet-stream")
    return Refusal{415, "a body is application/json, or application/octet-stream for an upload"};
  uint64_t bytes = 0;
  const char* end = asking.content_length.data() + asking.content_length.size();
  const auto [rest, error] = std::from_chars(asking.content_length.data(), end, bytes);
  if (error != std::errc() || rest != end) return Refusal{400, "Content-Length is no number"};
  if (bytes > 0 && asking.method != "POST") return Refusal{400, "only POST has a body"};
  if (bytes > Access::largest_body(asking.path)) return Refusal{413, "the body is too large"};
  return std::nullopt;
}

}  // namespace

Access::Access(std::string token, std::vector<std::string> hosts)
    : token_(std::move(token)), hosts_(std::move(hosts)) {}

uint64_t Access::largest_body(const std::string& path) {
  return path == "/api/upload" ? kLargestUpload : kLargestRequest;
}

std::optional<Refusal> Access::refuse(const Asking& asking) const {
  if (asking.twice) return Refusal{400, "a header came twice"};
  if (asking.target_bytes > kLongestTarget) return Refusal{414, "the address is too long"};
  if (asking.method != "GET" && asking.method != "POST") return Refusal{405, "only GET and POST are answered"};
  if (std::find(hosts_.begin(), hosts_.end(), asking.host) == hosts_.end())
    return Refusal{403, "this studio is not at the host that was asked for"};
  const auto is_own = [&](const std::string& host) { return asking.origin == "http://" + host; };
  if (!asking.origin.empty() && std::none_of(hosts_.begin(), hosts_.end(), is_own))
    return Refusal{403, "requests of other pages are not answered"};
  const bool opens_page = asking.method == "GET" && asking.path == "/";
  if (!opens_page && asking.fetch_site == "cross-site") return Refusal{403, "requests of other pages are not answered"};
  if (auto refusal = refuse_body(asking)) return refusal;
  const bool is_page = asking.path.compare(0, 5, "/api/") != 0;
  if (is_page) return asking.method == "GET" ? std::nullopt : std::optional(Refusal{405, "the page is only read"});
  if (!same(asking.authorization, "Bearer " + token_))
    return Refusal{401, "the address that the studio was opened with holds a token; this request has none"};
  return std::nullopt;
}

std::string make_token() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw Error("the system has no random numbers for the studio's token");
  std::string token;
  for (const unsigned char byte : bytes) {
    token += "0123456789abcdef"[byte >> 4];
    token += "0123456789abcdef"[byte & 15];
  }
  return token;
}

}  // namespace seamount::server
