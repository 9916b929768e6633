// Which files a recipe will write is known before anything runs: no two outputs write the same one, and none is written
// over the recipe or over what it reads.
#pragma once

#include <string>
#include <vector>

#include "seamount/recipe/recipe.h"

namespace seamount::recipe {

/// Do two names mean the same file, or may they? '*' stands for one or more digits.
bool may_be_same_file(const std::string& a, const std::string& b);

/// Reports outputs that would write the same file, at /outputs/i/path.
void check_outputs_apart(const std::vector<Output>& outputs, const ReadPlace& place);

/// Files that a recipe reads, itself among them; those that belong to them (side-cars and the like) too.
std::vector<std::string> read_files(const Recipe& recipe);

/// Throws InvalidArgument{"output 'x'"} for an output that would be written over one of read_files().
void check_nothing_overwritten(const Recipe& recipe, const std::string& out_folder);

}  // namespace seamount::recipe
