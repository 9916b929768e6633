// Registration of the reef family.
#include "seamount/recipe/registry.h"

namespace seamount::recipe {

void add_reef_operators(Registry& registry) { static_cast<void>(registry); }

}  // namespace seamount::recipe
