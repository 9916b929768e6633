// The parameters of terrain.import, which has no algorithm of its own: they are the options of the raster reader.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <tuple>

#include "seamount/io/read_options.h"
#include "seamount/recipe/registry.h"

namespace seamount::recipe {

struct ImportParams {
  FilePath file;
  std::optional<double> cell_m;
  std::optional<double> low_m;
  std::optional<double> high_m;
  bool fill_voids = false;
  int band = 0;
  io::ElevationCoding coding = io::ElevationCoding::numbers;
  std::string unit;
  std::string crs;
  io::ByteOrder byte_order = io::ByteOrder::little;

  static constexpr auto fields() {
    using P = ImportParams;
    return std::tuple(
        field(&P::file, "file", "GeoTIFF, HGT, ASC, PNG, EXR, R16, R32 or NPY file"),
        field(&P::cell_m, "cell_m", "m", between(1e-4, 1e6), "cell size, where the file does not say"),
        field(&P::low_m, "low_m", "m", between(-20000, 20000), "height of the lowest code of an 8- or 16-bit image"),
        field(&P::high_m, "high_m", "m", between(-20000, 20000), "height of the highest code of an 8- or 16-bit image"),
        field(&P::fill_voids, "fill_voids",
              "give cells without data the heights that the rims of their holes lead to; otherwise they stay unknown"),
        field(&P::band, "band", "", between(0, 1000),
              "band of a raster with several; 0: the first, unless they are colours"),
        field(&P::coding, "coding",
              "how heights are held: numbers, or in the colours of web map tiles: terrarium, mapbox (Terrain-RGB)"),
        field(&P::unit, "unit", "unit of the heights, such as feet, where the file says none or a wrong one"),
        field(&P::crs, "crs",
              "coordinate system, such as EPSG:4326, where the file says none or a wrong one; local: metres"),
        field(&P::byte_order, "byte_order", "which byte of a sample of a raw 16-bit file comes first: little, big"));
  }
};

/// What is said of cells that were filled.
inline std::string filled_note(int64_t cells) {
  return std::to_string(cells) + " cells without a height are filled from the rims of their holes";
}

/// For the reader: what a document in a coordinate system imports comes into it. Throws InvalidArgument.
io::ReadOptions read_options(const ImportParams& params, const Call& call, const RunContext& run);

}  // namespace seamount::recipe
