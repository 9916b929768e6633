// The sea's surface as a part of a terrain's mesh.
#pragma once

#include <cstdint>
#include <optional>

#include "seamount/geom/mesh/block_fit.h"
#include "seamount/geom/mesh/cell_surface.h"
#include "seamount/model/grid.h"
#include "seamount/model/mesh.h"

namespace seamount::geom {

/// A sheet at sea level over a box of cells, without the squares between cells of which one is a hollow (not 0; an
/// empty grid: none; geom/water/inland.h): one rectangle, or few. Nothing where no cell of the box is sea. Linear.
std::optional<MeshPart> water_sheet(const HeightField& heights, const Grid<uint8_t>* hollows, const CellPlaces& places,
                                    const CellBox& box, Vec2 offset);

}  // namespace seamount::geom
