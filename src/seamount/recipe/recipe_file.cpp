// Recipes from text and files; recipe.cpp reads the document that the text is.
#include <array>
#include <filesystem>
#include <fstream>

#include "seamount/recipe/domain.h"
#include "seamount/recipe/recipe.h"

namespace seamount::recipe {

Recipe parse_recipe(const std::string& text, const std::string& file, const std::string& folder,
                    const RecipeChanges& changes, const Registry& registry) {
  JsonDocument document = parse_json(text, file);
  apply_changes(document.root, changes);
  Diagnostics diagnostics;
  Recipe recipe = read_document(document.root, file, folder, diagnostics, diagnostics, registry);
  if (!diagnostics.empty()) {
    place_diagnostics(diagnostics, document);
    throw RecipeError(file, diagnostics.items());
  }
  return recipe;
}

std::string read_recipe_text(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw IoError(path, "is a folder, not a recipe");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw IoError(path, std::filesystem::exists(path, ignored) ? "cannot be read" : "no such file");
  std::string text;
  while (file && text.size() <= kLargestText) {
    std::array<char, 1 << 16> block{};
    file.read(block.data(), block.size());
    text.append(block.data(), static_cast<size_t>(file.gcount()));
  }
  return text;
}

Recipe read_recipe(const std::string& path, const RecipeChanges& changes, const Registry& registry) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return parse_recipe(read_recipe_text(path), path, folder, changes, registry);
}

}  // namespace seamount::recipe
