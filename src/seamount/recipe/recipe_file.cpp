// Recipes from text and files; recipe.cpp reads the document that the text is.
#include <filesystem>

#include "seamount/io/input_file.h"
#include "seamount/recipe/domain.h"
#include "seamount/recipe/recipe.h"

namespace seamount::recipe {

Recipe parse_recipe(const std::string& text, const std::string& file, const std::string& folder,
                    const RecipeChanges& changes, const Registry& registry, const RunContext& run) {
  JsonDocument document = parse_json(text, file, run);
  apply_changes(document.root, changes, registry);
  Diagnostics diagnostics;
  Recipe recipe = read_document(document.root, file, folder, diagnostics, diagnostics, registry,
                                changes.tiled ? kMostCellsInTiles : kMostCells);
  if (diagnostics.empty() && diagnostics.notes().empty()) return recipe;
  place_diagnostics(diagnostics, document);
  if (!diagnostics.empty()) throw RecipeError(file, diagnostics.items());
  recipe.notes = std::move(diagnostics.notes());
  return recipe;
}

std::string read_recipe_text(const std::string& path, const RunContext& run) {
  return io::read_text(path, kLargestText + 1, run);
}

Recipe read_recipe(const std::string& path, const RecipeChanges& changes, const Registry& registry,
                   const RunContext& run) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return parse_recipe(read_recipe_text(path, run), path, folder, changes, registry, run);
}

}  // namespace seamount::recipe
