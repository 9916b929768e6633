// terrain.resample: a terrain at another cell size, or on the domain of the document.
//
// Cells that grow larger are averages, cells that grow smaller a Catmull-Rom surface through the old ones
// (geom/grid/resample.h). Beyond its edge a terrain goes on with its nearest cells.
#pragma once

#include <optional>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::terrain {

struct ResampleParams {
  std::optional<double> cell_m;
  bool centre = true;
  double scale = 1.0;

  static constexpr auto fields() {
    using P = ResampleParams;
    return std::tuple(
        field(&P::cell_m, "cell_m", "m", between(1e-4, 1e6),
              "cell size over the terrain's own extent; if absent the terrain is brought to the document's domain"),
        field(&P::centre, "centre",
              "to the domain: put the terrain's middle at the domain's middle; otherwise its coordinates count"),
        field(&P::scale, "scale", "", between(1e-3, 1e3), "stretches the terrain, width and height alike"));
  }
};

/// The terrain at params.cell_m over its own (stretched) extent, rounded to whole cells, or on `domain`. Throws
/// InvalidArgument for params out of range, an empty terrain and more than 65536 cells a side or 2^30 in all. Parallel;
/// about 10 ns per cell of the larger of both grids.
HeightField resample(const HeightField& terrain, const ResampleParams& params, const GridFrame& domain,
                     const RunContext& run);

}  // namespace seamount::terrain
