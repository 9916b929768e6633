#include "seamount/recipe/catalogue_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace seamount::recipe {
namespace {

using testing::HasSubstr;

const char* const kSmall = R"({
  "seamount_catalogue": 1,
  "name": "small",
  "materials": [{"name": "sand", "flow_coupling": 1, "decay_1_s": 0.001}],
  "classes": [
    {"name": "coral", "fitness": "bell(depth, 5, 3) - sand",
     "deposits": [{"material": "sand", "rate_1_s": 0.1, "radius_m": 4}],
     "placement": {"per_iteration": 50, "spacing_m": 3}}
  ]
})";

std::string error_of(const std::string& text) {
  try {
    parse_catalogue(text, "c.json");
  } catch (const RecipeError& error) {
    return error.what();
  }
  return "";
}

std::string with(const std::string& from, const std::string& to) {
  std::string text = kSmall;
  return text.replace(text.find(from), from.size(), to);
}

TEST(CatalogueJson, IsReadWithDefaultsAndWrittenBack) {
  const Catalogue catalogue = parse_catalogue(kSmall, "c.json");
  EXPECT_EQ(catalogue.classes.at(0).placement.per_iteration, 50);
  EXPECT_EQ(catalogue.classes.at(0).placement.most, 1000) << "a default";
  EXPECT_EQ(parse_catalogue(catalogue_json(catalogue).dump(), "again.json"), catalogue);
}

TEST(CatalogueJson, SaysWhatIsWrongWithLineAndColumn) {
  EXPECT_THAT(error_of("{}"), HasSubstr("this is no catalogue"));
  EXPECT_THAT(error_of(with(": 1,", ": 2,")), HasSubstr("version 2 is not known"));
  EXPECT_THAT(error_of(with("bell(depth, 5, 3)", "bell(dept, 5, 3)")),
              HasSubstr("c.json:6:23: /classes/0/fitness: column 6: unknown name 'dept', did you mean 'depth'?"));
  EXPECT_THAT(error_of(with("\"per_iteration\"", "\"per_iteratio\"")),
              HasSubstr("unknown parameter 'per_iteratio', did you mean 'per_iteration'?"));
  EXPECT_THAT(error_of(with("\"spacing_m\": 3", "\"spacing_m\": -3")), HasSubstr("is outside"));
  EXPECT_THAT(error_of(with("\"material\": \"sand\"", "\"material\": \"snad\"")), HasSubstr("did you mean 'sand'?"));
}

TEST(CatalogueJson, SchemaKnowsEveryMember) {
  const Json schema = catalogue_schema();
  const Json& of = schema["properties"]["classes"]["items"]["properties"];
  EXPECT_TRUE(of.contains("fitness"));
  EXPECT_TRUE(of["placement"]["properties"].contains("spacing_m"));
  EXPECT_TRUE(of["deposits"]["items"]["properties"].contains("rate_1_s"));
  EXPECT_FALSE(schema["additionalProperties"].get<bool>());
}

}  // namespace
}  // namespace seamount::recipe
