// terrain.resample: a terrain at another cell size, or on the domain of the document.
//
// Cells that grow larger are averages, cells that grow smaller a Catmull-Rom surface through the old ones
// (geom/grid/resample.h). Beyond its edge nothing is known of a terrain, unless it is asked to go on there.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/reach.h"

namespace seamount::terrain {

enum class Beyond {
  unknown,  ///< cells without a height (NaN)
  edge,     ///< the terrain goes on with its nearest cells
};

struct ResampleParams {
  std::optional<double> cell_m;
  bool centre = true;
  double scale = 1.0;
  Beyond beyond = Beyond::unknown;

  static constexpr auto fields() {
    using P = ResampleParams;
    return std::tuple(
        field(&P::cell_m, "cell_m", "m", between(1e-4, 1e6),
              "cell size over the terrain's own extent; if absent the terrain is brought to the document's domain"),
        field(&P::centre, "centre",
              "to the domain: put the terrain's middle at the domain's middle; otherwise its coordinates count"),
        field(&P::scale, "scale", "", between(1e-3, 1e3), "stretches the terrain, width and height alike"),
        field(&P::beyond, "beyond",
              "what lies beyond the terrain: unknown, which later steps fill or respect; edge: its nearest cells"));
  }
};

/// The terrain at params.cell_m over its own (stretched) extent, rounded to whole cells, or on `domain`; says how much
/// of it lies beyond the terrain. Throws InvalidArgument for params out of range, an empty terrain and more than 65536
/// cells a side or 2^30 in all. Parallel; about 10 ns per cell of the larger of both grids.
HeightField resample(const HeightField& terrain, const ResampleParams& params, const GridFrame& domain,
                     const RunContext& run);

/// Where resample() takes a terrain of a frame to lie, and where it brings it. Throws as it does.
struct ResampleFrames {
  GridFrame source, target;
};
ResampleFrames resample_frames(const GridFrame& terrain, const ResampleParams& params, const GridFrame& domain);

/// For who makes it part by part. Cells of `out` whose middle lies beyond `source` become unknown; how many there are.
int64_t forget_beyond(HeightField& out, const GridFrame& source);
/// Says how many of `frame` lie beyond `source`. Throws IncompatibleInputs if all do.
void judge_beyond(int64_t beyond, const GridFrame& frame, const GridFrame& source, const RunContext& run);

/// On the domain each cell hangs on the terrain alone, if its place does not hang on the domain's size.
Reach resample_reach(const ResampleParams& params);

}  // namespace seamount::terrain

template <>
struct seamount::Choices<seamount::terrain::Beyond> {
  static constexpr std::array<std::string_view, 2> names = {"unknown", "edge"};
};
