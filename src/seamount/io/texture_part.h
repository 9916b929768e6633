// The part of a terrain's picture that lies over some samples of it.
#pragma once

#include "seamount/model/grid.h"
#include "seamount/model/image.h"

namespace seamount::io {

/// The part of a picture of a whole terrain (`of`) between the outer samples of `samples`, as fine as the picture;
/// beyond the terrain its edge. Linear between pixels.
Image texture_between(const Image& picture, const GridFrame& of, const GridFrame& samples);

/// The same from edge to edge of all cells of `samples`: half a cell more at each side.
Image texture_over(const Image& picture, const GridFrame& of, const GridFrame& samples);

}  // namespace seamount::io
