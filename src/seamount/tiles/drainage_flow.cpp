// Falling ground and accumulation (drainage.h).
#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>

#include "seamount/tiles/drainage.h"
#include "seamount/tiles/rank_lists.h"
#include "seamount/tiles/spread.h"

namespace seamount::tiles {
namespace {

/// A rectangle and a ring of one cell around it, as far as the whole goes.
Rect ringed(const Rect& rect, const GridFrame& frame) { return with_reach(rect, Reach::neighbourhood(1), frame); }

/// The height of a rim's cell once the ground falls.
struct Risen {
  int32_t node;
  float height;
};

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

/// Lets the ground of some tiles fall, each in what was known of the rims before. Which tiles it matters to.
std::vector<bool> Drainage::tilt_round(const std::vector<int>& tiles) {
  std::vector<Risen> mine;
  std::mutex finding;
  constexpr double kBytes = 24;  // of a cell
  const int pieces = at_once(kBytes * layout_.size * layout_.size, world_.memory_bytes(), run_);
  spread(world_.ranks(), run_, static_cast<int>(tiles.size()), pieces, [&](int i, const RunContext&) {
    const int tile = tiles[static_cast<size_t>(i)];
    const Rect rect = layout_.tile(tile);
    const HeightField z = inner(with_ring(tile), ringed(rect, frame_), rect);
    const std::lock_guard lock(finding);
    for (int32_t rim = 0; rim < rim_size(layout_, tile); ++rim) {
      const int32_t node = node_of({tile, rim});
      const float height = z.data()[geom::rim_cell(rim, z.width(), z.height())];
      if (height != tilted_[static_cast<size_t>(node)]) mine.push_back({node, height});
    }
    return true;
  });
  std::vector<bool> matters(static_cast<size_t>(layout_.count()), false);
  for (const Risen& one : from_all(world_.ranks(), mine)) {
    tilted_[static_cast<size_t>(one.node)] = one.height;
    const auto next = std::upper_bound(first_node_.begin(), first_node_.end(), one.node);
    const auto tile = static_cast<int>(next - first_node_.begin()) - 1;
    for_each_beyond(layout_, {tile, one.node - first_node_[static_cast<size_t>(tile)]},
                    [&](const RimPlace& beyond) { matters[static_cast<size_t>(beyond.tile)] = true; });
  }
  return matters;
}

/// Heights along a way hang on those downstream: tiles are looked at again while the rims beside them rise.
void Drainage::tilt(const RunContext& run) {
  tilted_ = rims_;
  std::vector<int> tiles(static_cast<size_t>(layout_.count()));
  std::iota(tiles.begin(), tiles.end(), 0);
  while (!tiles.empty()) {
    run_.check_cancelled();
    const std::vector<bool> matters = tilt_round(tiles);
    tiles.clear();
    for (int tile = 0; tile < layout_.count(); ++tile)
      if (matters[static_cast<size_t>(tile)]) tiles.push_back(tile);
    run.report(1.0 - static_cast<double>(tiles.size()) / layout_.count());
  }
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
