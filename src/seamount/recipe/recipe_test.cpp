// Wrong recipes with their exact diagnostics, and changes made from the command line.
#include "seamount/recipe/recipe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace seamount::recipe {
namespace {

using ::testing::ElementsAre;

/// Diagnostics as "pointer: message".
std::vector<std::string> defects(const std::string& text) {
  std::vector<std::string> all;
  try {
    parse_recipe(text, "r.json", "");
  } catch (const RecipeError& error) {
    for (const Diagnostic& d : error.diagnostics()) all.push_back(d.pointer + ": " + d.message);
  }
  return all;
}

std::string with_steps(const std::string& steps) {
  return R"({"seamount": 1, "domain": {"cell_m": 100}, "steps": [)" + steps + "]}";
}

const std::string kIsle = R"({"id": "isle", "op": "island.build"})";

TEST(Recipe, ReadsAGoodOne) {
  const Recipe recipe =
      parse_recipe(R"({"seamount": 1, "domain": {"width_m": 6000, "height_m": 4000, "cell_m": 10}, "seed": 7,
    "steps": [{"id": "reef", "op": "island.coral", "in": {"terrain": "isle.terrain", "labels": "isle.labels"}, "params": {"subsidence": 0.3}},
              {"id": "isle", "op": "island.build"}],
    "outputs": [{"from": "reef.terrain", "path": "a/height.tif"}, {"from": "reef.terrain", "path": "u.r16", "as": "unreal", "size": 505}]})",
                   "r.json", "");
  EXPECT_EQ(recipe.domain.width, 600);
  EXPECT_EQ(recipe.domain.height, 400);
  ASSERT_EQ(recipe.steps.size(), 3U);     // and the samples of the second output
  EXPECT_EQ(recipe.steps[0].id, "isle");  // in an order that runs
  EXPECT_EQ(recipe.steps[1].params["subsidence"], 0.3);
  EXPECT_EQ(recipe.steps[1].params["section"]["crest_m"], -2);  // defaults filled in
  EXPECT_EQ(recipe.outputs[0].format->name, "raster");
  EXPECT_EQ(recipe.outputs[1].params["size"], 505);
}

TEST(Recipe, NamesUnknownThingsAndTheNearestKnownOne) {
  EXPECT_THAT(defects(with_steps(R"({"id": "a", "op": "island.biuld"})")),
              ElementsAre("/steps/0/op: unknown operator 'island.biuld', did you mean 'island.build'?"));
  EXPECT_THAT(defects(with_steps(R"({"id": "a", "op": "island.build", "params": {"peek_m": 3}})")),
              ElementsAre("/steps/0/params/peek_m: unknown parameter 'peek_m', did you mean 'peak_m'?"));
  EXPECT_THAT(defects(with_steps(R"({"id": "a", "op": "island.build", "parms": {}})")),
              ElementsAre("/steps/0/parms: unknown member 'parms', did you mean 'params'?"));
  EXPECT_THAT(defects(R"({"seamount": 1, "steps": [], "output": []})"),
              ElementsAre("/output: unknown member 'output', did you mean 'outputs'?"));
  EXPECT_THAT(defects(with_steps(R"({"id": "a", "op": "island.build", "params": {"interpolation": "linaer"}})")),
              ElementsAre("/steps/0/params/interpolation: unknown choice 'linaer', did you mean 'linear'?"));
}

TEST(Recipe, SaysTheRangeOfValuesOutsideIt) {
  EXPECT_THAT(
      defects(with_steps(
          kIsle +
          R"(, {"id": "reef", "op": "island.coral", "in": {"terrain": "isle.terrain", "labels": "isle.labels"}, "params": {"subsidence": 1.5}})")),
      ElementsAre("/steps/1/params/subsidence: subsidence: 1.5 is outside [0, 1]"));
  EXPECT_THAT(
      defects(with_steps(R"({"id": "a", "op": "island.build", "params": {"resistance": 1, "profile": [[0, 99999]]}})")),
      ElementsAre("/steps/0/params/profile: profile: 99999 is outside [-12000, 12000]",
                  "/steps/0/params/resistance: unknown parameter 'resistance'" + suggestion("resistance", [] {
                    std::vector<std::string> names;
                    for (const ParamInfo& info : standard_registry().find_operator("island.build")->params)
                      names.push_back(info.name);
                    return names;
                  }())));
}

TEST(Recipe, NamesWrongTypes) {
  EXPECT_THAT(defects(with_steps(R"({"id": "a", "op": "island.build", "params": {"relief": "much"}})")),
              ElementsAre("/steps/0/params/relief: expected a number, found the text \"much\""));
  EXPECT_THAT(defects(with_steps(R"({"id": "a", "op": "island.build", "params": {"profile": [[0, 1], [0, 2]]}})")),
              ElementsAre("/steps/0/params/profile/1: x = 0 does not follow x = 0: knots ascend"));
  EXPECT_THAT(defects(with_steps(R"({"id": "a", "op": "terrain.noise", "params": {"octaves": 2.5}})")),
              ElementsAre("/steps/0/params/octaves: expected a whole number, found 2.5"));
  EXPECT_THAT(defects("[]"), ElementsAre(": expected a recipe: an object, found the list []"));
}

TEST(Recipe, FindsCyclesDanglingInputsAndDuplicateIds) {
  EXPECT_THAT(
      defects(with_steps(
          R"({"id": "a", "op": "island.wind", "in": {"terrain": "b.terrain"}}, {"id": "b", "op": "island.wind", "in": {"terrain": "a.terrain"}})")),
      ElementsAre("/steps/1/in: the steps need each other in a circle: b -> a -> b"));
  EXPECT_THAT(defects(with_steps(R"({"id": "a", "op": "island.wind", "in": {"terrain": "a.terrain"}})")),
              ElementsAre("/steps/0/in: the steps need each other in a circle: a -> a"));
  EXPECT_THAT(defects(with_steps(kIsle + R"(, {"id": "w", "op": "island.wind", "in": {"terrain": "isel.terrain"}})")),
              ElementsAre("/steps/1/in/terrain: there is no step 'isel', did you mean 'isle'?"));
  EXPECT_THAT(
      defects(with_steps(kIsle + R"(, {"id": "w", "op": "island.wind", "in": {"terrain": "isle.terain"}})")),
      ElementsAre("/steps/1/in/terrain: 'isle.terain' is no output of island.build, did you mean 'isle.terrain'?"));
  EXPECT_THAT(defects(with_steps(kIsle + R"(, {"id": "w", "op": "island.wind", "in": {"terrain": "isle.labels"}})")),
              ElementsAre("/steps/1/in/terrain: 'isle.labels' is labels; terrain is needed here"));
  EXPECT_THAT(defects(with_steps(R"({"id": "w", "op": "island.wind"})")),
              ElementsAre("/steps/0: island.wind needs the input 'terrain': heights in metres"));
  EXPECT_THAT(defects(with_steps(kIsle + ", " + kIsle)),
              ElementsAre("/steps/1/id: 'isle' is already the id of step 0"));
}

TEST(Recipe, ChecksTheDomain) {
  EXPECT_THAT(
      defects(R"({"seamount": 1, "domain": {"width_m": 1e6, "height_m": 1e6, "cell_m": 1}, "steps": []})"),
      ElementsAre(
          "/domain: cell_m: 1 m gives 1000000 x 1000000 cells; at most 65536 a side and 2^30 in all are possible"));
  EXPECT_THAT(defects(R"({"seamount": 1, "domain": {"width_m": -5}, "steps": []})"),
              ElementsAre("/domain/width_m: width_m: -5 is outside [0.001, 100000000]"));
  EXPECT_THAT(defects(R"({"seamount": 2, "steps": []})"),
              ElementsAre("/seamount: version 2 is unknown; this program reads version 1"));
  EXPECT_THAT(defects(R"({"steps": []})"), ElementsAre(": \"seamount\": 1 is missing; is this a recipe?"));
}

TEST(Recipe, ChecksOutputs) {
  const auto output = [](const std::string& members) {
    return defects(R"({"seamount": 1, "steps": [)" + kIsle + R"(], "outputs": [{)" + members + "}]}");
  };
  EXPECT_THAT(output(R"("from": "isle.terrain", "path": "../x.tif")"),
              ElementsAre("/outputs/0/path: '../x.tif' leaves the output folder"));
  EXPECT_THAT(output(R"("from": "isle.terrain", "path": "x.tif", "as": "unrael")"),
              ElementsAre("/outputs/0/as: 'unrael' is no way to write terrain, did you mean 'unreal'?"));
  EXPECT_THAT(output(R"("from": "isle.terrain", "path": "x.tif", "as": "perspective")"),
              ElementsAre("/outputs/0/path: 'perspective' is written to .png, .jpg, .jpeg, not to 'x.tif'"));
  EXPECT_THAT(output(R"("from": "isle.terrain", "path": "x.tif", "sise": 3)").front(),
              ::testing::HasSubstr("/outputs/0/sise: unknown parameter 'sise'"));
  EXPECT_THAT(output(R"("from": "isle.terrain", "path": "x.r16", "as": "unreal", "size": 506)").front(),
              ::testing::HasSubstr("/outputs/0/size: 506 is not a size that unreal reads; allowed are 127, 253"));
  EXPECT_THAT(output(R"("from": "isle.terrain", "path": "x\u0000.tif")").front(),
              ::testing::HasSubstr("/outputs/0/path: expected a text without control characters"));
  EXPECT_THAT(output(R"("from": "isle.terrain", "path": "")"), ElementsAre("/outputs/0/path: is empty"));
  EXPECT_THAT(output(R"("from": "isle.terrain")"), ElementsAre("/outputs/0: \"path\" is missing"));
}

TEST(Recipe, ReportsEverythingAtOnceWithItsLine) {
  try {
    parse_recipe(
        "{\"seamount\": 1,\n \"steps\": [\n  {\"id\": \"a\", \"op\": \"nope\"},\n  {\"id\": \"b\", \"op\": "
        "\"island.build\", \"params\": {\"relief\": 9}}\n]}",
        "r.json", "");
    FAIL();
  } catch (const RecipeError& error) {
    ASSERT_EQ(error.diagnostics().size(), 2U);
    EXPECT_EQ(error.diagnostics()[0].line, 3);
    EXPECT_EQ(error.diagnostics()[1].line, 4);
    EXPECT_THAT(error.what(), ::testing::HasSubstr("r.json:4:48: /steps/1/params/relief: relief: 9 is outside [0, 2]"));
  }
}

TEST(Recipe, ChangesFromTheCommandLine) {
  const std::string text =
      R"({"seamount": 1, "domain": {"width_m": 8000, "height_m": 4000, "cell_m": 10}, "seed": 1, "steps": [{"id": "isle", "op": "island.build"}]})";
  const Recipe recipe = parse_recipe(
      text, "r.json", "",
      {.sets = {"steps.isle.params.relief=0.25", "steps.0.params.feature=kauai"}, .seed = 99, .size = 200});
  EXPECT_EQ(recipe.steps[0].params["relief"], 0.25);
  EXPECT_EQ(recipe.steps[0].params["feature"], "kauai");
  EXPECT_EQ(recipe.seed.value, 99U);
  EXPECT_EQ(recipe.domain.width, 200);
  EXPECT_EQ(recipe.domain.height, 100);
  EXPECT_THROW(parse_recipe(text, "r.json", "", {.sets = {"steps.isel.params.relief=1"}, .seed = {}, .size = {}}),
               InvalidArgument);
  EXPECT_THROW(parse_recipe(text, "r.json", "", {.sets = {"relief"}, .seed = {}, .size = {}}), InvalidArgument);
}

TEST(Schema, KnowsEveryOperatorAndParameter) {
  const Json schema = recipe_schema();
  const Json& steps = schema["properties"]["steps"]["items"]["oneOf"];
  ASSERT_EQ(steps.size(), standard_registry().operators().size());
  for (size_t i = 0; i < steps.size(); ++i) {
    const Operator& op = *standard_registry().operators()[i];
    EXPECT_EQ(steps[i]["properties"]["op"]["const"], op.name);
    for (const ParamInfo& info : op.params)
      EXPECT_TRUE(steps[i]["properties"]["params"]["properties"][info.name].contains("description"))
          << op.name << " " << info.name;
  }
}

TEST(Recipe, NamesWhatIsWrongInAListOfTools) {
  const auto edits = [](const std::string& list) {
    return defects(R"({"seamount": 1, "domain": {"cell_m": 100}, "steps": [{"id": "e", "op": "contour.edit",
      "in": {"contours": {"file": "c.gpkg"}}, "params": {"edits": )" +
                   list + "}}]}");
  };
  EXPECT_THAT(edits(R"([{"tool": "warp", "stroke": [[0, 0], [100, 0]], "radius_m": 300}, {"tool": "smooth"}])"),
              ElementsAre());
  EXPECT_THAT(edits(R"([{"tool": "wrap"}])"),
              ElementsAre("/steps/0/params/edits/0/tool: unknown tool 'wrap', did you mean 'warp'?"));
  EXPECT_THAT(edits(R"([{"tool": "smooth"}, {"tool": "warp", "radius": 4}])"),
              ElementsAre("/steps/0/params/edits/1/radius: unknown parameter 'radius', did you mean 'radius_m'?"));
  EXPECT_THAT(edits(R"([{"tool": "warp", "strength": 2}])"),
              ElementsAre("/steps/0/params/edits/0/strength: strength: 2 is outside [0, 1]"));
  EXPECT_THAT(edits(R"([{"tool": "delete", "select": {"low": 4, "innr": 5}}])"),
              ElementsAre("/steps/0/params/edits/0/select/innr: unknown parameter 'innr', did you mean 'inner'?",
                          "/steps/0/params/edits/0/select/low: unknown parameter 'low', did you mean 'low_m'?"));
  EXPECT_THAT(
      edits(R"([{"radius_m": 4}, 3])"),
      ElementsAre("/steps/0/params/edits/0: \"tool\" is missing: one of warp, slope, smooth, fractalize, delete, "
                  "copy, cut, paste, fill",
                  "/steps/0/params/edits/1: expected a tool {\"tool\": name, ...}, found 3"));
  EXPECT_THAT(edits(R"({"tool": "warp"})"),
              ElementsAre("/steps/0/params/edits: expected a list, found the object {\"tool\":\"warp\"}"));
}

TEST(Recipe, ToolsAreCompletedAndNameTheirFiles) {
  const Recipe recipe =
      parse_recipe(R"({"seamount": 1, "domain": {"cell_m": 100}, "steps": [{"id": "e", "op": "contour.edit",
      "in": {"contours": {"file": "c.gpkg"}},
      "params": {"edits": [{"tool": "paste", "file": "hill.geojson"}, {"tool": "paste"}, {"tool": "smooth"}]}}]})",
                   "r.json", "");
  const Json& params = recipe.steps[0].params;
  EXPECT_EQ(params["edits"][2]["tool"], "smooth");
  EXPECT_EQ(params["edits"][2]["rounds"], 2);
  EXPECT_EQ(params["edits"][2]["select"]["inner"], false);
  std::vector<std::string> files;
  for_each_file(recipe.steps[0].op->params, params, [&](const std::string& name) { files.push_back(name); });
  EXPECT_THAT(files, ElementsAre("hill.geojson"));
}

}  // namespace
}  // namespace seamount::recipe
