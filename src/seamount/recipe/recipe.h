// A recipe: a domain, a seed, steps that form a graph, outputs (docs/guide/recipes.md). Reading one checks everything
// that can be checked without running it and reports all defects at once, each with its place.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "seamount/recipe/domain.h"
#include "seamount/recipe/registry.h"

namespace seamount::recipe {

/// Where an input comes from: a port of an earlier step, or a file.
struct Source {
  std::string step;
  std::string port;
  std::string file;  ///< non-empty: a file, and step and port are empty
  bool from_file() const { return !file.empty(); }
  auto operator<=>(const Source&) const = default;
};

struct Step {
  std::string id;
  std::string output;  ///< of a step that only prepares an output, such as a picture of a terrain: its path
  const Operator* op = nullptr;
  std::map<std::string, Source> in;  ///< by input port
  Json params;                       ///< complete: every parameter, defaults filled in
  Seed seed;
  std::string incomplete;  ///< why it cannot run yet: a required input is open; empty wherever a recipe is run
};

struct Output {
  Source from;                             ///< the value, or what a step that was added for the output makes of it
  std::map<std::string, Source> prepared;  ///< what other added steps make, by OutputFormat::prepare's names
  std::string path;                        ///< relative to the output folder
  std::vector<std::string> files;          ///< all that is written, path among them; '*' stands for digits
  const OutputFormat* format = nullptr;
  Json params;  ///< complete
};

struct Recipe {
  std::string file;    ///< for messages
  std::string folder;  ///< relative file names are relative to it
  const Registry* registry = nullptr;
  GridFrame domain;
  bool domain_stated = false;  ///< false: the document says nothing of its width and height
  Seed seed;
  std::vector<Step> steps;     ///< every step after those that it needs; those that prepare outputs last
  std::vector<Step> bypassed;  ///< steps left out: what was connected to them is connected to what they pass on
  std::vector<Output> outputs;
  std::vector<Diagnostic> notes;  ///< what its author should know although it can be run: former names
};

/// Changes to a document before it is read: what the command line gives.
struct RecipeChanges {
  std::vector<std::string>
      sets;  ///< "steps.isle.params.subsidence=0.5", "domain.cell_m=5"; values are JSON or plain text
  std::optional<uint64_t> seed;
  std::optional<int> size;  ///< cells along the longer side of the domain
  bool tiled = false;       ///< it is run in tiles: its domain may be larger than memory
};

/// Reads a document that may be wrong or incomplete: open inputs that are required go to `missing`, every other defect
/// to `defects`. Without defects the recipe is sound but for its `incomplete` steps. `folder`: where its relative file
/// names start. `most_cells`: of the domain.
Recipe read_document(const Json& root, const std::string& file, const std::string& folder, Diagnostics& defects,
                     Diagnostics& missing, const Registry& registry = standard_registry(),
                     int64_t most_cells = kMostCells);

/// Reads recipe text. Throws RecipeError with every defect found, Cancelled. `folder`: where its relative file names
/// start. `registry` must outlive the recipe.
Recipe parse_recipe(const std::string& text, const std::string& file, const std::string& folder,
                    const RecipeChanges& changes = {}, const Registry& registry = standard_registry(),
                    const RunContext& run = {});

/// The text of a recipe file, or of /dev/stdin, up to the length that is read at all. Throws IoError, Cancelled.
std::string read_recipe_text(const std::string& path, const RunContext& run = {});

/// Reads a recipe file, or a recipe from /dev/stdin; its relative file names are relative to it. Throws IoError,
/// RecipeError or Cancelled.
Recipe read_recipe(const std::string& path, const RecipeChanges& changes = {},
                   const Registry& registry = standard_registry(), const RunContext& run = {});

/// JSON Schema (2020-12) of recipes with every operator and output format.
Json recipe_schema(const Registry& registry = standard_registry());

}  // namespace seamount::recipe
