// Edits of a document: what they change, what they refuse, and that undo and redo are exact.
#include "seamount/recipe/document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "seamount/recipe/json_text.h"

namespace seamount::recipe {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string kReef = R"({
  "about": "kept as it is",
  "seamount": 1,
  "domain": { "width_m": 6400, "height_m": 6400, "cell_m": 100 },
  "seed": 3,
  "steps": [
    { "op": "island.build", "id": "isle", "params": { "peak_m": 900 } },
    {
      "id": "worn",
      "op": "island.wind",
      "in": { "terrain": "isle.terrain", "labels": "isle.labels", "coordinate": "isle.coordinate" },
      "params": { "strokes": [{ "points": [[-2000, 500], [0, 500.5], [2000, 0]], "width_m": 300, "strength_m": 100 }] }
    },
    { "id": "reef", "op": "island.coral", "in": { "terrain": "worn.terrain", "labels": "worn.labels" } }
  ],
  "outputs": [
    { "from": "reef.terrain", "path": "reef.asc" },
    { "from": "worn.terrain", "labels": "reef.labels", "path": "worn.png", "as": "map" }
  ]
}
)";

Document reef() { return {kReef, "reef.json", ""}; }

/// The message of what an edit is refused with; empty if it is taken.
std::string refusal(Document& document, const Edit& edit) {
  const std::string before = document.text();
  try {
    document.apply(edit);
  } catch (const Error& error) {
    EXPECT_EQ(document.text(), before);
    return error.what();
  }
  return "";
}

std::string at(const Document& document, const std::string& pointer) {
  return document.json()[OrderedJson::json_pointer(pointer)].dump();
}

TEST(Document, KeepsOrderAndRemarksAndWritesReadableText) {
  EXPECT_EQ(reef().text(), kReef);
  Document changed = reef();
  changed.apply(set_parameter("isle", "peak_m", 1200));
  EXPECT_THAT(changed.text(), HasSubstr(R"({ "op": "island.build", "id": "isle", "params": { "peak_m": 1200 } },)"));
  EXPECT_EQ(Document(changed.text(), "again.json", "").text(), changed.text());
}

TEST(Document, TextKeepsListsOfPointsOnALineAndBreaksLongOnes) {
  OrderedJson points = OrderedJson::array();
  for (int i = 0; i < 40; ++i) points.push_back({i, 0.1 * i});
  const std::string text = readable_text({{"points", points}, {"empty", OrderedJson::object()}, {"flag", true}});
  EXPECT_THAT(text, HasSubstr("\n    [7, 0.7000000000000001],\n"));
  EXPECT_THAT(text, HasSubstr("\"empty\": {},\n"));
  EXPECT_EQ(OrderedJson::parse(text).at("points"), points);
}

TEST(Document, SetsAndTakesOutParameters) {
  Document document = reef();
  document.apply(set_parameter("reef", "subsidence", 0.4));  // makes "params"
  EXPECT_EQ(at(document, "/steps/2/params"), R"({"subsidence":0.4})");
  document.apply(set_parameter("worn", "strokes/0/width_m", 50));
  EXPECT_EQ(at(document, "/steps/1/params/strokes/0/width_m"), "50");
  document.apply(set_parameter("reef", "subsidence", std::nullopt));
  EXPECT_EQ(at(document, "/steps/2/params"), "{}");
  document.apply(set_seed(8));
  document.apply(set_domain("cell_m", 50));
  EXPECT_EQ(document.recipe().domain.width, 128);
  EXPECT_EQ(document.recipe(32).domain.width, 32);
  EXPECT_EQ(document.recipe().seed.value, 8U);
}

TEST(Document, RefusesWhatWouldBeNoRecipeAndChangesNothing) {
  Document document = reef();
  EXPECT_EQ(refusal(document, set_parameter("reef", "subsidence", 2)),
            "reef.json: /steps/2/params/subsidence: subsidence: 2 is outside [0, 1]");
  EXPECT_EQ(refusal(document, set_parameter("reef", "subsidance", 0.2)),
            "reef.json: /steps/2/params/subsidance: unknown parameter 'subsidance', did you mean 'subsidence'?");
  EXPECT_EQ(refusal(document, set_parameter("rief", "subsidence", 0.2)),
            "/steps/rief/params/subsidence: there is no 'rief' in the list");
  EXPECT_THAT(refusal(document, connect("isle", "labels", "reef.labels")), HasSubstr("in a circle"));
  EXPECT_THAT(refusal(document, connect("reef", "terrain", "isle.labels")), HasSubstr("is labels; terrain is needed"));
  EXPECT_THAT(refusal(document, RenameStep{"isle", "reef"}), HasSubstr("is already the id of step"));
  EXPECT_THAT(refusal(document, RenameStep{"isle", "an island"}), HasSubstr("is no id"));
  EXPECT_THAT(refusal(document, add_step({{"id", "x"}, {"op", "no.such"}})), HasSubstr("unknown operator"));
  EXPECT_THAT(refusal(document, bypass("isle", true)), HasSubstr("has no input to pass on as 'terrain'"));
  EXPECT_THAT(refusal(document, SetValue{"/steps", std::nullopt}), HasSubstr("\"steps\" is missing"));
  EXPECT_EQ(refusal(document, InsertItem{"/outputs", 7, {}}), "/outputs: index 7 is outside [0, 2]");
  EXPECT_EQ(refusal(document, RemoveItem{"/seed"}), "/seed: is no item of a list");
  EXPECT_EQ(refusal(document, MoveItem{"/steps/isle", 3}), "/steps/isle: index 3 is outside [0, 2]");
  EXPECT_EQ(refusal(document, SetValue{"seed", 3}), "seed: is no JSON pointer: it starts with '/'");
  OrderedJson deep;
  for (int i = 0; i < 100; ++i) deep = OrderedJson::array({deep});
  EXPECT_THAT(refusal(document, SetValue{"/about", deep}), HasSubstr("nested 100 levels deep"));
  EXPECT_THROW(document.apply({set_seed(1), set_parameter("reef", "subsidence", 2)}), RecipeError);
  EXPECT_EQ(document.text(), kReef);
  EXPECT_EQ(document.revision(), 0U);
  EXPECT_FALSE(document.can_undo());
}

TEST(Document, LivesOnWithOpenInputs) {
  Document document = reef();
  document.apply(connect("worn", "terrain", ""));
  ASSERT_EQ(document.missing().size(), 1U);
  EXPECT_EQ(document.missing()[0].pointer, "/steps/1/in");
  EXPECT_GT(document.missing()[0].line, 5);
  const Recipe recipe = document.recipe();
  EXPECT_EQ(recipe.steps[0].incomplete, "");
  EXPECT_THAT(recipe.steps[1].incomplete, HasSubstr("island.wind needs the input 'terrain'"));
  EXPECT_THROW(parse_recipe(document.text(), "r.json", ""), RecipeError);
  document.apply(connect_file("worn", "terrain", "dem.tif"));
  EXPECT_TRUE(document.missing().empty());
  Document fresh;
  fresh.apply(add_step({{"id", "reef"}, {"op", "island.coral"}}));
  EXPECT_EQ(fresh.missing().size(), 2U);
  fresh.apply({add_step({{"id", "isle"}, {"op", "island.build"}}, 0), connect("reef", "terrain", "isle.terrain"),
               connect("reef", "labels", "isle.labels"),
               InsertItem{"/outputs", {}, {{"from", "reef.terrain"}, {"path", "a.tif"}}}});
  EXPECT_TRUE(fresh.missing().empty());
  EXPECT_EQ(parse_recipe(fresh.text(), "r.json", "").outputs.size(), 1U);
}

TEST(Document, RenamingAStepKeepsItsSeedAndFollowsItsName) {
  Document document = reef();
  const Seed seed = document.recipe().steps[0].seed;
  document.apply(RenameStep{"isle", "kauai"});
  EXPECT_EQ(at(document, "/steps/1/in"),
            R"({"terrain":"kauai.terrain","labels":"kauai.labels","coordinate":"kauai.coordinate"})");
  EXPECT_EQ(document.recipe().steps[0].seed, seed);
  document.apply(RenameStep{"reef", "atoll"});
  EXPECT_EQ(at(document, "/outputs/0/from"), R"("atoll.terrain")");
  EXPECT_EQ(at(document, "/outputs/1/labels"), R"("atoll.labels")");
  document.undo();
  document.undo();
  EXPECT_EQ(document.text(), kReef);
}

TEST(Document, RemovingAStepConnectsItsNeighbours) {
  Document document = reef();
  document.apply(RemoveStep{"worn"});
  EXPECT_EQ(at(document, "/steps/1/in"), R"({"terrain":"isle.terrain","labels":"isle.labels"})");
  EXPECT_EQ(at(document, "/outputs/1/from"), R"("isle.terrain")");
  document.apply(RemoveStep{"isle"});  // nothing passes through it: the reef's inputs are open, and its output is gone
  EXPECT_EQ(at(document, "/steps/0/in"), "{}");
  EXPECT_EQ(document.json()["outputs"].size(), 1U);
  EXPECT_EQ(document.missing().size(), 2U);
  document.apply(RemoveStep{"reef"});
  EXPECT_EQ(at(document, "/outputs"), "[]");
  while (document.undo()) {
  }
  EXPECT_EQ(document.text(), kReef);
}

TEST(Document, AGestureIsUndoneAsOne) {
  Document document = reef();
  for (int i = 1; i <= 10; ++i) document.apply(set_parameter("reef", "subsidence", 0.05 * i), "drag 1");
  document.apply(set_parameter("isle", "peak_m", 700), "drag 2");
  document.apply(set_parameter("isle", "peak_m", 800));
  document.apply(set_parameter("isle", "peak_m", 900.5));
  EXPECT_EQ(document.done(), 4U);
  EXPECT_EQ(document.history()[0].changes.size(), 2U);  // the first makes "params", the other nine are one
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(document.undo());
  EXPECT_EQ(at(document, "/steps/0/params/peak_m"), "900");
  EXPECT_EQ(at(document, "/steps/2/params/subsidence"), "0.5");
  EXPECT_TRUE(document.undo());
  EXPECT_EQ(document.text(), kReef);
  EXPECT_TRUE(document.redo());
  EXPECT_EQ(at(document, "/steps/2/params/subsidence"), "0.5");
  document.apply(set_parameter("reef", "subsidence", 0.1), "drag 1");  // after an undo: a gesture of its own
  EXPECT_FALSE(document.can_redo());
  EXPECT_EQ(document.done(), 2U);
}

/// A small repeatable source of choices.
class Chooser {
 public:
  explicit Chooser(uint64_t seed) : rng_(Seed{seed}) {}
  int below(int count) { return rng_.integer(0, count - 1); }
  std::string step(const Document& document) {
    const OrderedJson& steps = document.json()["steps"];
    return steps.empty() ? "none" : steps[below(static_cast<int>(steps.size()))]["id"].get<std::string>();
  }

 private:
  Rng rng_;
};

Edit random_edit(const Document& document, Chooser& choose) {
  const std::string step = choose.step(document), other = choose.step(document);
  const std::string fresh = "s" + std::to_string(choose.below(1000));
  switch (choose.below(13)) {
    case 0:
      return set_parameter(step, "subsidence", 0.01 * choose.below(100));
    case 1:
      return set_parameter(step, "peak_m", 500 + choose.below(500));
    case 2:
      return set_parameter(step, choose.below(2) == 0 ? "peak_m" : "strokes", std::nullopt);
    case 3:
      return add_step({{"id", fresh}, {"op", "island.coral"}}, choose.below(3));
    case 4:
      return RemoveStep{step};
    case 5:
      return RenameStep{step, fresh};
    case 6:
      return connect(step, "terrain", other + ".terrain");
    case 7:
      return connect(step, choose.below(2) == 0 ? "labels" : "terrain", "");
    case 8:
      return bypass(step, choose.below(2) == 0);
    case 9:
      return MoveItem{"/steps/" + step, static_cast<size_t>(choose.below(4))};
    case 10:
      return InsertItem{"/outputs", choose.below(2), {{"from", step + ".terrain"}, {"path", fresh + ".tif"}}};
    case 11:
      return RemoveItem{"/outputs/" + std::to_string(choose.below(3))};
    default:
      return choose.below(2) == 0 ? set_seed(choose.below(9)) : set_domain("cell_m", 50 + choose.below(50));
  }
}

TEST(Document, UndoAndRedoAreExactForAnyEdits) {
  int taken = 0;
  for (uint64_t seed = 0; seed < 60; ++seed) {
    Document document = reef();
    Chooser choose(seed);
    std::vector<std::string> texts = {document.text()};
    for (int i = 0; i < 25; ++i) {
      const uint64_t before = document.revision();
      if (!refusal(document, random_edit(document, choose)).empty() || document.revision() == before) continue;
      texts.push_back(document.text());
      EXPECT_EQ(Document(document.text(), "again.json", "").text(), document.text());
      ++taken;
    }
    ASSERT_EQ(document.done(), texts.size() - 1);
    for (size_t i = texts.size() - 1; i-- > 0;) {
      ASSERT_TRUE(document.undo());
      ASSERT_EQ(document.text(), texts[i]) << seed;
    }
    EXPECT_FALSE(document.undo());
    for (size_t i = 1; i < texts.size(); ++i) {
      ASSERT_TRUE(document.redo());
      ASSERT_EQ(document.text(), texts[i]) << seed;
    }
    EXPECT_FALSE(document.redo());
  }
  EXPECT_GT(taken, 400);
}

}  // namespace
}  // namespace seamount::recipe
