// What made a file, for its metadata.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "seamount/base/version.h"

namespace seamount::io {

struct Provenance {
  std::string program = std::string("Seamount ") + kVersion;
  std::string recipe;            ///< recipe or command line; empty: not stated
  std::optional<uint64_t> seed;  ///< of the run
  bool operator==(const Provenance&) const = default;
};

}  // namespace seamount::io
