// A step's id alone: what it connects, what it refuses, and that edits know it.
#include "seamount/recipe/shorthand.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "seamount/recipe/document.h"

namespace seamount::recipe {
namespace {

using ::testing::HasSubstr;

std::string recipe_text(const std::string& reef_in, const std::string& outputs = "") {
  return R"({"seamount": 1, "domain": {"cell_m": 100}, "steps": [
    {"id": "isle", "op": "island.build"},
    {"id": "noise", "op": "terrain.noise"},
    {"id": "reef", "op": "island.coral", "in": )" +
         reef_in + R"(}], "outputs": [)" + outputs + "]}";
}

Recipe read(const std::string& reef_in, const std::string& outputs = "") {
  return parse_recipe(recipe_text(reef_in, outputs), "r.json", "");
}

std::string defect(const std::string& reef_in, const std::string& outputs = "") {
  try {
    read(reef_in, outputs);
  } catch (const RecipeError& error) {
    const Diagnostic& first = error.diagnostics().front();
    return first.pointer + ": " + first.message;
  }
  return "";
}

const Step& step(const Recipe& recipe, const std::string& id) {
  for (const Step& one : recipe.steps)
    if (one.id == id) return one;
  throw std::out_of_range(id);
}

const char* const kWritten = R"({"terrain": "isle.terrain", "labels": "isle.labels", "coordinate": "isle.coordinate"})";

TEST(Shorthand, AStepConnectsEveryInputThatItHasAnOutputFor) {
  const auto explicit_in = step(read(kWritten), "reef").in;
  EXPECT_EQ(step(read(R"("isle")"), "reef").in, explicit_in);
  EXPECT_EQ(step(read(R"({"terrain": "isle", "labels": "isle", "coordinate": "isle"})"), "reef").in, explicit_in);
}

/// For every pair of operators: what is connected has the same name and kind, and nothing that has is left out.
TEST(Shorthand, HoldsForAllOperators) {
  size_t connected = 0;
  for (const auto& consumer : standard_registry().operators()) {
    for (const auto& producer : standard_registry().operators()) {
      const auto pairs = meant_connections(*consumer, *producer);
      size_t expected = 0;
      for (const Port& in : consumer->in)
        for (const Port& out : producer->out) expected += in.name == out.name && in.kind == out.kind;
      EXPECT_EQ(pairs.size(), expected) << consumer->name << " " << producer->name;
      for (const auto& [in, out] : pairs) EXPECT_TRUE(in->name == out->name && in->kind == out->kind);
      connected += pairs.size();
    }
  }
  EXPECT_GT(connected, 100U);
}

TEST(Shorthand, AnInputTakesTheOnlyOutputOfItsKind) {
  const Recipe recipe = parse_recipe(R"({"seamount": 1, "domain": {"cell_m": 100}, "steps": [
    {"id": "isle", "op": "island.build"}, {"id": "noise", "op": "terrain.noise"},
    {"id": "both", "op": "terrain.blend", "in": {"terrain": "isle", "with": "noise"}}]})",
                                     "r.json", "");
  EXPECT_EQ(step(recipe, "both").in.at("terrain").port, "terrain");
  EXPECT_EQ(step(recipe, "both").in.at("with").port, "terrain");
}

TEST(Shorthand, SaysWhatThereIsWhereNothingFits) {
  EXPECT_EQ(defect(R"("isel")"), "/steps/2/in: there is no step 'isel', did you mean 'isle'?");
  EXPECT_EQ(defect(R"("noise")"), "/steps/2/in: island.coral needs the input 'labels': its regions");
  EXPECT_EQ(defect(R"({"terrain": "isle", "labels": "noise"})"),
            "/steps/2/in/labels: which output of 'noise'? labels is needed; it has noise.terrain (terrain)");
  const std::string none = R"({"seamount": 1, "steps": [{"id": "noise", "op": "terrain.noise"},
    {"id": "grown", "op": "contour.reconstruct", "in": "noise"}]})";
  try {
    parse_recipe(none, "r.json", "");
    FAIL();
  } catch (const RecipeError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("no output of 'noise' has the name and kind of an input of contour.reconstruct"));
    EXPECT_THAT(error.what(), HasSubstr("it has noise.terrain (terrain); the inputs are contours"));
  }
}

TEST(Shorthand, WhatIsNotSaidIsTheStepBefore) {
  const std::string text = R"({"seamount": 1, "domain": {"cell_m": 100}, "steps": [
    {"id": "isle", "op": "island.build"}, {"id": "reef", "op": "island.coral"},
    {"id": "noise", "op": "terrain.noise"}, {"id": "worn", "op": "erosion.run", "bypass": true},
    {"id": "soft", "op": "terrain.smooth"}], "outputs": [{"path": "h.tif"}, {"from": "reef", "path": "r.glb"}]})";
  const Recipe recipe = parse_recipe(text, "r.json", "");
  EXPECT_EQ(step(recipe, "reef").in.at("terrain"), (Source{"isle", "terrain", ""}));
  EXPECT_EQ(step(recipe, "reef").in.at("labels"), (Source{"isle", "labels", ""}));
  EXPECT_TRUE(step(recipe, "noise").in.empty()) << "needs no input, so it begins anew";
  EXPECT_EQ(step(recipe, "soft").in.at("terrain"), (Source{"noise", "terrain", ""})) << "past what is bypassed";
  EXPECT_EQ(recipe.outputs[0].from, (Source{"soft", "terrain", ""}));
  EXPECT_TRUE(recipe.notes.empty());
  const Recipe lines = parse_recipe(R"({"seamount": 1, "domain": {"cell_m": 100}, "steps": [
    {"id": "noise", "op": "terrain.noise"}, {"id": "lines", "op": "contour.extract"},
    {"id": "land", "op": "contour.reconstruct"}], "outputs": [{"path": "h.tif"}]})",
                                    "r.json", "");
  EXPECT_EQ(step(lines, "land").in, (std::map<std::string, Source>{{"contours", {"lines", "contours", ""}}}));
  const auto said = [](const std::string& steps) {
    try {
      parse_recipe(R"({"seamount": 1, "steps": [)" + steps + "]}", "r.json", "");
    } catch (const RecipeError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(said(R"({"id": "soft", "op": "terrain.smooth"})"), HasSubstr("terrain.smooth needs the input 'terrain'"));
  EXPECT_THAT(said(R"({"id": "noise", "op": "terrain.noise"}, {"id": "reef", "op": "island.coral"})"),
              HasSubstr("island.coral needs the input 'labels'"));
  EXPECT_THAT(said(R"({"id": "noise", "op": "terrain.noise"}, {"id": "soft", "op": "terrain.smooth", "in": {}})"),
              HasSubstr("terrain.smooth needs the input 'terrain'"));
}

TEST(Shorthand, AnOutputComesFromTheOneThatItsFormatWrites) {
  EXPECT_EQ(read(kWritten, R"({"from": "noise", "path": "h.tif"})").outputs[0].from.port, "terrain");
  const Recipe unreal = read(kWritten, R"({"from": "isle", "path": "h.r16", "as": "unreal"})");
  EXPECT_EQ(unreal.steps.back().in.begin()->second, (Source{"isle", "terrain", ""}));
  const Recipe first = read(kWritten, R"({"from": "isle", "path": "h.tif"})");
  EXPECT_EQ(first.outputs[0].from, (Source{"isle", "terrain", ""}));
  ASSERT_EQ(first.notes.size(), 1u);
  EXPECT_THAT(first.notes[0].message, HasSubstr("'isle' means isle.terrain, its first; it has isle.terrain (terrain), "
                                                "isle.labels (labels), isle.coordinate (field)"));
  const Recipe map = read(kWritten, R"({"from": "isle.terrain", "labels": "reef", "path": "m.png", "as": "map"})");
  EXPECT_EQ(map.steps.back().in.at("labels"), (Source{"reef", "labels", ""}));
}

Document document() {
  return {
      recipe_text(R"("isle")", R"({"from": "noise", "path": "h.tif"}, {"from": "isle", "path": "m.png", "as": "map"})"),
      "r.json", ""};
}

TEST(Shorthand, EditsRenameIt) {
  Document edited = document();
  edited.apply(RenameStep{"isle", "kauai"});
  EXPECT_EQ(edited.json()["steps"][2]["in"], "kauai");
  EXPECT_EQ(edited.json()["outputs"][1]["from"], "kauai");
  EXPECT_EQ(edited.json()["outputs"][0]["from"], "noise");
}

TEST(Shorthand, AnInputOfItsOwnWritesTheOthersOut) {
  Document edited = document();
  const std::string before = edited.text();
  edited.apply(connect("reef", "terrain", "noise.terrain"));
  OrderedJson expected = OrderedJson::parse(kWritten);
  expected["terrain"] = "noise.terrain";
  EXPECT_EQ(Json(edited.json()["steps"][2]["in"]), Json(expected));
  edited.undo();
  EXPECT_EQ(edited.text(), before);
  edited.redo();
  EXPECT_EQ(Json(edited.json()["steps"][2]["in"]), Json(expected));
}

TEST(Shorthand, RemovingAStepReconnectsWhatNamedItAlone) {
  Document edited{R"({"seamount": 1, "domain": {"cell_m": 100}, "steps": [{"id": "isle", "op": "island.build"},
    {"id": "worn", "op": "island.wind", "in": "isle"}, {"id": "reef", "op": "island.coral", "in": "worn"}],
    "outputs": [{"from": "worn", "path": "m.png", "as": "map"}]})",
                  "r.json", ""};
  const std::string before = edited.text();
  edited.apply(RemoveStep{"worn"});
  EXPECT_EQ(Json(edited.json()["steps"][1]["in"]), Json::parse(kWritten));
  EXPECT_EQ(edited.json()["outputs"][0]["from"], "isle.terrain");
  edited.undo();
  EXPECT_EQ(edited.text(), before);
}

}  // namespace
}  // namespace seamount::recipe
