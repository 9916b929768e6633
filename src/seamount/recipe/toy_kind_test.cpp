// A kind of value that is registered from outside (test_tune.h) works in recipes, the cache, files, the schema and the
// reference like any other; on the command line too: tests/tune.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "seamount/io/atomic_file.h"
#include "seamount/recipe/executor.h"
#include "seamount/recipe/file_info.h"
#include "seamount/recipe/reference.h"
#include "seamount/recipe/test_tune.h"

namespace seamount::recipe {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Pair;

const char* const kRecipe = R"({"seamount": 1, "domain": {"width_m": 40, "height_m": 40, "cell_m": 10}, "steps": [
  {"id": "up", "op": "tune.scale", "params": {"count": 3}},
  {"id": "down", "op": "tune.turn", "in": {"tune": "up.tune"}}],
  "outputs": [{"from": "down.tune", "path": "down.tune"}, {"from": "down.bars", "path": "bars.tif"}]})";

class ToyKind : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string file(const std::string& name) const { return folder_ + "/" + name; }
  std::string text(const std::string& name) const {
    const std::vector<uint8_t> bytes = io::read_file(file(name));
    return {bytes.begin(), bytes.end()};
  }
  const std::string folder_ = ::testing::TempDir() + "seamount_toy_kind";
  const Registry registry_ = with_tunes();
};

TEST_F(ToyKind, RunsInARecipeAndIsWritten) {
  execute(parse_recipe(kRecipe, "tune.json", "", {}, registry_), {folder_, ""}, {});
  EXPECT_EQ(text("down.tune"), "CBA");
}

TEST_F(ToyKind, ComesBackFromTheCache) {
  const Recipe recipe = parse_recipe(kRecipe, "tune.json", "", {}, registry_);
  const int before = tune_runs();
  execute(recipe, {folder_, file("cache")}, {});
  const ExecuteReport again = execute(recipe, {folder_, file("cache")}, {});
  EXPECT_EQ(tune_runs(), before + 1);
  EXPECT_TRUE(again.steps[0].cached && again.steps[1].cached);
  EXPECT_EQ(text("down.tune"), "CBA");
}

TEST_F(ToyKind, IsReadFromAFile) {
  io::write_text(file("given.tune"), "xyz");
  const Recipe recipe = parse_recipe(R"({"seamount": 1, "domain": {"width_m": 40, "height_m": 40, "cell_m": 10},
    "steps": [{"id": "down", "op": "tune.turn", "in": {"tune": {"file": "given.tune"}}}],
    "outputs": [{"from": "down.tune", "path": "down.tune"}]})",
                                     "tune.json", folder_, {}, registry_);
  execute(recipe, {folder_, ""}, {});
  EXPECT_EQ(text("down.tune"), "zyx");
  EXPECT_THAT(describe_file(file("given.tune"), registry_), Contains(Pair("format", "tune")));
}

TEST_F(ToyKind, IsRefusedWhereAnotherKindIsNeeded) {
  try {
    parse_recipe(R"({"seamount": 1, "steps": [{"id": "up", "op": "tune.scale"},
      {"id": "w", "op": "terrain.layers", "in": {"terrain": "up.tune"}}]})",
                 "tune.json", "", {}, registry_);
    FAIL();
  } catch (const RecipeError& error) {
    EXPECT_THAT(error.what(), HasSubstr("'up.tune' is tune; terrain is needed here"));
  }
}

TEST_F(ToyKind, StandsInSchemaAndReference) {
  EXPECT_THAT(recipe_schema(registry_).dump(), HasSubstr("\"x-kind\":\"tune\""));
  EXPECT_THAT(reference_markdown(registry_), HasSubstr("## tune.turn"));
  EXPECT_THAT(describe_operator(*registry_.find_operator("tune.turn")), HasSubstr("tune (tune)"));
  EXPECT_THAT(describe_kind(TuneKind::kind(), registry_), HasSubstr("made by tune.scale, tune.turn"));
  EXPECT_EQ(standard_registry().find_kind("tune"), nullptr);
}

}  // namespace
}  // namespace seamount::recipe
