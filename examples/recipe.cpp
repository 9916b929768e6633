// Runs a recipe from its text, without files: the values of a step, then its outputs.
#include <cstdio>

#include "seamount/recipe/executor.h"

int main() {
  using namespace seamount;
  const char* text = R"({
    "seamount": 1, "seed": 4,
    "domain": {"width_m": 12000, "height_m": 12000, "cell_m": 60},
    "steps": [{"id": "isle", "op": "island.build", "params": {"peak_m": 900}}],
    "outputs": [{"from": "isle.terrain", "path": "isle.tif"}, {"from": "isle.terrain", "path": "isle_map.png"}]
  })";
  try {
    const recipe::Recipe isle = recipe::parse_recipe(text, "isle.json", "", {.sets = {"steps.isle.params.relief=1.5"}});
    const recipe::ExecuteReport report = recipe::execute(isle, {.out_folder = "isle", .cache_folder = ""}, {});
    for (const recipe::OutputReport& output : report.outputs) std::printf("%s\n", output.path.c_str());
    return report.outputs.size() == 2 ? 0 : 1;
  } catch (const recipe::RecipeError& error) {
    std::printf("%s\n", error.what());  // every defect, a line each
    return 1;
  }
}
