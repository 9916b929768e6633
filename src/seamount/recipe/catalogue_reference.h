// The reference of catalogues: what `seamount describe catalogue` prints and docs/catalogues.md holds.
#pragma once

#include <string>

namespace seamount::recipe {

/// For a terminal: members, words of expressions, functions.
std::string describe_catalogue();

/// docs/catalogues.md.
std::string catalogue_markdown();

}  // namespace seamount::recipe
