// An island with a reef under erosion: a test across families, so it stands with recipes.
#include <gtest/gtest.h>

#include <algorithm>

#include "seamount/recipe/executor.h"
#include "seamount/recipe/kinds.h"
#include "seamount/recipe/recipe.h"

namespace seamount::recipe {
namespace {

int64_t cells_of(const LabelMap& labels, Region region) {
  return std::count(labels.cells().begin(), labels.cells().end(), region);
}

TEST(WornReef, KeepsItsLagoonAndItsLabelsFollowTheCoast) {
  for (const std::string seed : {"1", "2", "3"}) {
    const Recipe recipe =
        parse_recipe(R"({"seamount": 1, "seed": )" + seed +
                         R"(, "domain": {"width_m": 16000, "height_m": 16000, "cell_m": 100}, "steps": [
        {"id": "isle", "op": "island.build"},
        {"id": "reef", "op": "island.coral", "in": {"terrain": "isle.terrain", "labels": "isle.labels"},
         "params": {"subsidence": 0.3}},
        {"id": "worn", "op": "erosion.run", "in": {"terrain": "reef.terrain", "labels": "reef.labels"}}]})",
                     "worn", "");
    const std::vector<Value> made =
        evaluate(recipe, {{"reef", "labels", ""}, {"worn", "labels", ""}, {"worn", "terrain", ""}}, {"", ""}, {});
    const LabelMap &before = made[0].get<kinds::Labels>(), &after = made[1].get<kinds::Labels>();
    const HeightField& terrain = made[2].get<kinds::Terrain>();
    EXPECT_GT(cells_of(after, Region::lagoon), 0.9 * cells_of(before, Region::lagoon)) << seed;
    EXPECT_GT(cells_of(after, Region::beach), 0) << seed;
    for (size_t i = 0; i < after.size(); ++i) {
      const bool land = after.data()[i] == Region::mountain || after.data()[i] == Region::beach;
      if (terrain.data()[i] > 0) {
        ASSERT_TRUE(land) << seed << " " << i;
      }
    }
  }
}

TEST(WornReef, WithoutLabelsLandIsMountainAndSeaIsAbyss) {
  const Recipe recipe =
      parse_recipe(R"({"seamount": 1, "domain": {"width_m": 8000, "height_m": 8000, "cell_m": 100}, "steps": [
        {"id": "isle", "op": "island.build"},
        {"id": "worn", "op": "erosion.run", "in": {"terrain": "isle.terrain"}, "params": {"years": 1000}}]})",
                   "worn", "");
  const std::vector<Value> made = evaluate(recipe, {{"worn", "labels", ""}}, {"", ""}, {});
  const LabelMap& labels = made[0].get<kinds::Labels>();
  EXPECT_GT(cells_of(labels, Region::mountain), 0);
  EXPECT_EQ(cells_of(labels, Region::mountain) + cells_of(labels, Region::abyss), static_cast<int64_t>(labels.size()));
}

}  // namespace
}  // namespace seamount::recipe
