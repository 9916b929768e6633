#include "seamount/ops/hydrology/fill.h"

#include <algorithm>

#include "seamount/base/parallel.h"
#include "seamount/geom/water/flow.h"
#include "seamount/geom/water/inland.h"
#include "seamount/ops/hydrology/breach.h"
#include "seamount/ops/hydrology/lake_areas.h"
#include "seamount/ops/hydrology/mostly_sea.h"

namespace seamount::hydrology {

Filled fill(const HeightField& terrain, const FillParams& params, const RunContext& run) {
  check_params(params);
  say_mostly_sea(terrain, params.sea, run);
  const float sea = params.sea ? 0.0F : geom::kNoSea;
  HeightField cut = geom::raise_inland(terrain, sea, params.min_sea_m2, run);
  if (params.depressions == Depressions::breach) {
    const auto steps = static_cast<int>(std::min(1e9, params.max_length_m / terrain.cell_m()));
    breach_depressions(cut, sea, steps, static_cast<float>(params.max_cut_m), run.part(0.0, 0.5));
  }
  Filled out{geom::fill_depressions(cut, sea, run.part(0.5, 0.8)), ScalarField(terrain.frame()), {}};
  for (size_t i = 0; i < cut.size(); ++i) cut.data()[i] = std::min(cut.data()[i], terrain.data()[i]);
  out.lakes = trace_lakes(cut, out.terrain, params.min_lake_m2, run.part(0.8, 0.9));
  if (params.descend) {
    geom::tilt_flats(out.terrain, geom::flow_directions(out.terrain, sea, run), run);
  }
  parallel_rows(run.part(0.9, 1.0), terrain.width(), terrain.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < terrain.width(); ++x) out.change_m(x, y) = out.terrain(x, y) - terrain(x, y);
    }
  });
  geom::forget_unknown(out.terrain);
  return out;
}

}  // namespace seamount::hydrology
