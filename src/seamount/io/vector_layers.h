// Which layers of a vector file are read. Not part of the public interface.
#pragma once

#include <ogrsf_frmts.h>

#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/io/gdal_call.h"
#include "seamount/io/vector.h"

namespace seamount::io {

/// Whether a layer has areas, lines and points: by its features, of which the first thousand are looked at.
struct LayerShapes {
  bool areas = false, lines = false, points = false;
  bool any() const { return areas || lines || points; }
};
LayerShapes shapes_in(OGRLayer& layer);

/// All layers of a dataset that GDAL can open.
std::vector<OGRLayer*> layers_of(GDALDataset& dataset);

/// The layer that options.layer names; all of write_drawing()'s own; else the first that fits what is wanted, which is
/// said if there are others. Throws IoError for an unknown name and where nothing is drawn.
std::vector<OGRLayer*> choose_layers(GDALDataset& dataset, const VectorOptions& options, const GdalCall& call,
                                     const RunContext& run);

}  // namespace seamount::io
