// Cells of which nothing is known (NaN), in pictures: drawn as blank ground at the height that their rims lead to.
#pragma once

#include <cmath>

#include "seamount/base/run_context.h"
#include "seamount/geom/grid/voids.h"
#include "seamount/geom/solve/fill_voids.h"
#include "seamount/model/grid.h"
#include "seamount/ops/render/colour.h"

namespace seamount::render {

/// Blank ground: as a colour of maps, and as an albedo.
inline constexpr Rgb kUnknownGround{0.60F, 0.59F, 0.57F};
inline constexpr Rgb kUnknownAlbedo{0.27F, 0.27F, 0.265F};

/// A terrain with heights everywhere, and 1 where there was none; both empty where all are known.
struct Filled {
  HeightField terrain;
  Grid<uint8_t> unknown;
};

/// Throws IncompatibleInputs where nothing is known at all.
inline Filled fill_unknown(const HeightField& terrain, const RunContext& run) {
  if (terrain.empty() || geom::count_voids(terrain, run) == 0) return {};
  Filled filled{terrain, Grid<uint8_t>(terrain.frame())};
  for (size_t i = 0; i < terrain.size(); ++i) filled.unknown.cells()[i] = std::isnan(terrain.cells()[i]) ? 1 : 0;
  geom::fill_voids(filled.terrain, run);
  return filled;
}

}  // namespace seamount::render
