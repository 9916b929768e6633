// Who may speak to the studio. It is a program of one user on one machine: what it answers is for the page that it
// opened alone, although every page in the user's browser can send requests to it.
//
// The token is in the fragment of the address that is opened, so that it is in no log and no Referer. It comes back in
// a header that a foreign page cannot set; there is no cookie. A name that somebody else's DNS points to this machine
// is refused by Host, a foreign page by Origin and Sec-Fetch-Site.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace seamount::server {

/// What of a request decides whether it is answered. A header that is absent is empty; one that came twice is refused
/// by whoever fills this in (`twice`).
struct Asking {
  std::string method;
  std::string path;  ///< without the query
  std::string host;
  std::string origin;
  std::string authorization;
  std::string fetch_site;  ///< Sec-Fetch-Site
  std::string transfer_encoding;
  std::string content_encoding;
  std::string content_length;
  std::string content_type;
  std::string range;
  size_t target_bytes = 0;  ///< of the path with its query
  bool twice = false;       ///< one of these headers came more than once
};

struct Refusal {
  int status;
  std::string message;
};

class Access {
 public:
  /// `hosts`: exactly what Host may be: "127.0.0.1:8421", "localhost:8421".
  Access(std::string token, std::vector<std::string> hosts);

  /// Why a request is not answered; nothing if it is. Paths under /api need the token; the page itself does not.
  std::optional<Refusal> refuse(const Asking& asking) const;

  /// The most bytes that a body at this path may have.
  static uint64_t largest_body(const std::string& path);

  const std::string& token() const { return token_; }

 private:
  std::string token_;
  std::vector<std::string> hosts_;
};

/// 32 random hex digits from the system. Throws Error if it has none.
std::string make_token();

}  // namespace seamount::server
