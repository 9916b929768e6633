// Recipe text: whatever it is, it is read or refused with at least one defect, and reading what was read again gives
// the same. The first byte chooses a change as the command line makes it.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "seamount/recipe/recipe.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace seamount;
  if (size < 1) return 0;
  const std::string text(reinterpret_cast<const char*>(data + 1), size - 1);
  recipe::RecipeChanges changes;
  if (data[0] % 4 == 1) changes.size = 1 + data[0];
  if (data[0] % 4 == 2) changes.sets = {"steps.isle.params.relief=0.5", "domain.cell_m=5"};
  if (data[0] % 4 == 3) changes.sets = {text.substr(0, 40)};
  try {
    const recipe::Recipe recipe = recipe::parse_recipe(text, "fuzz.json", "", changes);
    for (const recipe::Step& step : recipe.steps) {
      recipe::Diagnostics diagnostics;
      if (step.op->complete(step.params, {"", diagnostics}) != step.params || !diagnostics.empty()) std::abort();
    }
  } catch (const recipe::RecipeError& error) {
    if (error.diagnostics().empty() || std::string(error.what()).empty()) std::abort();
  } catch (const Error&) {
  }
  return 0;
}
