// classify.terrain against the labels that islands are made with: a test across families, so it stands with recipes.
#include <gtest/gtest.h>

#include <array>

#include "seamount/recipe/executor.h"
#include "seamount/recipe/kinds.h"
#include "seamount/recipe/recipe.h"

namespace seamount::recipe {
namespace {

/// Share of cells whose label is found again, over all cells and over those that are not abyss.
struct Agreement {
  double all = 0.0, island = 0.0;
};

Agreement agreement(const std::string& seed, const std::string& subsidence) {
  const Recipe recipe = parse_recipe(R"({"seamount": 1, "seed": )" + seed +
                                         R"(, "domain": {"width_m": 20480, "height_m": 20480, "cell_m": 40}, "steps": [
        {"id": "isle", "op": "island.build"},
        {"id": "reef", "op": "island.coral", "in": {"terrain": "isle.terrain", "labels": "isle.labels",
         "coordinate": "isle.coordinate"}, "params": {"subsidence": )" +
                                         subsidence + R"(}},
        {"id": "found", "op": "classify.terrain", "in": {"terrain": "reef.terrain"}}]})",
                                     "agreement", "");
  const std::vector<Source> wanted = {{"reef", "labels", ""}, {"found", "labels", ""}};
  const std::vector<Value> made = evaluate(recipe, wanted, {"", ""}, {});
  const LabelMap &truth = made[0].get<kinds::Labels>(), &found = made[1].get<kinds::Labels>();
  int64_t same = 0, island = 0, same_island = 0;
  for (size_t i = 0; i < truth.size(); ++i) {
    const bool agrees = truth.cells()[i] == found.cells()[i];
    same += agrees ? 1 : 0;
    if (truth.cells()[i] == Region::abyss && found.cells()[i] == Region::abyss) continue;
    ++island;
    same_island += agrees ? 1 : 0;
  }
  return {static_cast<double>(same) / static_cast<double>(truth.size()),
          static_cast<double>(same_island) / static_cast<double>(island)};
}

TEST(ClassifyTerrain, FindsTheLabelsOfIslandsAgain) {
  for (const auto& [seed, subsidence] : {std::pair{"1", "0.05"}, {"2", "0.25"}, {"3", "0.4"}, {"4", "0.75"}}) {
    const Agreement share = agreement(seed, subsidence);
    // Measured: 0.967, 0.991, 0.992, 0.983 of all and 0.892, 0.967, 0.976, 0.946 of the island.
    EXPECT_GT(share.all, 0.95) << "subsidence " << subsidence;
    EXPECT_GT(share.island, 0.87) << "subsidence " << subsidence;
  }
}

}  // namespace
}  // namespace seamount::recipe
