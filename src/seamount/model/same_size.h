// Rasters that belong together have as many columns and rows.
#pragma once

#include <string>
#include <string_view>

#include "seamount/base/error.h"
#include "seamount/model/grid.h"

namespace seamount {

inline bool same_size(const GridFrame& a, const GridFrame& b) { return a.width == b.width && a.height == b.height; }

/// Throws IncompatibleInputs where `frame`, that of the input `name`, has another size than `wanted`: "labels: 32 x 32
/// cells do not match the terrain's 64 x 64". `whose`: what the wanted frame is of.
inline void check_same_size(std::string_view name, const GridFrame& frame, const GridFrame& wanted,
                            std::string_view whose = "terrain", std::string_view advice = {}) {
  if (same_size(frame, wanted)) return;
  const auto size = [](const GridFrame& f) { return std::to_string(f.width) + " x " + std::to_string(f.height); };
  throw IncompatibleInputs(std::string(name) + ": " + size(frame) + " cells do not match the " + std::string(whose) +
                           "'s " + size(wanted) + std::string(advice));
}

}  // namespace seamount
