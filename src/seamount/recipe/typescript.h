// The types of recipes for programs that edit them in TypeScript, from the field tables: the studio's page.
#pragma once

#include <string>

#include "seamount/recipe/registry.h"

namespace seamount::recipe {

/// studio/src/generated/params.ts: what each operator's parameters look like, by its name; all members may be left out.
std::string typescript_types(const Registry& registry = standard_registry());

}  // namespace seamount::recipe
