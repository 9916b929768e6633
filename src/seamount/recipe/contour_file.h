// Contours from a file of lines.
#pragma once

#include <string>

#include "seamount/base/run_context.h"
#include "seamount/io/vector.h"
#include "seamount/model/contour_set.h"

namespace seamount::recipe {

/// The lines of a file, closed where they are open (geom/contour/lines.h). `frame`: for files that carry none. Throws
/// IoError.
ContourSet contours_of_file(const std::string& path, const io::VectorOptions& options, const GridFrame& frame,
                            const RunContext& run);

}  // namespace seamount::recipe
