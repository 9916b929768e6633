#include "seamount/recipe/json_document.h"

#include <gtest/gtest.h>

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

TEST(JsonDocument, KnowsTheirPlaces) {
  const JsonDocument document =
      parse_json("{\n  \"steps\": [\n    { \"id\": \"a\", \"x/y\": [1, {\"deep\": 2}] }\n  ]\n}", "a.json");
  EXPECT_EQ(document.places.at("/steps").line, 2);
  EXPECT_EQ(document.places.at("/steps").column, 3);
  EXPECT_EQ(document.places.at("/steps/0/id").line, 3);
  EXPECT_EQ(document.places.at("/steps/0/id").column, 7);
  EXPECT_EQ(document.places.at("/steps/0/x~1y/1/deep").column, 30);
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
