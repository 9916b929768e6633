// A large GeoTIFF from rows, with little memory: tiles, overviews and, where it needs them, 64-bit offsets (BigTIFF).
#pragma once

#include <functional>
#include <string>

#include "seamount/base/run_context.h"
#include "seamount/io/provenance.h"
#include "seamount/model/grid.h"

namespace seamount::io {

/// What the cells of a raster are. Regions are bytes, the others floats.
enum class CellMeaning { heights, field, regions };

/// Fills `cells` with the rows [first, first + count) of the raster, from west to east and north to south.
using RowSource = std::function<void(int first, int count, void* cells)>;

/// Writes a raster of `frame` as write_heights(), write_field() and write_labels() do, in tiles of 512 cells, with
/// overviews: means of heights and fields, every other cell of regions. The bytes hang on the cells alone, not on how
/// they come. `cloud_optimised`: laid out for reading over the network, through a copy beside it. Memory: 512 rows and
/// GDAL's cache. Throws WriteError, and what `source` throws; then there is no file.
void write_geotiff_rows(const GridFrame& frame, CellMeaning meaning, const RowSource& source, const std::string& path,
                        const Provenance& provenance, bool cloud_optimised, const RunContext& run);

}  // namespace seamount::io
