// Recipes as they were written before parameters had groups and rates their time: each reads as what it is now.
#include <gmock/gmock.h>

#include "seamount/recipe/recipe.h"

namespace seamount::recipe {
namespace {

Recipe read(const std::string& op, const std::string& params) {
  return parse_recipe(R"({"seamount": 1, "steps": [{"id": "t", "op": "terrain.noise"},
    {"id": "s", "op": ")" +
                          op + R"(", "in": {"terrain": "t.terrain"}, "params": )" + params + "}]}",
                      "r.json", "");
}

void expect_same(const std::string& op, const std::string& before, const std::string& now, size_t notes) {
  const Recipe old = read(op, before), present = read(op, now);
  EXPECT_EQ(old.steps[1].params, present.steps[1].params);
  EXPECT_EQ(old.notes.size(), notes);
  EXPECT_TRUE(present.notes.empty());
}

TEST(FormerDocuments, ReefsHadFlatParameters) {
  expect_same("reef.grow",
              R"({"line": [[-2500, -500], [0, 600], [2500, 0]], "random_kernels": 3, "habitat_low_m": -45,
                  "habitat_high_m": -5, "launch": "ring", "stickiness": 0.3, "current": 0.2, "particles": 400,
                  "combine": "sum", "lift": "proportional", "w0": 0.5, "k2": 10, "blur_m": 40, "normalise": true,
                  "cays": 1})",
              R"({"starts": {"line": [[-2500, -500], [0, 600], [2500, 0]], "random": 3},
                  "bounds": {"low_m": -45, "high_m": -5}, "walk": {"launch": "ring", "stickiness": 0.3, "current": 0.2},
                  "particles": 400, "kernel": {"combine": "sum", "k2": 10},
                  "heights": {"mode": "proportional", "w0": 0.5}, "finish": {"blur_m": 40, "normalise": true},
                  "sand": {"cays": 1}})",
              14);
}

TEST(FormerDocuments, ErosionHadRatesWithoutTheirTime) {
  expect_same("erosion.run",
              R"({"years": 150000, "erodibility": 7e-5, "rain_m": 0.3, "evaporation_per_km": 0.1, "sediment_ease": 1.5,
                  "rock_ease": 1.2, "bedrock_angle_deg": 36, "deposition": 2, "fan_m": 1000, "sea_m": -500,
                  "uplift_mm": 1, "creep_m2": 0.01})",
              R"({"years": 150000, "erodibility": 7e-5, "runoff_mm_yr": 300, "sea_m": -500, "uplift_mm_yr": 1,
                  "rivers": {"evaporation_per_km": 0.1, "sediment_ease": 1.5, "debris_ease": 1.2, "deposition": 2,
                             "fan_m": 1000},
                  "slopes": {"bedrock_angle_deg": 36, "creep_m2_yr": 0.01}})",
              9);
}

TEST(FormerDocuments, EveryFormerNameLeadsToAParameter) {
  for (const auto& op : standard_registry().operators()) {
    for (const FormerParam& former : op->former) {
      EXPECT_NE(find_param(op->params, former.info.name), nullptr) << op->name << " " << former.name;
      EXPECT_EQ(find_param(op->params, former.name), nullptr) << op->name << " " << former.name;
    }
  }
}

TEST(FormerDocuments, PortsAreReadByTheirFormerNames) {
  const Recipe recipe = parse_recipe(R"({"seamount": 1, "steps": [{"id": "t", "op": "terrain.noise"},
      {"id": "a", "op": "erosion.run", "in": {"terrain": "t.terrain"}},
      {"id": "b", "op": "erosion.run", "in": {"terrain": "a.terrain", "rock": "a.rock"}}],
      "outputs": [{"from": "b.rock", "path": "rock.npy"}]})",
                                     "r.json", "");
  EXPECT_EQ(recipe.steps[2].in.at("debris").port, "debris");
  EXPECT_EQ(recipe.outputs[0].from.port, "debris");
  std::vector<std::string> notes;
  for (const Diagnostic& note : recipe.notes) notes.push_back(diagnostic_line("r.json", note));
  EXPECT_THAT(notes, ::testing::ElementsAre("r.json:3:71: /steps/2/in/rock: 'rock' is now called 'debris'",
                                            "r.json:3:71: /steps/2/in/rock: 'a.rock' is now called 'a.debris'",
                                            "r.json:4:20: /outputs/0/from: 'b.rock' is now called 'b.debris'"));
}

}  // namespace
}  // namespace seamount::recipe
