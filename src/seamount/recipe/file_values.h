// Files as values: what an input port reads when it is given a file instead of a step.
#pragma once

#include <string>

#include "seamount/base/hash.h"
#include "seamount/base/run_context.h"
#include "seamount/recipe/value.h"

namespace seamount::recipe {

/// Reads a file as a value of this kind: rasters of heights or scalars, label rasters, painted label images of any size
/// (laid over `frame` if nothing beside them says where they lie), pictures, vector files. Throws IoError.
Value read_value_file(const std::string& path, ValueKind kind, const GridFrame& frame, const RunContext& run);

/// A painted label image (io/label_image.h) laid over the domain. Throws IoError.
LabelMap read_label_picture(const std::string& path, const GridFrame& domain, const RunContext& run);

/// Hash of a file's content, and of the files that belong to it (a Shapefile's .shx, .dbf and .prj, a side-car .json).
/// Throws IoError.
Digest file_digest(const std::string& path);

}  // namespace seamount::recipe
