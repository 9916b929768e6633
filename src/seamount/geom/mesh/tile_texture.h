// The part of a terrain's texture that lies over one of its tiles.
#pragma once

#include "seamount/model/image.h"
#include "seamount/model/mesh.h"

namespace seamount::geom {

/// The pixels under the tile and one more on each side, so that neighbours look alike where they meet; the tile's
/// texture coordinates are changed to fit. REQUIRES: they are in [0, 1].
Image tile_texture(const Image& whole, MeshPart& tile);

}  // namespace seamount::geom
