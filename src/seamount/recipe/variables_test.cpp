// Variables: where they stand, what is said of wrong ones, and that nothing grows without bound.
#include "seamount/recipe/variables.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "seamount/recipe/document.h"

namespace seamount::recipe {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string text(const std::string& variables, const std::string& params, const std::string& output = "") {
  return R"({"seamount": 1, "variables": )" + variables + R"(, "domain": {"cell_m": 100}, "steps": [
    {"id": "isle", "op": "island.build", "params": )" +
         params + R"(}], "outputs": [)" + output + "]}";
}

Recipe read(const std::string& recipe, const RecipeChanges& changes = {}) {
  return parse_recipe(recipe, "r.json", "", changes);
}

std::vector<std::string> defects(const std::string& recipe, const RecipeChanges& changes = {}) {
  std::vector<std::string> all;
  try {
    read(recipe, changes);
  } catch (const RecipeError& error) {
    for (const Diagnostic& d : error.diagnostics()) all.push_back(d.pointer + ": " + d.message);
  }
  return all;
}

TEST(Variables, StandForNumbersTextsAndGroups) {
  const std::string recipe =
      R"({"seamount": 1, "variables": {"high": 900, "far": 70000, "shape": "smooth", "dem": "d.tif",
      "hero": {"azimuth_deg": "$bearing", "distance": 0.5}, "bearing": 160},
    "domain": {"width_m": "$far", "height_m": "$far", "cell_m": 700},
    "steps": [{"id": "isle", "op": "island.build", "params": {"peak_m": "$high", "interpolation": "$shape"}},
              {"id": "hill", "op": "terrain.smooth", "in": {"terrain": {"file": "$dem"}}}],
    "outputs": [{"from": "isle.terrain", "path": "a.png", "as": "perspective", "camera": "$hero"},
                {"from": "isle.terrain", "path": "b.png", "as": "perspective", "camera": "$hero", "width_px": 640}]})";
  const std::vector<std::string> found = defects(recipe);
  ASSERT_THAT(found, ElementsAre(HasSubstr("unknown choice 'smooth'")));
  EXPECT_THAT(found[0], HasSubstr("/steps/0/params/interpolation: "));
  EXPECT_THAT(found[0], ::testing::EndsWith("($shape)"));
  const Recipe good = read(recipe, {.sets = {"variables.shape=linear"}, .seed = {}, .size = {}});
  EXPECT_TRUE(good.notes.empty());
  EXPECT_EQ(good.domain.width, 100);
  EXPECT_EQ(good.steps[0].params["peak_m"], 900);
  EXPECT_EQ(good.steps[1].in.at("terrain").file, "d.tif");
  EXPECT_EQ(good.steps[2].params["camera"]["azimuth_deg"], 160);
  EXPECT_EQ(good.steps[3].params["camera"], good.steps[2].params["camera"]);
}

/// A recipe with variables is the recipe with their values: the same steps and parameters, so the same results.
TEST(Variables, AreTheSameRecipeAsTheirValues) {
  const Recipe with = read(text(R"({"p": 750, "q": "$p"})", R"({"peak_m": "$q", "feature": "$$p"})"));
  const Recipe without = read(text("{}", R"({"peak_m": 750, "feature": "$$p"})"));
  EXPECT_EQ(with.steps[0].params, without.steps[0].params);
  EXPECT_EQ(with.steps[0].params["feature"], "$p");
  EXPECT_EQ(with.steps[0].seed.value, without.steps[0].seed.value);
}

TEST(Variables, UnknownOnesAreSaidWithTheNearest) {
  EXPECT_THAT(defects(text(R"({"high": 1})", R"({"peak_m": "$hihg"})")),
              ElementsAre("/steps/0/params/peak_m: there is no variable 'hihg', did you mean 'high'?"));
  EXPECT_THAT(
      defects(R"({"seamount": 1, "steps": [{"id": "isle", "op": "island.build", "params": {"peak_m": "$p"}}]})"),
      ElementsAre("/steps/0/params/peak_m: there is no variable 'p': the recipe has no \"variables\""));
  EXPECT_THAT(defects(text(R"({"a": ["$b"], "b": {"x": "$a"}})", R"({"profile": "$a"})")),
              ElementsAre("/variables/b/x: the variables need each other in a circle: a -> b -> a"));
  EXPECT_THAT(defects(text(R"({"a b": 1})", "{}")), ElementsAre(HasSubstr("/variables/a b: 'a b' is no name")));
  EXPECT_THAT(defects(text("[]", "{}")), ElementsAre(HasSubstr("/variables: expected an object of variables")));
}

TEST(Variables, AWrongValueIsSaidWhereItStandsWithItsName) {
  EXPECT_THAT(defects(text(R"({"rough": 7})", R"({"relief": "$rough"})")),
              ElementsAre("/steps/0/params/relief: relief: 7 is outside [0, 2] ($rough)"));
}

TEST(Variables, OneThatNothingUsesIsNoted) {
  const Recipe recipe = read(text(R"({"a": 1, "b": 900})", R"({"peak_m": "$b"})"));
  ASSERT_EQ(recipe.notes.size(), 1U);
  EXPECT_EQ(recipe.notes[0].pointer, "/variables/a");
  EXPECT_EQ(recipe.notes[0].message, "nothing uses '$a'");
}

TEST(Variables, DoNotGrowWithoutBound) {
  std::string twofold = R"({"v0": [1, 1])";
  for (int i = 1; i < 60; ++i) twofold += fmt::format(R"(, "v{}": ["$v{}", "$v{}"])", i, i - 1, i - 1);
  EXPECT_THAT(defects(text(twofold + "}", "{}")).front(),
              HasSubstr("makes the recipe larger by more than 1000000 values"));
  std::string deep = R"({"v000": [1])";
  for (int i = 1; i < 300; ++i) deep += fmt::format(R"(, "v{:03}": ["$v{:03}"])", i, i - 1);
  EXPECT_THAT(defects(text(deep + "}", "{}")).front(), HasSubstr("deeper than 64 levels"));
}

TEST(Variables, AreSetFromTheCommandLine) {
  const std::string recipe = text(R"({"high": 900, "hero": {"azimuth_deg": 100}})", R"({"peak_m": "$high"})",
                                  R"({"from": "isle.terrain", "path": "a.png", "as": "perspective", "camera": "$hero"},
                                     {"from": "isle.terrain", "path": "b.png", "as": "perspective", "camera": "$hero"})");
  const auto with = [&](const std::string& set) { return read(recipe, {.sets = {set}, .seed = {}, .size = {}}); };
  EXPECT_EQ(with("variables.high=450").steps[0].params["peak_m"], 450);
  EXPECT_EQ(with("variables.hero.azimuth_deg=7").steps[1].params["camera"]["azimuth_deg"], 7);
  const Recipe one = with("outputs.1.camera.azimuth_deg=7");  // that use alone
  EXPECT_EQ(one.steps[1].params["camera"]["azimuth_deg"], 100);
  EXPECT_EQ(one.steps[2].params["camera"]["azimuth_deg"], 7);
  EXPECT_THROW(with("variables.hihg=3"), InvalidArgument);
}

TEST(Variables, SizeCountsTheWidthThatAVariableGives) {
  const Recipe recipe = read(R"({"seamount": 1, "variables": {"w": 5000}, "domain": {"width_m": "$w", "height_m": 2500},
    "steps": []})",
                             {.sets = {}, .seed = {}, .size = 50});
  EXPECT_EQ(recipe.domain.width, 50);
  EXPECT_EQ(recipe.domain.height, 25);
}

TEST(Variables, DocumentsKeepThemAndEditThem) {
  Document document{text(R"({"high": 900})", R"({"peak_m": "$high"})"), "r.json", ""};
  EXPECT_EQ(document.json()["steps"][0]["params"]["peak_m"], "$high");
  const std::string before = document.text();
  document.apply(SetValue{"/variables/high", 500});
  EXPECT_EQ(document.recipe().steps[0].params["peak_m"], 500);
  EXPECT_THROW(document.apply(SetValue{"/variables/high", std::nullopt}), RecipeError);
  EXPECT_THROW(document.apply(SetValue{"/variables/high", "much"}), RecipeError);
  document.undo();
  EXPECT_EQ(document.text(), before);
  Document fresh;
  fresh.apply(SetValue{"/variables/age", 0.3});
  EXPECT_EQ(fresh.json()["variables"]["age"], 0.3);
}

std::string set_error(const std::string& set) {
  try {
    read(R"({"seamount": 1, "variables": {"age": 1}, "domain": {"cell_m": 100}, "steps": [
      {"id": "isle", "op": "island.build", "params": {"peak_m": 900}}, {"id": "blown", "op": "island.wind", "in": "isle"}],
      "outputs": [{"from": "blown.terrain", "path": "a.png", "as": "perspective"},
                  {"from": "blown.terrain", "path": "b.png", "as": "perspective", "width_px": 99}]})",
         {.sets = {set}, .seed = {}, .size = {}});
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

TEST(SetValue, SaysWhichParametersWereProbablyMeant) {
  EXPECT_EQ(set_error("peak_m=3"),
            "--set: there is no 'peak_m' in a recipe like this, did you mean 'steps.isle.params.peak_m'?");
  EXPECT_EQ(set_error("steps.isle.peak_m=3"),
            "--set: there is no 'steps.isle.peak_m' in a recipe like this, did you mean 'steps.isle.params.peak_m'?");
  EXPECT_EQ(set_error("age=3"), "--set: there is no 'age' in a recipe like this, did you mean 'variables.age'?");
  EXPECT_THAT(set_error("sun=3"), HasSubstr("did you mean 'outputs.0.sun' or 'outputs.1.sun'?"));
  EXPECT_EQ(set_error("steps.isel.params.peak_m=3"),
            "--set: 'steps.isel.params.peak_m' leads nowhere: the recipe has no 'isel' there, did you mean "
            "'steps.isle.params.peak_m'?");
}

TEST(SetValue, SaysThePatternAndTheStepsWhereNothingIsLikeIt) {
  EXPECT_EQ(set_error("nonsense"),
            "--set: expected PATH=VALUE, found 'nonsense'; paths are steps.ID.params.NAME (ID: isle, blown), "
            "outputs.INDEX.NAME, variables.NAME, domain.NAME, seed");
}

}  // namespace
}  // namespace seamount::recipe
