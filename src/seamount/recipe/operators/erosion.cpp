// Registration of the erosion family.
#include "seamount/recipe/registry.h"

namespace seamount::recipe {

void add_erosion_operators(Registry& registry) { static_cast<void>(registry); }

}  // namespace seamount::recipe
