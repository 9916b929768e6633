// Registration of the sketch family.
#include "seamount/recipe/registry.h"

namespace seamount::recipe {

void add_sketch_operators(Registry& registry) { static_cast<void>(registry); }

}  // namespace seamount::recipe
