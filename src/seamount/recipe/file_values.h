// Files that steps read: what they hold and by what they are told apart.
#pragma once

#include <string>

#include "seamount/base/hash.h"
#include "seamount/base/run_context.h"
#include "seamount/model/label_map.h"

namespace seamount::recipe {

/// A picture by its extension (.png, .jpg, .jpeg), not areas and lines.
bool is_picture(const std::string& path);

/// A painted label image (io/label_image.h) laid over the domain. Throws IoError.
LabelMap read_label_picture(const std::string& path, const GridFrame& domain, const RunContext& run);

/// Hash of a file's content and of the files that belong to it (io/file_digest.h). Throws IoError.
Digest file_digest(const std::string& path);

}  // namespace seamount::recipe
