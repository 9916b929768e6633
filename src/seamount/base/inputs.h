// Which of several inputs counts, decided alike everywhere.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "seamount/base/error.h"

namespace seamount {

/// Throws IncompatibleInputs unless exactly one of two inputs is given.
inline void require_one(std::string_view first, bool has_first, std::string_view second, bool has_second) {
  if (has_first != has_second) return;
  throw IncompatibleInputs("connect either '" + std::string(first) + "' or '" + std::string(second) + "'" +
                           (has_first ? ", not both" : "; neither is"));
}

/// Throws InvalidArgument if several sources of the same thing are given; `rule` says what is right.
inline void refuse_several(const std::vector<std::string>& given, const std::string& rule) {
  if (given.size() > 1) throw InvalidArgument(given[0], "given together with " + given[1] + "; " + rule);
}

}  // namespace seamount
