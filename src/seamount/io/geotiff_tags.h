// What GeoTIFFs say of themselves, alike whoever writes them. Not part of the public interface.
#pragma once

#include <gdal_priv.h>

#include "seamount/io/provenance.h"
#include "seamount/model/grid.h"

namespace seamount::io {

/// Place, system and origin.
void tag_place(GDALDataset& dataset, const GridFrame& frame, const Provenance& made);

/// Its first band holds heights in metres, or regions.
void tag_heights(GDALDataset& dataset);
void tag_regions(GDALDataset& dataset);

}  // namespace seamount::io
