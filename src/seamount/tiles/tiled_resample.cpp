#include "seamount/tiles/tiled_resample.h"

#include <algorithm>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/ops/terrain/resample.h"
#include "seamount/recipe/kinds.h"
#include "seamount/recipe/step_work.h"
#include "seamount/tiles/tiled_ways.h"

namespace seamount::tiles {
namespace {

constexpr int kBand = 16;  ///< rows of the result that are made at once

terrain::ResampleParams params_of(const recipe::Step& step) {
  recipe::Diagnostics none;
  return recipe::read_params<terrain::ResampleParams>(step.params, {"", none});
}

}  // namespace

std::string resample_refusal(const recipe::Step& step, const recipe::PlannedStep&) {
  const terrain::ResampleParams params = params_of(step);
  if (step.in.at("terrain").from_file()) return "its terrain comes from a file";
  if (params.scale != 1.0) return "it is stretched";
  return params.cell_m ? "" : "only to larger cells by cell_m it is run in tiles";
}

HeightField resample_by_rows(const World& world, const OutputOf& from, const GridFrame& source, const GridFrame& target,
                             const RunContext& run) {
  const geom::RowResampler resampler(source, target);
  HeightField out(target);
  for (int begin = 0; begin < target.height; begin += kBand) {
    run.check_cancelled();
    const int end = std::min(begin + kBand, target.height);
    const geom::RowResampler::Rows needs = resampler.needs(begin, end);
    HeightField rows(GridFrame{source.width, needs.count, source.cell_m});
    world.rows(from, needs.first, needs.count, rows.data());
    parallel_blocks({run.threads, {}, run.cancelled, {}}, end - begin, 1, [&](int64_t first, int64_t last) {
      std::vector<float> mixed;
      for (int y = begin + static_cast<int>(first); y < begin + static_cast<int>(last); ++y)
        resampler.row(rows, needs.first, y, mixed, out.row(y));
    });
    run.report(static_cast<double>(end) / target.height);
  }
  return out;
}

void run_tiled_resample(World& world, size_t step, const RunContext& run) {
  const OutputOf from = world.output_of(world.step(step).in.at("terrain"));
  const auto frames = terrain::resample_frames(world.frame(from), params_of(world.step(step)), world.recipe().domain);
  if (!geom::RowResampler(frames.source, frames.target).averages()) throw NeedsWhole{"cells become smaller"};
  world.check_fits(sizeof(float) * static_cast<double>(frames.target.cells()), recipe::step_name(world.step(step)),
                   "makes a raster that is needed as a whole", frames.target);
  world.keep({step, "terrain"}, recipe::Value::of<recipe::kinds::Terrain>(
                                    resample_by_rows(world, from, frames.source, frames.target, run)));
}

}  // namespace seamount::tiles
