#include "seamount/recipe/former_names.h"

#include <gmock/gmock.h>

#include <array>

#include "seamount/recipe/param_json.h"

namespace seamount::recipe {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

struct Walk {
  double stickiness = 1.0;
  static constexpr auto fields() {
    return std::tuple(field(&Walk::stickiness, "stickiness", "", between(0, 1), "chance to settle"));
  }
};

struct Params {
  double creep_m2_yr = 0.005;
  double runoff_mm_yr = 1000.0;
  Walk walk;
  static constexpr std::array kFormerNames = {FormerName{"creep_m2", "creep_m2_yr"},
                                              FormerName{"rain_m", "runoff_mm_yr", 1000.0},
                                              FormerName{"stickiness", "walk.stickiness"}};
  static constexpr auto fields() {
    return std::tuple(field(&Params::creep_m2_yr, "creep_m2_yr", "m2/yr", between(0, 10), "diffusivity"),
                      field(&Params::runoff_mm_yr, "runoff_mm_yr", "mm/yr", between(1, 20000), "runoff"),
                      field(&Params::walk, "walk", "walks"));
  }
};

struct Read {
  Params params;
  std::vector<std::string> defects, notes;
};

Read read(const std::string& text) {
  Diagnostics diagnostics;
  Read out;
  out.params = read_params<Params>(Json::parse(text), {"/p", diagnostics});
  for (const Diagnostic& item : diagnostics.items()) out.defects.push_back(item.pointer + ": " + item.message);
  for (const Diagnostic& item : diagnostics.notes()) out.notes.push_back(item.pointer + ": " + item.message);
  return out;
}

TEST(FormerNames, AreReadWithANote) {
  const Read got = read(R"({"creep_m2": 0.25})");
  EXPECT_THAT(got.defects, IsEmpty());
  EXPECT_THAT(got.notes, ElementsAre("/p/creep_m2: 'creep_m2' is now called 'creep_m2_yr'"));
  EXPECT_EQ(got.params.creep_m2_yr, 0.25);
  EXPECT_THAT(read(R"({"creep_m2_yr": 0.25})").notes, IsEmpty());
}

TEST(FormerNames, ChangeTheUnitOfNumbers) {
  const Read got = read(R"({"rain_m": 0.3})");
  EXPECT_EQ(got.params.runoff_mm_yr, 300.0);
  EXPECT_THAT(got.notes,
              ElementsAre("/p/rain_m: 'rain_m' is now called 'runoff_mm_yr', in another unit: 0.3 is read as 300"));
}

TEST(FormerNames, LeadIntoGroups) {
  EXPECT_EQ(read(R"({"stickiness": 0.5})").params.walk.stickiness, 0.5);
  EXPECT_EQ(read(R"({"stickiness": 0.5, "walk": {}})").params.walk.stickiness, 0.5);
  EXPECT_THAT(read(R"({"stickiness": 0.5, "walk": 3})").defects,
              ElementsAre("/p/walk: expected an object of parameters, found 3"));
}

TEST(FormerNames, AreRefusedBesideThePresentOnes) {
  EXPECT_THAT(read(R"({"creep_m2": 1, "creep_m2_yr": 1})").defects,
              ElementsAre("/p/creep_m2: 'creep_m2' is now called 'creep_m2_yr', which is given too: leave one out"));
  EXPECT_THAT(read(R"({"stickiness": 1, "walk": {"stickiness": 1}})").defects,
              ElementsAre("/p/stickiness: 'stickiness' is now called 'walk.stickiness', which is given too: leave one "
                          "out"));
}

TEST(FormerNames, DefectsStandWhereTheyWereWritten) {
  EXPECT_THAT(read(R"({"stickiness": 2})").defects, ElementsAre("/p/stickiness: stickiness: 2 is outside [0, 1]"));
  EXPECT_THAT(read(R"({"creep_m2": "much"})").defects,
              ElementsAre("/p/creep_m2: expected a number, found the text \"much\""));
  EXPECT_THAT(read(R"({"creep_m2": 1, "walk": {"stickiness": 2}})").defects,
              ElementsAre("/p/walk/stickiness: stickiness: 2 is outside [0, 1]"));
}

TEST(FormerNames, KnowTheirParameterOnTheCommandLine) {
  const std::vector<FormerParam> former = describe_former_names<Params>();
  ASSERT_EQ(former.size(), 3U);
  EXPECT_EQ(former[2].name, "stickiness");
  EXPECT_EQ(former[2].info.name, "walk.stickiness");
  EXPECT_EQ(former[2].info.kind, "number");
}

}  // namespace
}  // namespace seamount::recipe
