// Directions, those of flats over the borders of tiles among them (drainage.h).
#include <algorithm>
#include <mutex>

#include "seamount/geom/water/piece_flats.h"
#include "seamount/recipe/kinds.h"
#include "seamount/tiles/border_flats.h"
#include "seamount/tiles/drainage.h"
#include "seamount/tiles/rank_lists.h"
#include "seamount/tiles/spread.h"

namespace seamount::tiles {
namespace {

using recipe::kinds::Labels;

geom::FlowDirections codes_in(const StoredRaster& raster, const Rect& rect) {
  const recipe::Value kept = raster.read(rect);
  geom::FlowDirections codes(*kept.frame());
  const auto cells = kept.get<Labels>().cells();
  std::transform(cells.begin(), cells.end(), codes.cells().begin(), [](Region code) { return uint8_t(code); });
  return codes;
}

void keep_codes(const StoredRaster& raster, int tile, const geom::FlowDirections& codes) {
  LabelMap kept(codes.frame());
  std::transform(codes.cells().begin(), codes.cells().end(), kept.cells().begin(),
                 [](uint8_t code) { return Region(code); });
  raster.write(tile, recipe::Value::of<Labels>(std::move(kept)));
}

}  // namespace

/// Directions within each tile, and what it says of its flats that reach the rim.
void Drainage::direct_tiles(const RunContext& run) {
  each_tile(run, [&](int tile) {
    if (flats_->has(tile) && (marked_->has(tile) || directions_->has(tile))) return;
    const Rect rect = layout_.tile(tile), window = with_reach(rect, Reach::neighbourhood(2), frame_);
    const geom::PieceIn piece{rect.column - window.column, rect.row - window.row, rect.width, rect.height};
    const geom::FlowDirections codes = geom::piece_directions(filled_window(window), piece, sea_m_, run_);
    const TileFlats flats = look_at_flats(codes, run_);
    const bool none = flats.steps[kFromOutlets].empty();
    keep_codes(none ? *directions_ : *marked_, tile, codes);
    flats_->write(tile, flats.steps[kFromOutlets], flats.steps[kFromHigher], flats.links.links, flats.links.linked);
  });
}

/// From what all tiles say, and rounds over those through whose flats shortest ways go.
void Drainage::walk_flats(BorderFlats& flats, const RunContext& run) const {
  TileFlats own;
  for (int tile = 0; tile < layout_.count(); ++tile) {
    flats_->read(tile, own.steps[kFromOutlets], own.steps[kFromHigher], own.links.links, own.links.linked);
    flats.add(tile, own);
  }
  flats.settle();
  for (int round = 0;; ++round) {
    run_.check_cancelled();
    const std::vector<int> tiles = flats.next_tiles();
    if (tiles.empty()) return;
    std::vector<Reached> reached;
    if (all_have([&] { return walks_->has(round); })) {
      walks_->read(round, reached);
    } else {
      reached = walk_round(flats, tiles);
      if (world_.ranks().first()) walks_->write(round, reached);
    }
    flats.lower(reached);
    run.report(1.0 - static_cast<double>(flats.waiting()) / layout_.count());
  }
}

std::vector<Reached> Drainage::walk_round(const BorderFlats& flats, const std::vector<int>& tiles) const {
  std::vector<Reached> mine;
  std::mutex finding;
  constexpr double kBytes = 12;  // of a cell
  const int pieces = at_once(kBytes * layout_.size * layout_.size, world_.memory_bytes(), run_);
  spread(world_.ranks(), run_, static_cast<int>(tiles.size()), pieces, [&](int i, const RunContext&) {
    const int tile = tiles[static_cast<size_t>(i)];
    const std::vector<Reached> more = flats.walk(tile, codes_in(*marked_, layout_.tile(tile)), run_);
    const std::lock_guard lock(finding);
    mine.insert(mine.end(), more.begin(), more.end());
    return true;
  });
  return from_all(world_.ranks(), mine);
}

void Drainage::direct(const RunContext& run) {
  if (all_have([&] { return directions_->complete(); })) return;
  direct_tiles(run.part(0.0, 0.6));
  BorderFlats flats(layout_, first_node_);
  walk_flats(flats, run.part(0.6, 0.8));
  each_tile(run.part(0.8, 1.0), [&](int tile) {
    if (directions_->has(tile)) return;
    geom::FlowDirections codes = codes_in(*marked_, layout_.tile(tile));
    flats.aim(tile, codes, run_);
    keep_codes(*directions_, tile, codes);
  });
}

geom::FlowDirections Drainage::directions(int tile) const { return codes_in(*directions_, layout_.tile(tile)); }

}  // namespace seamount::tiles
