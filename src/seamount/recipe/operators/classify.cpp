// Registration of the classify family.
#include "seamount/recipe/registry.h"

namespace seamount::recipe {

void add_classify_operators(Registry& registry) { static_cast<void>(registry); }

}  // namespace seamount::recipe
