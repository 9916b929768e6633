// Exact Euclidean distances on grids: to a set of cells, and to drawn borders.
//
// To cells: Meijster, Roerdink and Hesselink 2000 and Felzenszwalb and Huttenlocher 2012, a sweep along columns and a
// lower envelope of parabolas along rows, linear in the cells. To borders: a quadtree over the grid that hands each
// square only those segments that can be nearest to one of its cells, so the distance is exact, not propagated.
#pragma once

#include <cstdint>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// Distance in metres from each cell's centre to the nearest centre of a cell with inside != 0; 0 on the set itself,
/// +infinity everywhere if the set is empty. Exact to float rounding. Parallel, linear time.
ScalarField distance_to(const Grid<uint8_t>& inside, const RunContext& run);

/// Index (row * width + column) of the nearest cell with inside != 0, -1 everywhere if the set is empty. Of cells at
/// the same distance any one, always the same. `nearest` gets inside's frame. Parallel, linear time.
void nearest_feature(const Grid<uint8_t>& inside, Grid<int32_t>& nearest, const RunContext& run);
/// And how far it is, as distance_to().
void nearest_feature(const Grid<uint8_t>& inside, Grid<int32_t>& nearest, ScalarField& distance, const RunContext& run);

/// Distance in metres from each cell's centre to the border (outer rings and holes) of the polygons' union, negative
/// inside, exact to float rounding; +infinity without any edge. Where polygons overlap, borders that lie within another
/// polygon count as border. Parallel; about cells x log(segments near a cell).
ScalarField signed_distance(const std::vector<Polygon>& polygons, const GridFrame& frame, const RunContext& run);

/// Distance in metres from each cell's centre to the nearest point of any of the lines (unsigned), as above.
ScalarField distance_to_lines(const std::vector<Polyline>& lines, const GridFrame& frame, const RunContext& run);

}  // namespace seamount::geom
