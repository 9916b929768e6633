// Catalogues of environmental objects as JSON: {"seamount_catalogue": 1, "name", "about", "materials": [...],
// "classes": [...], "transformations": [...]}, each member by the field tables of model/catalogue.h.
#pragma once

#include <string>

#include "seamount/model/catalogue.h"
#include "seamount/recipe/param_json.h"

namespace seamount::recipe {

/// Reads a catalogue and checks all of it: what is no catalogue, unknown members, values out of range, names,
/// expressions (with their column), rules that contradict one another. Throws RecipeError with every defect and its
/// line, Cancelled.
Catalogue parse_catalogue(const std::string& text, const std::string& file, const RunContext& run = {});

/// The same of a file; mesh files that it names are relative to it, and are there. Throws IoError, RecipeError,
/// Cancelled.
Catalogue read_catalogue(const std::string& path, const RunContext& run = {});

/// Is this JSON that says that it is a catalogue, sound or not?
bool is_catalogue_text(const std::string& text);

/// All of a catalogue, defaults included; what parse_catalogue reads as the same.
Json catalogue_json(const Catalogue& catalogue);

/// JSON Schema (2020-12) of catalogues.
Json catalogue_schema();

}  // namespace seamount::recipe
