// Files that steps read: what they hold and by what they are told apart.
#pragma once

#include <string>

#include "seamount/base/run_context.h"
#include "seamount/model/label_map.h"

namespace seamount::recipe {

/// A picture by its extension (.png, .jpg, .jpeg), not areas and lines.
bool is_picture(const std::string& path);

/// A painted label image and how far its brightness says that each place has sunk.
struct PaintedPicture {
  LabelMap labels;
  ScalarField subsidence;  ///< in [0, 1], smooth; empty where nothing has sunk
};

/// A painted label image (geom/grid/painted_labels.h) where its side-car says that it lies, or laid over the domain.
/// Throws IoError.
PaintedPicture read_painted_picture(const std::string& path, const GridFrame& domain, const RunContext& run);

/// Its labels alone; says so where its brightness says more.
LabelMap read_label_picture(const std::string& path, const GridFrame& domain, const RunContext& run);

}  // namespace seamount::recipe
