#include "seamount/tiles/tiled_crop.h"

#include <limits>
#include <tuple>

#include "seamount/recipe/crop_place.h"
#include "seamount/recipe/kinds.h"
#include "seamount/tiles/step_params.h"
#include "seamount/tiles/tiled_ways.h"

namespace seamount::tiles {
namespace {

/// The middle of the highest cell, or of the lowest where `sign` is -1; of equals the first, row by row.
Vec2 extreme_place(const World& world, const OutputOf& terrain, float sign, const RunContext& run) {
  const GridFrame& frame = world.frame(terrain);
  const Layout layout(frame, world.tile_size());
  float best = -std::numeric_limits<float>::infinity();
  int best_row = 0, best_column = 0;
  for (int tile = 0; tile < layout.count(); ++tile) {
    run.check_cancelled();
    const Rect rect = layout.tile(tile);
    const recipe::Value value = world.window(terrain, rect);
    const auto& heights = value.get<recipe::kinds::Terrain>();
    for (int y = 0; y < rect.height; ++y) {
      for (int x = 0; x < rect.width; ++x) {
        const float z = sign * heights(x, y);
        const int row = rect.row + y, column = rect.column + x;
        const bool before = std::tie(row, column) < std::tie(best_row, best_column);
        if (!(z > best || (z == best && before))) continue;  // unknown cells never are
        best = z;
        best_row = row;
        best_column = column;
      }
    }
  }
  return {frame.x(best_column), frame.y(best_row)};
}

}  // namespace

std::string crop_refusal(const recipe::Step& step, const recipe::PlannedStep&) {
  return step.in.at("terrain").from_file() ? "its terrain comes from a file" : "";
}

void run_tiled_crop(World& world, size_t step, const RunContext& run) {
  const OutputOf from = world.output_of(world.step(step).in.at("terrain"));
  const GridFrame& terrain = world.frame(from);
  const std::string& crs = world.recipe().domain.crs;
  if (!crs.empty() && !terrain.crs.empty() && crs != terrain.crs)
    throw NeedsWhole{"it lies in another coordinate system than the document"};
  const terrain::CropParams params = recipe::in_metres(step_params<terrain::CropParams>(world.step(step)), terrain);
  const float sign = params.around == terrain::Around::highest ? 1.0F : -1.0F;
  const Vec2 extreme = terrain::around_extreme(params) ? extreme_place(world, from, sign, run) : Vec2{};
  const terrain::CropCells cells = terrain::crop_cells(terrain, params, extreme, run);
  const auto stored = world.on_disk({step, "terrain"}, cells.frame);
  for (int tile = 0; tile < stored->layout().count(); ++tile) {
    run.check_cancelled();
    Rect rect = stored->layout().tile(tile);
    rect.column += cells.column;
    rect.row += cells.row;
    if (!stored->has(tile)) stored->write(tile, world.window(from, rect));
    run.report((tile + 1.0) / stored->layout().count());
  }
  world.keep_tiles({step, "terrain"}, stored);
}

}  // namespace seamount::tiles
