// Tables of parameters for references.
#pragma once

#include <string>
#include <vector>

#include "seamount/recipe/param_json.h"

namespace seamount::recipe {

/// One parameter for a terminal, indented, its name after a prefix. The members of a group stand below it under their
/// own flags, those of tools without dashes.
std::string param_text(const ParamInfo& info, const std::string& indent, const std::string& prefix);

/// A Markdown table; the members of a group as group.member, a table for each tool below.
std::string params_table(const std::vector<ParamInfo>& params);

/// Text as it may stand in a cell of a Markdown table.
std::string cell(std::string text);

}  // namespace seamount::recipe
