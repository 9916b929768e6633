// Results as the page draws them: rasters as numbers, pictures as PNG, drawn things as shapes, reports as JSON.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "seamount/recipe/value.h"

namespace seamount::server {

/// What is asked of a raster: every 2^level-th cell of each row and column, and of those a window.
struct RasterWindow {
  int level = 0;  ///< 0 to 16
  int x = 0, y = 0;
  std::optional<int> columns, rows;  ///< absent: up to the edge
};

struct RasterBytes {
  int columns = 0, rows = 0;
  std::string type;   ///< "f32", "u8" (labels), "f32x2" (currents)
  std::string bytes;  ///< little endian, row-major from the north-west
};

/// A window of a terrain, field, current or label map. Throws InvalidArgument for a window outside, IncompatibleInputs
/// for a value that is no raster. Linear in the window.
RasterBytes raster_bytes(const recipe::Value& value, const RasterWindow& window);

/// The same of cells for which holds() is true of column and row, 255, and 0 elsewhere. Throws InvalidArgument.
std::string mask_bytes(const GridFrame& frame, const RasterWindow& window, const std::function<bool(int, int)>& holds);

/// Range of the known values of a terrain or field; nothing for other values or where none is known. Linear.
std::optional<std::pair<float, float>> raster_range(const recipe::Value& value);

/// A picture as PNG, at most `most_columns` wide. Throws IncompatibleInputs for another kind.
std::vector<uint8_t> picture_bytes(const recipe::Value& value, int most_columns);

/// Areas, lines and points of a drawing, the rings of contours, the edges of a network, the skeletons of objects:
/// {"type": "FeatureCollection", ...} in metres. Throws IncompatibleInputs for another kind.
std::string shapes_json(const recipe::Value& value);

/// What stands on the ground, for drawing: shapes in their coarsest level of at least 100 triangles, and up to `most`
/// instances, the largest. Throws IncompatibleInputs for another kind.
std::string things_json(const recipe::Value& value, size_t most);

/// A report in numbers. Throws IncompatibleInputs for another kind.
std::string report_json(const recipe::Value& value);

}  // namespace seamount::server
