// Files that steps read: what they hold and by what they are told apart.
#pragma once

#include <string>

#include "seamount/base/run_context.h"
#include "seamount/model/label_map.h"

namespace seamount::recipe {

/// A picture by its extension (.png, .jpg, .jpeg), not areas and lines.
bool is_picture(const std::string& path);

/// A painted label image (geom/grid/painted_labels.h) where its side-car says that it lies, or laid over the domain.
/// Throws IoError.
LabelMap read_label_picture(const std::string& path, const GridFrame& domain, const RunContext& run);

}  // namespace seamount::recipe
