// A recipe: a domain, a seed, steps that form a graph, outputs (docs/guide/recipes.md). Reading one checks everything
// that can be checked without running it and reports all defects at once, each with its place.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "seamount/recipe/outputs.h"
#include "seamount/recipe/registry.h"

namespace seamount::recipe {

/// Where an input comes from: a port of an earlier step, or a file.
struct Source {
  std::string step;
  std::string port;
  std::string file;  ///< non-empty: a file, and step and port are empty
  bool from_file() const { return !file.empty(); }
};

struct Step {
  std::string id;
  const Operator* op = nullptr;
  std::map<std::string, Source> in;  ///< by input port
  Json params;                       ///< complete: every parameter, defaults filled in
  Seed seed;
};

struct Output {
  Source from;
  std::optional<Source> labels;  ///< the labels that go with it, if there are any
  std::string path;              ///< relative to the output folder
  const OutputFormat* format = nullptr;
  Json params;  ///< complete
};

struct Recipe {
  std::string file;    ///< for messages
  std::string folder;  ///< relative file names are relative to it
  GridFrame domain;
  Seed seed;
  std::vector<Step> steps;  ///< every step after those that it needs
  std::vector<Output> outputs;
};

/// Changes to a document before it is read: what the command line gives.
struct RecipeChanges {
  std::vector<std::string>
      sets;  ///< "steps.isle.params.subsidence=0.5", "domain.cell_m=5"; values are JSON or plain text
  std::optional<uint64_t> seed;
  std::optional<int> size;  ///< cells along the longer side of the domain
};

/// Reads recipe text. Throws RecipeError with every defect found. `folder`: where its relative file names start.
Recipe parse_recipe(const std::string& text, const std::string& file, const std::string& folder,
                    const RecipeChanges& changes = {});

/// Reads a recipe file; its relative file names are relative to it. Throws IoError or RecipeError.
Recipe read_recipe(const std::string& path, const RecipeChanges& changes = {});

/// JSON Schema (2020-12) of recipes with every operator and output format.
Json recipe_schema();

}  // namespace seamount::recipe
