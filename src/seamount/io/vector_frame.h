// The frame of a document in the files of its contours and networks, so that a grid made of them again is the same.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "seamount/model/grid.h"

namespace seamount::io {

/// The metadata item of a GeoPackage that holds its text.
inline constexpr const char* kFrameItem = "seamount_frame";

/// "width height cell_m west_m north_m". Its system is kept elsewhere.
std::string frame_text(const GridFrame& frame);

/// The inverse; nothing for text that is no frame: 1 to 65536 columns and rows, cells up to 1000 km.
std::optional<GridFrame> parse_frame(std::string_view text);

/// The member of a GeoJSON collection that holds it, with its system: `"seamount":{"frame":"...","crs":"..."}`.
std::string frame_member(const GridFrame& frame);

/// The frame in the beginning of a GeoJSON text, where frame_member() is put. Throws InvalidArgument{"seamount"} for a
/// member of that name that holds something else.
std::optional<GridFrame> find_frame_member(std::string_view beginning);

}  // namespace seamount::io
