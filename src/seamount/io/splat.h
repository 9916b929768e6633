// Splat maps: how much of each ground material a cell has, for the terrain shaders of game engines.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/io/provenance.h"
#include "seamount/model/grid.h"
#include "seamount/model/ground_layer.h"

namespace seamount::io {

/// grey: a picture for each layer, as engines import them; rgba: three layers a picture, red, green and blue.
enum class SplatFiles { grey, rgba };

struct SplatOptions {
  SplatFiles files = SplatFiles::grey;
  const HeightField* ground = nullptr;  ///< of the same size: the list says how much of the land each layer takes
  Provenance provenance;
};

/// The list of a map's layers and files: "maps/isle.png" -> "maps/isle_splat.json".
std::string splat_list(const std::string& path);

/// All files of a map with such layers, the list last. Grey ones are "isle_sand.png", ...; those of three layers
/// "isle_0.png", "isle_1.png", ..., or `path` itself where one holds all.
std::vector<std::string> splat_files(std::span<const std::string> layers, const std::string& path, SplatFiles files);

/// Writes weights (>= 0, of one size) as 8-bit PNGs, row 0 north, and the list. In every cell the weights of all layers
/// sum to exactly 255; a cell without any is all of the first. Alpha, where there is one, is opaque. Says the share of
/// each layer. Throws InvalidArgument, IncompatibleInputs, IoError.
void write_splat(std::span<const GroundLayer> layers, const std::string& path, const SplatOptions& options = {},
                 const RunContext& run = {});

}  // namespace seamount::io

template <>
struct seamount::Choices<seamount::io::SplatFiles> {
  static constexpr std::array<std::string_view, 2> names = {"grey", "rgba"};
};
