#include "seamount/tiles/tiled_resample.h"

#include <algorithm>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/model/extent.h"
#include "seamount/ops/terrain/resample.h"
#include "seamount/recipe/kinds.h"
#include "seamount/recipe/one_frame.h"
#include "seamount/recipe/step_work.h"
#include "seamount/tiles/step_params.h"
#include "seamount/tiles/tiled_ways.h"

namespace seamount::tiles {
namespace {

constexpr int64_t kAtOnce = int64_t{1} << 22;  ///< cells of the source, about

/// The document's domain as it meets a terrain.
GridFrame domain_for(const World& world, const GridFrame& terrain) {
  const GridFrame& domain = world.recipe().domain;
  if (!domain.crs.empty() && !terrain.crs.empty() && domain.crs != terrain.crs)
    throw NeedsWhole{"it lies in another coordinate system than the document"};
  return recipe::placed_domain(domain, Extent::of(terrain));
}

/// A tile of the result, some rows at once.
HeightField make_tile(const World& world, const OutputOf& from, const GridFrame& source, double scale,
                      const GridFrame& tile, const RunContext& run) {
  const geom::RowResampler resampler(source, tile);
  const geom::RowResampler::Span columns = resampler.columns();
  HeightField out(tile);
  for (int begin = 0; begin < tile.height;) {
    run.check_cancelled();
    int end = begin + 1;
    while (end < tile.height && int64_t{resampler.rows(begin, end + 1).count} * columns.count <= kAtOnce) ++end;
    const geom::RowResampler::Span rows = resampler.rows(begin, end);
    const recipe::Value part = world.window(from, {columns.first, rows.first, columns.count, rows.count});
    HeightField heights = part.get<recipe::kinds::Terrain>();
    if (scale != 1.0)
      for (float& z : heights.cells()) z = static_cast<float>(scale * z);
    parallel_blocks({run.threads, {}, run.cancelled, {}}, end - begin, 16, [&](int64_t first, int64_t last) {
      std::vector<float> mixed;
      for (int y = begin + static_cast<int>(first); y < begin + static_cast<int>(last); ++y)
        resampler.row(heights, columns.first, rows.first, y, mixed, out.row(y));
    });
    begin = end;
  }
  return out;
}

}  // namespace

std::string resample_refusal(const recipe::Step& step, const recipe::PlannedStep&) {
  return step.in.at("terrain").from_file() ? "its terrain comes from a file" : "";
}

HeightField resample_by_rows(const World& world, const OutputOf& from, const GridFrame& source, const GridFrame& target,
                             const RunContext& run) {
  return make_tile(world, from, source, 1.0, target, run);
}

void run_tiled_resample(World& world, size_t step, const RunContext& run) {
  const OutputOf from = world.output_of(world.step(step).in.at("terrain"));
  const terrain::ResampleParams params = step_params<terrain::ResampleParams>(world.step(step));
  const GridFrame& terrain = world.frame(from);
  const auto frames = terrain::resample_frames(terrain, params, params.cell_m ? terrain : domain_for(world, terrain));
  const bool ends = !params.cell_m && params.beyond == terrain::Beyond::unknown;
  const auto stored = world.on_disk({step, "terrain"}, frames.target);
  const Layout& layout = stored->layout();
  int64_t beyond = 0;
  for (int tile = 0; tile < layout.count(); ++tile) {
    const Rect rect = layout.tile(tile);
    const GridFrame window = frames.target.window(rect.column, rect.row, rect.width, rect.height);
    if (!stored->has(tile)) {
      HeightField made = make_tile(world, from, frames.source, params.scale, window, run);
      if (ends) beyond += terrain::forget_beyond(made, frames.source);
      stored->write(tile, recipe::Value::of<recipe::kinds::Terrain>(std::move(made)));
    } else if (ends) {
      HeightField there(window, 0.0F);
      beyond += terrain::forget_beyond(there, frames.source);
    }
    run.report((tile + 1.0) / layout.count());
  }
  if (ends) terrain::judge_beyond(beyond, frames.target, frames.source, run);
  world.keep_tiles({step, "terrain"}, stored);
}

}  // namespace seamount::tiles
