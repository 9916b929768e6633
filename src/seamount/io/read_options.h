// What a reader of rasters can be told that the file does not say.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/io/sidecar.h"
#include "seamount/model/grid.h"

namespace seamount::io {

/// How a file holds heights.
enum class ElevationCoding {
  numbers,    ///< one number a cell
  terrarium,  ///< red * 256 + green + blue / 256 - 32768 metres
  mapbox,     ///< -10000 + (red * 65536 + green * 256 + blue) / 10 metres: Mapbox Terrain-RGB
};

/// Which byte of a 16-bit sample of a raw file comes first.
enum class ByteOrder { little, big };

struct ReadOptions {
  std::optional<double> cell_m;      ///< where the file does not say; > 0
  std::optional<HeightRange> range;  ///< heights of the lowest and highest code of an integer image, or of 0 and 1 of
                                     ///< real values; beats a side-car
  std::optional<int> band;  ///< of a raster with several; absent: the first, and colours are refused as heights
  ElevationCoding coding = ElevationCoding::numbers;
  std::string unit;  ///< of heights ("feet"); empty: as the file says, else metres
  std::string crs;   ///< beats the file's system; "local": metres without a system; empty: as the file says
  ByteOrder byte_order = ByteOrder::little;
  std::string into;    ///< system for a raster that must be warped; empty: a local one
  bool cover = false;  ///< warped rasters cover all of theirs, unknown beyond; else the largest rectangle inside it
  std::optional<GridFrame> lattice;  ///< in that system, whose cells warped rasters take if theirs are about as large
  int64_t max_cells = 300'000'000;   ///< larger rasters are refused (17 320 squared)
  RunContext run;                    ///< progress, cancelling, and notes of what was taken for granted
};

}  // namespace seamount::io

template <>
struct seamount::Choices<seamount::io::ElevationCoding> {
  static constexpr std::array<std::string_view, 3> names = {"numbers", "terrarium", "mapbox"};
};
template <>
struct seamount::Choices<seamount::io::ByteOrder> {
  static constexpr std::array<std::string_view, 2> names = {"little", "big"};
};
