// Scenes of objects: whatever the text, it is read or refused with at least one defect, and what was read is written
// and read back as the same.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "seamount/recipe/scene_json.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace seamount;
  try {
    const Scene read = recipe::parse_scene({reinterpret_cast<const char*>(data), size}, "fuzz.json");
    if (recipe::parse_scene(recipe::scene_json(read).dump(), "again.json") != read) std::abort();
  } catch (const recipe::RecipeError& error) {
    if (error.diagnostics().empty() || std::string(error.what()).empty()) std::abort();
  } catch (const Error&) {
  }
  return 0;
}
