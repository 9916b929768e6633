// The mechanism of presets on a struct of its own, and what holds for the presets of every operator and format.
#include "seamount/recipe/preset_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <set>

#include "seamount/base/presets.h"
#include "seamount/recipe/param_json.h"
#include "seamount/recipe/recipe.h"
#include "seamount/recipe/reference.h"
#include "seamount/recipe/registry.h"
#include "seamount/recipe/set_value.h"

namespace seamount::recipe {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Slopes {
  double angle_deg = 40;
  double creep = 0.1;
  static constexpr auto fields() {
    return std::tuple(field(&Slopes::angle_deg, "angle_deg", "deg", between(1, 89), "steepest"),
                      field(&Slopes::creep, "creep", "", between(0, 1), "creep"));
  }
};

struct Params {
  double years = 300;
  double rain = 1;
  Slopes slopes;
  static constexpr auto fields() {
    return std::tuple(field(&Params::years, "years", "yr", between(0, 1e6), "how long"),
                      field(&Params::rain, "rain", "", between(0, 10), "rain"),
                      field(&Params::slopes, "slopes", "slopes"));
  }
  static constexpr auto presets() {
    return std::array{preset<Params>("young", "gullies", [](Params& p) { p.years = 20; }),
                      preset<Params>("desert", "cliffs", [](Params& p) {
                        p.rain = 0;
                        p.slopes.angle_deg = 60;
                      })};
  }
};

struct Read {
  Params params;
  std::vector<std::string> defects;
};

Read read(const std::string& text) {
  Diagnostics diagnostics;
  Read out;
  out.params = read_params<Params>(Json::parse(text), {"/p", diagnostics});
  for (const Diagnostic& item : diagnostics.items()) out.defects.push_back(item.pointer + ": " + item.message);
  return out;
}

TEST(Presets, GiveValuesToWhatIsNotStated) {
  const Read desert = read(R"({"preset": "desert"})");
  EXPECT_THAT(desert.defects, IsEmpty());
  EXPECT_EQ(desert.params.years, 300);
  EXPECT_EQ(desert.params.rain, 0);
  EXPECT_EQ(desert.params.slopes.angle_deg, 60);
  EXPECT_EQ(desert.params.slopes.creep, 0.1);
}

TEST(Presets, StatedValuesWinInGroupsToo) {
  const Read read_in = read(R"({"rain": 2, "slopes": {"creep": 0.5}, "preset": "desert"})");
  EXPECT_THAT(read_in.defects, IsEmpty());
  EXPECT_EQ(read_in.params.rain, 2);
  EXPECT_EQ(read_in.params.slopes.creep, 0.5);
  EXPECT_EQ(read_in.params.slopes.angle_deg, 60) << "a group that is stated in part keeps the preset's other values";
}

TEST(Presets, UnknownOnesAreDefectsWithASuggestion) {
  EXPECT_THAT(read(R"({"preset": "dessert"})").defects,
              ElementsAre("/p/preset: unknown preset 'dessert', did you mean 'desert'?"));
  EXPECT_THAT(read(R"({"preset": "lunar"})").defects,
              ElementsAre("/p/preset: unknown preset 'lunar', known are: young, desert"));
  EXPECT_THAT(read(R"({"preset": 3})").defects, ElementsAre("/p/preset: expected the name of a preset, found 3"));
}

TEST(Presets, AreGoneFromCompleteParameters) {
  const Json complete = write_params(read(R"({"preset": "desert"})").params);
  EXPECT_FALSE(complete.contains("preset"));
  EXPECT_EQ(complete, write_params(read(R"({"rain": 0, "slopes": {"angle_deg": 60}})").params))
      << "what is computed and cached follows from the values alone";
}

TEST(Presets, SayWhatTheySet) {
  const auto infos = describe_params<Params>();
  ASSERT_EQ(infos[0].kind, "preset");
  EXPECT_THAT(infos[0].choices, ElementsAre("young", "desert"));
  EXPECT_EQ(sets_text(infos[0].presets[1].sets), "rain 0, slopes.angle_deg 60");
  EXPECT_EQ(param_schema(infos[0])["enum"], Json::array({"young", "desert"}));
}

/// Calls visit(preset row, parameters beside it) for the presets of parameters and their groups.
void for_each_preset_row(const std::vector<ParamInfo>& infos,
                         const std::function<void(const ParamInfo&, const std::vector<ParamInfo>&)>& visit) {
  for (const ParamInfo& info : infos) {
    if (info.kind == "preset") visit(info, infos);
    for (const ToolInfo& tool : info.tools) for_each_preset_row(tool.params, visit);
  }
}

TEST(Presets, OfEachOperatorAreInRangeDifferAndAreDescribed) {
  int seen = 0;
  for (const auto& op : standard_registry().operators()) {
    const auto& infos = op->params;
    if (infos.empty() || infos[0].kind != "preset") continue;
    std::set<std::string> made;
    for (const PresetInfo& row : infos[0].presets) {
      Diagnostics diagnostics;
      const Json by_word = op->complete({{"preset", row.name}}, {"", diagnostics});
      const Json by_values = op->complete(row.sets, {"", diagnostics});
      EXPECT_TRUE(diagnostics.empty()) << op->name << " " << row.name;
      EXPECT_EQ(by_word, by_values) << op->name << " " << row.name;
      EXPECT_TRUE(made.insert(by_word.dump()).second) << op->name << " " << row.name << " is another one again";
      EXPECT_THAT(describe_operator(*op), HasSubstr(row.about));
      ++seen;
    }
  }
  EXPECT_GE(seen, 7);
}

TEST(Presets, AreNoParametersAndEachHasALine) {
  for (const auto& op : standard_registry().operators()) {
    for_each_preset_row(op->params, [&](const ParamInfo& row, const std::vector<ParamInfo>& beside) {
      EXPECT_EQ(std::count_if(beside.begin(), beside.end(), [](const auto& info) { return info.name == "preset"; }), 1)
          << op->name;
      for (const PresetInfo& preset : row.presets) {
        EXPECT_FALSE(preset.about.empty()) << op->name << " " << preset.name;
        EXPECT_FALSE(preset.sets.empty()) << op->name << " " << preset.name;
      }
    });
  }
}

TEST(Presets, AloneMeanThoseOfTheOnlyStepThatHasSome) {
  Json root = Json::parse(R"({"seamount": 1, "steps": [{"id": "isle", "op": "island.build"},
                                                       {"id": "edge", "op": "terrain.smooth", "in": "isle"}]})");
  set_value(root, "preset=old", standard_registry());
  EXPECT_EQ(root["steps"][0]["params"]["preset"], "old");
  root["steps"].push_back(Json::parse(R"({"id": "worn", "op": "erosion.run", "in": "edge"})"));
  try {
    set_value(root, "preset=old", standard_registry());
    FAIL() << "it is not said which";
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean 'steps.isle.params.preset' or 'steps.worn.params.preset'?"));
  }
}

}  // namespace
}  // namespace seamount::recipe
