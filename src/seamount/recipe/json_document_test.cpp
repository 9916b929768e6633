#include "seamount/recipe/json_document.h"

#include <gtest/gtest.h>

#include <atomic>

namespace seamount::recipe {
namespace {

std::string message_of(const std::string& text) {
  try {
    parse_json(text, "a.json");
  } catch (const RecipeError& error) {
    return error.what();
  }
  return "no error";
}

TEST(JsonDocument, KnowsThePlacesOfItsValues) {
  const std::string text = "{\n  \"steps\": [\n    { \"id\": \"a\", \"x/y\": [1, {\"deep\": 2}] }\n  ]\n}";
  for (const std::string mark : {"", "\xEF\xBB\xBF"}) {
    Diagnostics diagnostics;
    for (const char* pointer : {"", "/steps", "/steps/0/id", "/steps/0/x~1y/1/deep"}) diagnostics.add(pointer, "?");
    place_diagnostics(diagnostics, parse_json(mark + text, "a.json"));
    std::string places;
    for (const Diagnostic& item : diagnostics.items())
      places += std::to_string(item.line) + ":" + std::to_string(item.column) + " ";
    EXPECT_EQ(places, (mark.empty() ? "1:1" : "1:4") + std::string(" 2:3 3:7 3:30 "));
  }
}

TEST(JsonDocument, PlacesDiagnosticsAtTheNearestValue) {
  const JsonDocument document = parse_json("{\n\"a\": {\n\"b\": 1}}", "a.json");
  Diagnostics diagnostics;
  diagnostics.add("/a/b/missing", "?");
  diagnostics.add("/a/c", "?");
  place_diagnostics(diagnostics, document);
  EXPECT_EQ(diagnostics.items()[0].line, 3);
  EXPECT_EQ(diagnostics.items()[1].line, 2);
}

TEST(JsonDocument, RefusesWhatIsNotStrictJsonWithItsPlace) {
  EXPECT_EQ(message_of("{\"a\": 1, \"a\": 2}"), "a.json:1:10: /a: the key 'a' appears twice");
  EXPECT_EQ(message_of("{\"a\": 1,\n \"b\" 2}").substr(0, 28), "a.json:2:6: not valid JSON: ");
  EXPECT_EQ(message_of("").substr(0, 28), "a.json:1:1: not valid JSON: ");
  EXPECT_EQ(message_of("{\"a\": 1e999}"), "a.json:1:7: the number 1e999 is too large");
  EXPECT_NE(message_of("{\"a\": NaN}"), "no error");
  EXPECT_NE(message_of("{} trailing"), "no error");
  EXPECT_NE(message_of(std::string("{\"a\": \"\xff\"}")), "no error");
}

TEST(JsonDocument, CallsSlipsByTheirNames) {
  EXPECT_EQ(message_of("{\"a\": 1,}"),
            "a.json:1:8: not valid JSON: a comma before the '}': none follows the last item");
  EXPECT_EQ(message_of("{\"a\": [1, 2,\n  ]\n}"),
            "a.json:1:12: not valid JSON: a comma before the ']': none follows the last item");
  EXPECT_EQ(message_of("{\"a\": {\"b\": \"x\"\n , \n } }"),
            "a.json:2:2: not valid JSON: a comma before the '}': none follows the last item");
  EXPECT_EQ(message_of("{\"a\": 1 \"b\": 2}"), "a.json:1:8: not valid JSON: a comma is missing here");
  EXPECT_EQ(message_of("[{\"a\": 1}\n {\"b\": 2}]"), "a.json:1:10: not valid JSON: a comma is missing here");
  EXPECT_EQ(message_of("[1 2]"), "a.json:1:3: not valid JSON: a comma is missing here");
  EXPECT_EQ(message_of("[1, // one\n 2]").substr(0, 48), "a.json:1:5: not valid JSON: JSON has no comments");
  for (const char* other : {"{\"a\" 2}", "{} trailing", "[,1]", "{,}", "[1", "{\"a\": ]", "]"}) {
    EXPECT_EQ(message_of(other).find("comma"), std::string::npos) << message_of(other);
    EXPECT_NE(message_of(other).find("not valid JSON"), std::string::npos);
  }
}

TEST(JsonDocument, NamesEveryKeyThatAppearsTwice) {
  EXPECT_EQ(message_of("{\"a\": [{\"b\": 1,\n\"b\": 2}], \"a\": 3}"),
            "a.json:2:1: /a/0/b: the key 'b' appears twice\na.json:2:11: /a: the key 'a' appears twice");
}

/// Places were computed for every value before: 24 s for a text of the largest size.
TEST(JsonDocument, LongTextCanBeCancelledAndItsDefectsAreFoundInOnePass) {
  std::string text = "{\"a\": [";
  for (int i = 0; i < 300000; ++i) text += std::to_string(i) + ",\n";
  text += "0]}";
  const std::atomic<bool> cancelled{true};
  RunContext run;
  run.cancelled = &cancelled;
  EXPECT_THROW(parse_json(text, "a.json", run), Cancelled);
  const JsonDocument document = parse_json(text, "a.json");
  Diagnostics diagnostics;
  for (int i = 0; i < 300000; i += 3) diagnostics.add("/a/" + std::to_string(i), "?");
  place_diagnostics(diagnostics, document);
  EXPECT_EQ(diagnostics.items().back().line, 299998);
}

TEST(JsonDocument, RefusesBottomlessNesting) {
  for (const size_t depth : {size_t{100}, size_t{1000000}}) {
    EXPECT_EQ(message_of(std::string(depth, '[') + std::string(depth, ']')),
              "a.json:1:1: nested deeper than 64 levels");
  }
  EXPECT_EQ(message_of(std::string(60, '[') + std::string(60, ']')), "no error");
}

TEST(JsonDocument, TruncatedAtEveryLengthIsAnErrorAndNeverACrash) {
  const std::string text = R"({"seamount": 1, "steps": [{"id": "a\u00e9\"", "params": {"x": [-1.5e3, true, null]}}]})";
  EXPECT_EQ(message_of(text), "no error");
  for (size_t n = 0; n < text.size(); ++n) EXPECT_NE(message_of(text.substr(0, n)), "no error") << n;
}

}  // namespace
}  // namespace seamount::recipe
