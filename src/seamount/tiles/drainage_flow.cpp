// Falling ground and accumulation (drainage.h).
#include <algorithm>

#include "seamount/geom/water/piece_rise.h"
#include "seamount/tiles/drainage.h"

namespace seamount::tiles {
namespace {

/// A rectangle and a ring of one cell around it, as far as the whole goes.
Rect ringed(const Rect& rect, const GridFrame& frame) { return with_reach(rect, Reach::neighbourhood(1), frame); }

}  // namespace

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

/// Of each rim cell, the node that its flow enters next and how it lies above that.
void Drainage::note_rises(int tile) const {
  const geom::FlowDirections codes = directions(tile);
  const std::vector<geom::RimRise> rises = geom::rim_rises(filled_window(layout_.tile(tile)), codes, run_);
  std::vector<int32_t> next, steps, least;
  for (const geom::RimRise& rise : rises) {
    const int32_t cell = rise.exit < 0 ? -1 : geom::rim_cell(rise.exit, codes.width(), codes.height());
    next.push_back(cell < 0 ? -1 : entered_from(tile, cell, codes.data()[cell]));
    steps.push_back(rise.steps);
    least.push_back(rise.least);
  }
  rises_->write(tile, next, steps, least);
}

/// The heights of rims from what all tiles say, each once that downstream is known.
void Drainage::tilt(const RunContext& run) {
  each_tile(run, [&](int tile) {
    if (!rises_->has(tile)) note_rises(tile);
  });
  std::vector<int32_t> next(1, -1), steps(1, 0), least(1, 0), way;
  std::vector<int32_t> next_of_tile, steps_of_tile, least_of_tile;
  for (int tile = 0; tile < layout_.count(); ++tile) {
    rises_->read(tile, next_of_tile, steps_of_tile, least_of_tile);
    next.insert(next.end(), next_of_tile.begin(), next_of_tile.end());
    steps.insert(steps.end(), steps_of_tile.begin(), steps_of_tile.end());
    least.insert(least.end(), least_of_tile.begin(), least_of_tile.end());
  }
  for (size_t first = 1; first < next.size(); ++first) {
    auto node = static_cast<int32_t>(first);
    for (; next[static_cast<size_t>(node)] >= 0; node = next[static_cast<size_t>(node)]) way.push_back(node);
    for (int32_t below = node; !way.empty(); way.pop_back()) {
      const auto here = static_cast<size_t>(way.back());
      least[here] = std::max(least[here], least[static_cast<size_t>(below)] + steps[here]);
      next[here] = -1;
      below = way.back();
    }
  }
  tilted_.clear();
  for (const int32_t number : least) tilted_.push_back(geom::float_of_number(number));
}

HeightField Drainage::filled(int tile) const {
  const Rect rect = layout_.tile(tile);
  return tilted_.empty() ? filled_window(rect) : inner(with_ring(tile), ringed(rect, frame_), rect);
}

/// Of each rim cell of a tile: over which one leaves what enters there, and, where water leaves over it, its direction
/// and how much of the tile's own.
void Drainage::gather_tiles(const RunContext& run) {
  each_tile(run, [&](int tile) {
    if (exits_->has(tile)) return;
    const geom::FlowDirections codes = directions(tile);
    const std::vector<int32_t> exits = geom::rim_exits(codes);
    const Grid<uint64_t> own = geom::gather_piece(codes, std::vector<uint64_t>(exits.size(), 0), run_);
    std::vector<uint8_t> code(exits.size());
    std::vector<uint64_t> leaving(exits.size());
    for (size_t rim = 0; rim < exits.size(); ++rim) {
      const int32_t cell = geom::rim_cell(static_cast<int32_t>(rim), codes.width(), codes.height());
      const bool leaves = exits[rim] == static_cast<int32_t>(rim);
      code[rim] = leaves ? codes.data()[cell] : geom::kOutlet;
      leaving[rim] = own.data()[cell];
    }
    exits_->write(tile, exits, code, leaving);
  });
}

/// What leaves a tile at a rim cell, and the rim cell over which it leaves the next one, until all has arrived.
void Drainage::gather(const RunContext& run) {
  gather_tiles(run);
  const auto nodes = static_cast<size_t>(first_node_.back());
  entering_.assign(nodes, 0);
  std::vector<uint64_t> leaving(nodes, 0), own;  // by node over which it leaves
  std::vector<int32_t> next(nodes, -1);          // where it enters then
  std::vector<int32_t> over(nodes, -1), exits;   // of what enters: the node over which it leaves again
  std::vector<uint8_t> code;
  for (int tile = 0; tile < layout_.count(); ++tile) {
    exits_->read(tile, exits, code, own);
    for (int32_t rim = 0; rim < static_cast<int32_t>(exits.size()); ++rim) {
      const auto node = static_cast<size_t>(node_of({tile, rim}));
      const int32_t exit = exits[static_cast<size_t>(rim)];
      if (exit >= 0) over[node] = node_of({tile, exit});
      const size_t k = code[static_cast<size_t>(rim)];
      if (k >= 8) continue;  // it does not leave here
      const CellPlace at = cell_place(layout_, {tile, rim});
      next[node] = node_of(rim_place(layout_, at.column + geom::kFlowDx[k], at.row + geom::kFlowDy[k]));
      leaving[node] = own[static_cast<size_t>(rim)];
    }
  }
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
