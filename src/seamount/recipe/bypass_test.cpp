// What bypassed steps pass on.
#include "seamount/recipe/bypass.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "seamount/recipe/executor.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

using ::testing::ElementsAre;

Recipe parse(const std::string& steps, const std::string& outputs = "") {
  return parse_recipe(R"({"seamount": 1, "domain": {"width_m": 6400, "height_m": 6400, "cell_m": 200}, "steps": [)" +
                          steps + R"(], "outputs": [)" + outputs + "]}",
                      "r.json", "");
}

std::string defect(const std::string& steps, const std::string& outputs = "") {
  try {
    parse(steps, outputs);
  } catch (const RecipeError& error) {
    return error.diagnostics()[0].pointer + ": " + error.diagnostics()[0].message;
  }
  return "";
}

const std::string kIsle = R"({"id": "isle", "op": "island.build"}, )";
const std::string kWorn =
    R"({"id": "worn", "op": "island.wind", "bypass": true, "in": {"terrain": "isle.terrain", "labels": "isle.labels"}}, )";
const std::string kReef =
    R"({"id": "reef", "op": "island.coral", "in": {"terrain": "worn.terrain", "labels": "worn.labels"}})";

TEST(Bypass, StandsInByNameThenByKind) {
  const Operator& wind = *standard_registry().find_operator("island.wind");
  EXPECT_EQ(stand_in(wind, *wind.find_out("labels"))->name, "labels");
  const Operator& noise = *standard_registry().find_operator("terrain.noise");
  EXPECT_EQ(stand_in(noise, noise.out[0]), nullptr);
  const Operator& layers = *standard_registry().find_operator("terrain.layers");
  for (const Port& out : layers.out) EXPECT_EQ(stand_in(layers, out), nullptr);
  const Operator& mask = *standard_registry().find_operator("terrain.mask");  // out: mask; in: values, mask
  EXPECT_EQ(stand_in(mask, mask.out[0])->name, "mask");
}

TEST(Bypass, RunsAsIfTheStepWereNotThere) {
  const Recipe with = parse(kIsle + kWorn + kReef, R"({"from": "worn.terrain", "path": "a.png", "as": "map"})");
  ASSERT_EQ(with.steps.size(), 3U);  // the last one makes the map
  for (const size_t step : {1U, 2U}) {
    EXPECT_EQ(with.steps[step].in.at("terrain"), (Source{"isle", "terrain", ""}));
    EXPECT_EQ(with.steps[step].in.at("labels"), (Source{"isle", "labels", ""}));
  }
  const Recipe without = parse(
      kIsle + R"({"id": "reef", "op": "island.coral", "in": {"terrain": "isle.terrain", "labels": "isle.labels"}})");
  const std::vector<Source> wanted = {{"reef", "terrain", ""}};
  EXPECT_EQ(evaluate(with, wanted, {"", ""}, {})[0].get<kinds::Terrain>(),
            evaluate(without, wanted, {"", ""}, {})[0].get<kinds::Terrain>());
}

TEST(Bypass, FollowsSeveralInARow) {
  const std::string again =
      R"({"id": "again", "op": "island.wind", "bypass": true, "in": {"terrain": "worn.terrain", "labels": "worn.labels"}}, )";
  const std::string reef =
      R"({"id": "reef", "op": "island.coral", "in": {"terrain": "again.terrain", "labels": "again.labels"}})";
  const Recipe recipe = parse(kIsle + kWorn + again + reef);
  EXPECT_EQ(recipe.steps[1].in.at("labels"), (Source{"isle", "labels", ""}));
}

TEST(Bypass, OptionalInputsAreLeftOpenAndRequiredOnesAreMissed) {
  const std::string open =
      R"({"id": "worn", "op": "island.wind", "bypass": true, "in": {"terrain": "isle.terrain", "labels": "isle.labels"}}, )"
      R"({"id": "reef", "op": "island.coral", "in": {"terrain": "worn.terrain", "labels": "worn.labels", "coordinate": "worn.coordinate"}})";
  EXPECT_EQ(parse(kIsle + open).steps[1].in.count("coordinate"), 0U);
  const std::string bare = R"({"id": "worn", "op": "island.wind", "bypass": true, "in": {}})";
  EXPECT_EQ(defect(kIsle + bare + ", " + kReef),
            "/steps/2/in/labels: island.coral needs the input 'labels': 'worn.labels' is bypassed, and its input "
            "'labels' is open");
  EXPECT_EQ(defect(kIsle + bare, R"({"from": "worn.terrain", "path": "a.tif"})"),
            "/outputs/0/from: 'worn.terrain' is bypassed, and its input 'terrain' is open");
}

TEST(Bypass, WhatCannotBePassedOnIsAnError) {
  EXPECT_EQ(defect(R"({"id": "isle", "op": "island.build", "bypass": true}, )"
                   R"({"id": "worn", "op": "island.wind", "in": {"terrain": "isle.terrain"}})"),
            "/steps/1/in/terrain: 'isle.terrain' is bypassed, and island.build has no input to pass on as 'terrain' "
            "(terrain)");
  EXPECT_EQ(defect(R"({"id": "w", "op": "island.wind", "bypass": true, "in": {"terrain": {"file": "a.tif"}}})",
                   R"({"from": "w.terrain", "path": "a.tif"})"),
            "/outputs/0/from: an output comes from a step; 'w.terrain' is bypassed and passes on the file 'a.tif'");
  EXPECT_EQ(defect(R"({"id": "isle", "op": "island.build", "bypass": 1})"),
            "/steps/0/bypass: expected true or false, found 1");
}

}  // namespace
}  // namespace seamount::recipe
