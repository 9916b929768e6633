// Registration of the hydrology family.
#include "seamount/recipe/registry.h"

namespace seamount::recipe {

void add_hydrology_operators(Registry& registry) { static_cast<void>(registry); }

}  // namespace seamount::recipe
