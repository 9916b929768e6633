#include "seamount/server/access.h"

#include <gtest/gtest.h>

namespace seamount::server {
namespace {

class AccessTest : public testing::Test {
 protected:
  Asking own(const std::string& method = "GET", const std::string& path = "/api/document") const {
    Asking asking{.method = method, .path = path, .host = "127.0.0.1:8421"};
    asking.authorization = "Bearer 0123456789abcdef";
    if (method == "POST") {
      asking.content_length = "2";
      asking.content_type = "application/json";
    }
    return asking;
  }
  int status(const Asking& asking) const {
    const auto refusal = access_.refuse(asking);
    return refusal ? refusal->status : 200;
  }
  Access access_{"0123456789abcdef", {"127.0.0.1:8421", "localhost:8421"}};
};

TEST_F(AccessTest, AnswersItsOwnPage) {
  EXPECT_EQ(status(own()), 200);
  EXPECT_EQ(status(own("POST", "/api/edits")), 200);
  Asking asking = own();
  asking.origin = "http://localhost:8421";
  asking.fetch_site = "same-origin";
  EXPECT_EQ(status(asking), 200);
  EXPECT_EQ(status({.method = "GET", .path = "/", .host = "localhost:8421", .fetch_site = "cross-site"}), 200);
}

TEST_F(AccessTest, NeedsTheWholeToken) {
  for (const char* wrong : {"", "Bearer ", "Bearer 0123456789abcde", "Bearer 0123456789abcdef0", "0123456789abcdef",
                            "Basic 0123456789abcdef", "bearer 0123456789abcdef", "Bearer 0123456789abcdeg"}) {
    Asking asking = own();
    asking.authorization = wrong;
    EXPECT_EQ(status(asking), 401) << wrong;
  }
}

TEST_F(AccessTest, RefusesOtherHostsAndPages) {
  for (const char* host : {"", "evil.example", "evil.example:8421", "127.0.0.1", "127.0.0.1:8422", "127.0.0.1:84210",
                           "127.0.0.1:8421.evil.example", "localhost.evil.example:8421", "LOCALHOST:8421"}) {
    Asking asking = own();
    asking.host = host;
    EXPECT_EQ(status(asking), 403) << host;
  }
  for (const char* origin : {"null", "http://evil.example", "https://127.0.0.1:8421",
                             "http://127.0.0.1:8421.evil.example", "http://127.0.0.1:8421/", "http://localhost"}) {
    Asking asking = own();
    asking.origin = origin;
    EXPECT_EQ(status(asking), 403) << origin;
  }
  Asking asking = own();
  asking.fetch_site = "cross-site";
  EXPECT_EQ(status(asking), 403);
  asking.path = "/app.js";
  EXPECT_EQ(status(asking), 403);
}

TEST_F(AccessTest, RefusesBodiesThatCannotBeTrusted) {
  const auto with = [&](auto&& change) {
    Asking asking = own("POST", "/api/edits");
    change(asking);
    return status(asking);
  };
  EXPECT_EQ(with([](Asking& a) { a.transfer_encoding = "chunked"; }), 411);
  EXPECT_EQ(with([](Asking& a) { a.content_encoding = "br"; }), 415);
  EXPECT_EQ(with([](Asking& a) { a.content_length = ""; }), 411);
  EXPECT_EQ(with([](Asking& a) { a.content_length = "-1"; }), 400);
  EXPECT_EQ(with([](Asking& a) { a.content_length = "12x"; }), 400);
  EXPECT_EQ(with([](Asking& a) { a.content_length = "99999999999999999999"; }), 400);
  EXPECT_EQ(with([](Asking& a) { a.content_length = "67108865"; }), 413);
  EXPECT_EQ(with([](Asking& a) { a.path = "/api/upload", a.content_length = "67108865"; }), 200);
  EXPECT_EQ(with([](Asking& a) { a.path = "/api/upload", a.content_length = "1073741825"; }), 413);
  EXPECT_EQ(with([](Asking& a) { a.content_type = "text/plain"; }), 415);
  EXPECT_EQ(with([](Asking& a) { a.content_type = "multipart/form-data; boundary=x"; }), 415);
  EXPECT_EQ(with([](Asking& a) { a.range = "bytes=0-1"; }), 416);
  EXPECT_EQ(with([](Asking& a) { a.twice = true; }), 400);
  EXPECT_EQ(with([](Asking& a) { a.target_bytes = 2049; }), 414);
  EXPECT_EQ(status(own("PUT")), 405);
  EXPECT_EQ(status(own("OPTIONS")), 405);
  EXPECT_EQ(status(own("POST", "/app.js")), 405);
}

TEST(MakeToken, IsNeverTheSame) {
  EXPECT_EQ(make_token().size(), 32U);
  EXPECT_NE(make_token(), make_token());
}

}  // namespace
}  // namespace seamount::server
