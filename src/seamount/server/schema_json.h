// Everything that the page generates its panels from: operators, formats and kinds with the rows of their field tables.
#pragma once

#include "seamount/recipe/registry.h"

namespace seamount::server {

/// The answer to GET /api/schema (`Schema` in studio/src/api/types.ts).
recipe::Json schema_json(const recipe::Registry& registry);

}  // namespace seamount::server
