// Reading a grid at many scattered places at once: the vectorised form of geom/grid/resample.h's samplers, one value
// per place.
#pragma once

#include <span>

#include "seamount/model/grid.h"

namespace seamount::geom {

/// out[i] = sample_bilinear(grid, columns[i], rows[i]) to float rounding. REQUIRES: equal sizes, a grid that is not
/// empty.
void sample_bilinear_rows(const Grid<float>& grid, std::span<const float> columns, std::span<const float> rows,
                          std::span<float> out);

/// out[i] = sample_bicubic(grid, columns[i], rows[i]) (Catmull-Rom) to float rounding. Same requirements.
void sample_bicubic_rows(const Grid<float>& grid, std::span<const float> columns, std::span<const float> rows,
                         std::span<float> out);

}  // namespace seamount::geom
