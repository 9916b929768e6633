// terrain.crop around a place that is given as longitude and latitude.
#pragma once

#include "seamount/ops/terrain/crop.h"

namespace seamount::recipe {

/// The parameters with that place in metres. Throws InvalidArgument for one beside the terrain, half a place or two.
terrain::CropParams in_metres(const terrain::CropParams& params, const GridFrame& terrain);

}  // namespace seamount::recipe
