// Filling a polygon that may cross contours with ground that fits (fill.h).
#pragma once

#include <string>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/model/areas.h"
#include "seamount/model/contour_set.h"
#include "seamount/ops/contour/edit/tools.h"

namespace seamount::contour {

/// A pattern to choose from and the name that it is spoken of by.
struct LibraryPattern {
  std::string name;
  Drawing pattern;
};

/// Noise of landforms of this size on a lattice.
geom::Fbm landforms(double wavelength_m, double cell_m);

/// Takes the best match (match.h) out of the library, or out of the set itself if that is empty, and lays it; noise
/// where nothing has room. Says which, and what became of the water. Throws as make_edit_area() does.
void fill_polygon(const Polygon& outline, const FillTool& tool, const std::vector<LibraryPattern>& library,
                  ContourSet& set, const std::string& name, Seed seed, const RunContext& run);

}  // namespace seamount::contour
