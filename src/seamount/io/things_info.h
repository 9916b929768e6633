// What `seamount info` says of a table of placements (io/things_file.h).
#pragma once

#include <optional>
#include <string>

#include "seamount/io/info.h"

namespace seamount::io {

/// Of CSV and JSON tables that write_placements() wrote; nothing for any other file. Throws IoError{path} for one that
/// is damaged. GLB files of things are described as meshes (mesh_info.h).
std::optional<FileInfo> describe_placements(const std::string& path);

}  // namespace seamount::io
