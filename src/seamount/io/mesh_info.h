// What a mesh file is, for people: triangles, vertices, parts, extent, heights, and how far it is from its terrain
// where the file says so.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "seamount/io/info.h"

namespace seamount::io {

/// .glb, .obj, .ply, .stl, of any program; nothing for other names, and for networks (io/tin_file.h), which are PLY
/// too. GLB and OBJ are taken as y up, PLY and STL as z up, units as metres. Throws IoError{path}. Reads the whole
/// file, but of a GLB its description alone.
std::optional<FileInfo> describe_mesh(const std::string& path);
/// The same of bytes; `name` stands in messages and says the format by its extension.
std::optional<FileInfo> describe_mesh(std::span<const uint8_t> bytes, const std::string& name);

}  // namespace seamount::io
