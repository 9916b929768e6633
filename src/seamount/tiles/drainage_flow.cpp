// Directions, falling ground and accumulation (drainage.h).
#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "seamount/recipe/kinds.h"
#include "seamount/tiles/border_flats.h"
#include "seamount/tiles/drainage.h"
#include "seamount/tiles/windows.h"

namespace seamount::tiles {
namespace {

/// A rectangle and a ring of one cell around it, as far as the whole goes.
Rect ringed(const Rect& rect, const GridFrame& frame) { return with_reach(rect, Reach::neighbourhood(1), frame); }

template <class T>
Grid<T> inner(const Grid<T>& grid, const Rect& window, const Rect& rect) {
  Grid<T> part(grid.frame().window(rect.column - window.column, rect.row - window.row, rect.width, rect.height));
  for (int y = 0; y < rect.height; ++y) {
    const auto row = grid.row(rect.row - window.row + y)
                         .subspan(static_cast<size_t>(rect.column - window.column), static_cast<size_t>(rect.width));
    std::copy(row.begin(), row.end(), part.row(y).begin());
  }
  return part;
}

}  // namespace

void Drainage::direct(const RunContext& run) {
  if (codes_->complete()) return;
  const auto read = [this](const Rect& rect) { return filled_window(rect); };
  BorderFlats flats(layout_, frame_, sea_m_, run_);
  each_tile(run.part(0.0, 0.4), [&](int tile) { flats.look_at(tile, read(ringed(layout_.tile(tile), frame_))); });
  flats.drain(read, [&](const GridFrame& around) {
    constexpr double kBytes = 24;  // of a cell, while its flat is drained
    world_.check_fits(kBytes * static_cast<double>(around.cells()), "a lake over the borders of tiles",
                      "is drained as a whole", around);
  });
  each_tile(run.part(0.5, 1.0), [&](int tile) {
    if (codes_->has(tile)) return;
    const Rect rect = layout_.tile(tile), window = ringed(rect, frame_);
    geom::FlowDirections codes = inner(geom::flow_directions(read(window), sea_m_, run_), window, rect);
    flats.put(tile, codes);
    ScalarField kept(codes.frame());
    std::copy(codes.cells().begin(), codes.cells().end(), kept.cells().begin());
    codes_->write(tile, recipe::Value::of<recipe::kinds::Field>(std::move(kept)));
  });
}

geom::FlowDirections Drainage::directions(int tile) const {
  const recipe::Value kept = codes_->read(layout_.tile(tile));
  geom::FlowDirections codes(*kept.frame());
  std::transform(kept.get<recipe::kinds::Field>().cells().begin(), kept.get<recipe::kinds::Field>().cells().end(),
                 codes.cells().begin(), [](float code) { return static_cast<uint8_t>(code); });
  return codes;
}

/// The tile's filled surface as it falls, in a ring of its neighbours' rims.
HeightField Drainage::with_ring(int tile) const {
  const Rect rect = layout_.tile(tile), window = ringed(rect, frame_);
  HeightField z = filled_window(window);
  geom::FlowDirections codes(z.frame(), geom::kOutlet);
  const geom::FlowDirections own = directions(tile);
  for (int y = 0; y < window.height; ++y) {
    for (int x = 0; x < window.width; ++x) {
      const int column = window.column + x, row = window.row + y;
      if (rect.contains({column, row, 1, 1}))
        codes(x, y) = own(column - rect.column, row - rect.row);
      else
        z(x, y) = tilted_[static_cast<size_t>(node_of(rim_place(layout_, column, row)))];
    }
  }
  geom::tilt_flats(z, codes, run_);
  return z;
}

/// Heights along a way hang on those downstream: tiles are looked at again while the rims beside them rise.
void Drainage::tilt(const RunContext& run) {
  tilted_.assign(static_cast<size_t>(first_node_.back()), 0.0F);
  each_tile(run, [&](int tile) {
    const HeightField z = filled_window(layout_.tile(tile));
    for (int32_t rim = 0; rim < rim_size(layout_, tile); ++rim)
      tilted_[static_cast<size_t>(node_of({tile, rim}))] = z.data()[geom::rim_cell(rim, z.width(), z.height())];
  });
  std::deque<int> waiting;
  std::vector<bool> waits(static_cast<size_t>(layout_.count()), true);
  for (int tile = 0; tile < layout_.count(); ++tile) waiting.push_back(tile);
  while (!waiting.empty()) {
    run_.check_cancelled();
    const int tile = waiting.front();
    waiting.pop_front();
    waits[static_cast<size_t>(tile)] = false;
    const Rect rect = layout_.tile(tile);
    const HeightField z = inner(with_ring(tile), ringed(rect, frame_), rect);
    for (int32_t rim = 0; rim < rim_size(layout_, tile); ++rim) {
      float& known = tilted_[static_cast<size_t>(node_of({tile, rim}))];
      const float risen = z.data()[geom::rim_cell(rim, z.width(), z.height())];
      if (risen == known) continue;
      known = risen;
      const CellPlace at = cell_place(layout_, {tile, rim});
      for (size_t k = 0; k < 8; ++k) {
        const int column = at.column + geom::kFlowDx[k], row = at.row + geom::kFlowDy[k];
        if (column < 0 || row < 0 || column >= layout_.width || row >= layout_.height) continue;
        const int other = row / layout_.size * layout_.columns() + column / layout_.size;
        if (other == tile || waits[static_cast<size_t>(other)]) continue;
        waits[static_cast<size_t>(other)] = true;
        waiting.push_back(other);
      }
    }
  }
}

HeightField Drainage::filled(int tile) const {
  const Rect rect = layout_.tile(tile);
  return tilted_.empty() ? filled_window(rect) : inner(with_ring(tile), ringed(rect, frame_), rect);
}

/// What leaves a tile at a rim cell, and the rim cell over which it leaves the next one, until all has arrived.
void Drainage::gather(const RunContext& run) {
  const auto nodes = static_cast<size_t>(first_node_.back());
  entering_.assign(nodes, 0);
  std::vector<uint64_t> leaving(nodes, 0);  // by node over which it leaves
  std::vector<int32_t> next(nodes, -1);     // where it enters then
  std::vector<int32_t> over(nodes, -1);     // of what enters: the node over which it leaves again
  each_tile(run, [&](int tile) {
    const geom::FlowDirections codes = directions(tile);
    const std::vector<int32_t> exits = geom::rim_exits(codes);
    const Grid<uint64_t> own = geom::gather_piece(codes, std::vector<uint64_t>(exits.size(), 0), run_);
    for (int32_t rim = 0; rim < static_cast<int32_t>(exits.size()); ++rim) {
      const auto node = static_cast<size_t>(node_of({tile, rim}));
      const int32_t exit = exits[static_cast<size_t>(rim)];
      if (exit >= 0) over[node] = node_of({tile, exit});
      const int32_t cell = geom::rim_cell(rim, codes.width(), codes.height());
      if (exit != rim || codes.data()[cell] >= 8) continue;  // it does not leave here
      const CellPlace at = cell_place(layout_, {tile, rim});
      const size_t k = codes.data()[cell];
      next[node] = node_of(rim_place(layout_, at.column + geom::kFlowDx[k], at.row + geom::kFlowDy[k]));
      leaving[node] = own.data()[cell];
    }
  });
  std::vector<int32_t> waits_for(nodes, 0), ready;
  const auto follower = [&](int32_t node) { return over[static_cast<size_t>(next[static_cast<size_t>(node)])]; };
  for (int32_t node = 1; node < static_cast<int32_t>(nodes); ++node) {
    if (next[static_cast<size_t>(node)] < 0) continue;
    if (const int32_t then = follower(node); then >= 0) ++waits_for[static_cast<size_t>(then)];
  }
  for (int32_t node = 1; node < static_cast<int32_t>(nodes); ++node)
    if (next[static_cast<size_t>(node)] >= 0 && waits_for[static_cast<size_t>(node)] == 0) ready.push_back(node);
  while (!ready.empty()) {
    const int32_t node = ready.back();
    ready.pop_back();
    const uint64_t water = leaving[static_cast<size_t>(node)];
    entering_[static_cast<size_t>(next[static_cast<size_t>(node)])] += water;
    const int32_t then = follower(node);
    if (then < 0) continue;
    leaving[static_cast<size_t>(then)] += water;
    if (--waits_for[static_cast<size_t>(then)] == 0) ready.push_back(then);
  }
}

Grid<uint64_t> Drainage::cells(int tile) const {
  const auto first = entering_.begin() + first_node_[static_cast<size_t>(tile)];
  return geom::gather_piece(directions(tile), {first, first + rim_size(layout_, tile)}, run_);
}

}  // namespace seamount::tiles
