#include "seamount/ops/terrain/noise.h"

#include "seamount/base/parallel.h"
#include "seamount/geom/scalar/noise.h"

namespace seamount::terrain {

HeightField noise(const NoiseParams& params, const GridFrame& frame, Seed seed, const RunContext& run) {
  check_params(params);
  const geom::Fbm shape{
      .wavelength_m = params.wavelength_m, .octaves = params.octaves, .gain = params.gain, .cell_m = frame.cell_m};
  const Seed own = seed.derive("terrain.noise");
  HeightField out(frame);
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const auto row = out.row(y);
      if (params.kind == NoiseKind::ridged) {
        geom::ridged_row(own, shape, frame.x(0), frame.cell_m, frame.y(y), row);
      } else {
        geom::fbm_row(own, shape, frame.x(0), frame.cell_m, frame.y(y), row);
      }
      for (float& z : row) z = static_cast<float>(params.base_m + params.height_m * z);
    }
  });
  return out;
}

}  // namespace seamount::terrain
