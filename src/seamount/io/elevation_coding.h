// Heights coded in the colours of web map tiles, and where such a tile lies.
#pragma once

#include <optional>
#include <string>

#include "seamount/io/placement.h"
#include "seamount/io/raster.h"

namespace seamount::io {

/// Metres of a colour, 0 to 255 a channel. REQUIRES: coding is not `numbers`.
float coded_height(ElevationCoding coding, float red, float green, float blue);

/// The place of a slippy-map tile by the end of its name, ".../zoom/column/row.png" (also zoom_column_row or
/// zoom-column-row), on Web Mercator; nothing if the name is not such. `side`: pixels.
std::optional<Placement> slippy_placement(const std::string& path, int side);

}  // namespace seamount::io
