#include "seamount/ops/island/outlines.h"

#include <algorithm>
#include <cmath>

#include "seamount/geom/contour/contour.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/ops/island/shape.h"

namespace seamount::island {

Drawing outlines(const LabelMap& labels, const OutlinesParams& params, const RunContext& run) {
  check_params(params);
  const double tolerance = params.tolerance_m > 0 ? params.tolerance_m : 0.25 * labels.cell_m();
  Drawing drawing;
  drawing.crs = labels.frame().crs;
  Grid<uint8_t> inside(labels.frame());
  int64_t previous = 0;
  for (int region = 0; region < static_cast<int>(Region::abyss); ++region) {
    run.check_cancelled();
    int64_t count = 0;
    for (size_t c = 0; c < labels.size(); ++c) {
      const bool within = static_cast<int>(labels.cells()[c]) <= region;
      inside.cells()[c] = within ? 1 : 0;
      count += within ? 1 : 0;
    }
    if (count == previous) continue;
    previous = count;
    NamedArea area{kAreaNames[static_cast<size_t>(region)], {}};
    for (Polygon& part : geom::trace_mask(inside, run)) {
      run.check_cancelled();
      if (geom::area(part) < params.min_area_m2) continue;
      part.outer = geom::simplify(part.outer, tolerance);
      std::erase_if(part.holes,
                    [&](const Ring& hole) { return std::abs(geom::signed_area(hole)) < params.min_area_m2; });
      for (Ring& hole : part.holes) hole = geom::simplify(hole, tolerance);
      area.parts.push_back(std::move(part));
    }
    drawing.areas.push_back(std::move(area));
  }
  return drawing;
}

}  // namespace seamount::island
