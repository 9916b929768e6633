// Registration of the contour family.
#include "seamount/recipe/registry.h"

namespace seamount::recipe {

void add_contour_operators(Registry& registry) { static_cast<void>(registry); }

}  // namespace seamount::recipe
