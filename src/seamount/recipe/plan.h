// What is to be computed, before anything runs: the graph of a recipe's steps, each with the key of its result.
#pragma once

#include <exception>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "seamount/base/hash.h"
#include "seamount/recipe/file_snapshots.h"
#include "seamount/recipe/recipe.h"

namespace seamount::recipe {

/// A step of a plan. Indices are those of the recipe's steps.
struct PlannedStep {
  Digest key;                 ///< of everything that the result depends on; see ADR 5
  std::exception_ptr defect;  ///< why there is no key: an open input, a file that cannot be read
  size_t defect_of = 0;       ///< the step that has the defect: itself, or one that it needs
  std::vector<size_t> reads;  ///< steps that it reads from, each once
  std::vector<std::shared_ptr<const io::FileSnapshot>> files;  ///< as they were when the key was made
  bool needed = false;                                         ///< for what is wanted
  std::set<std::string> ports;                                 ///< outputs that a needed step or the caller reads
};

struct Plan {
  std::shared_ptr<const Recipe> recipe;
  std::vector<PlannedStep> steps;          ///< one for each of the recipe's, in the same order
  std::vector<size_t> targets;             ///< steps whose results are wanted
  std::map<std::string, size_t> index_of;  ///< by the step's id
};

/// A name in a recipe as a path that can be opened.
std::string resolve_file(const Recipe& recipe, const std::string& name);

/// Plans what `wanted` needs; a source without a port means the step alone. Keys are computed for all steps. Reads the
/// files that steps name, and throws nothing for one that cannot be read: it is the defect of its step. REQUIRES: the
/// recipe has what is wanted.
Plan make_plan(std::shared_ptr<const Recipe> recipe, const std::vector<Source>& wanted, FileSnapshots& files);

}  // namespace seamount::recipe
