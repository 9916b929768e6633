// Splat maps: how much of each ground material a cell has, for the terrain shaders of game engines.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "seamount/model/grid.h"
#include "seamount/model/label_map.h"

namespace seamount::io {

/// Writes weights (>= 0, of one size) as 8-bit RGBA PNGs of four materials each: `path` itself for up to four, else
/// "name_0.png", "name_1.png", ... In every cell the weights of all files sum to exactly 255; a cell without any is all
/// of the first material. Returns the files. Throws InvalidArgument, IncompatibleInputs, IoError.
std::vector<std::string> write_splat(std::span<const Mask> weights, const std::string& path);

/// The five regions as materials in their order.
std::vector<std::string> write_splat(const LabelMap& labels, const std::string& path);

}  // namespace seamount::io
