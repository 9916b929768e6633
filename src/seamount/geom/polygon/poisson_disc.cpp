#include "seamount/geom/polygon/poisson_disc.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/disc_tile.h"

namespace seamount::geom {
namespace {

constexpr int kCells = DiscTile::kCells;

/// Points come in rounds over all tiles, few at a time, so that tiles do not show by who was first.
constexpr int kRounds = 6;
constexpr double kDartsPerRound = 0.35;

struct Tile {
  int x = 0, y = 0;  ///< in tiles
  std::array<uint32_t, kCells> open{};
  std::array<DiscTile::Offset, kCells * kCells> points{};
};

/// The box in cells and tiles, row 0 in the south.
struct Cells {
  Cells(const Box& box, double spacing_m)
      : origin(box.low),
        cell_m(spacing_m * DiscTile::kCellUnits / DiscTile::kSpacingUnits),
        width(std::max(1, static_cast<int>(std::ceil((box.high.x - box.low.x) / cell_m)))),
        height(std::max(1, static_cast<int>(std::ceil((box.high.y - box.low.y) / cell_m)))),
        tiles_x((width + kCells - 1) / kCells),
        tiles_y((height + kCells - 1) / kCells) {}

  Vec2 origin;
  double cell_m;
  int width, height, tiles_x, tiles_y;
};

/// Rows of cells about one row of tiles: which of them the sampling covers.
class Strip {
 public:
  Strip(const Cells& cells, int tile_y, int reach)
      : cells_(cells), reach_(reach), south_(tile_y * kCells - reach), rows_(kCells + 2 * reach) {}

  void cover(const std::vector<Polygon>& areas) {
    const GridFrame frame = {
        cells_.width, rows_, cells_.cell_m, cells_.origin.x, cells_.origin.y + (south_ + rows_) * cells_.cell_m, {}};
    inside_ = rasterise(areas, frame);
    for (const Polygon& area : areas) {
      draw(area.outer);
      for (const Ring& hole : area.holes) draw(hole);
    }
    widen();
  }

  /// Is a cell of the tile row in? y in [0, 32).
  bool operator()(int x, int y) const { return y + south_ + reach_ < cells_.height && inside_(x, top_ - y) != 0; }

 private:
  void draw(const Ring& ring) {
    for (size_t i = 0; i < ring.size(); ++i) draw_edge(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
  }

  /// Marks the cells along the part of an edge that lies in the strip, at half a cell's steps.
  void draw_edge(Vec2 a, Vec2 b) {
    const GridFrame& frame = inside_.frame();
    double from = 0.0, to = 1.0;
    clip(frame.column(a.x), frame.column(b.x), frame.width - 0.5, from, to);
    clip(frame.row(a.y), frame.row(b.y), frame.height - 0.5, from, to);
    if (from > to) return;
    const double length = (to - from) * std::max(std::abs(b.x - a.x), std::abs(b.y - a.y));
    const int steps = 1 + static_cast<int>(2.0 * length / cells_.cell_m);
    for (int i = 0; i <= steps; ++i) {
      const Vec2 p = a + (from + (to - from) * i / steps) * (b - a);
      const auto x = static_cast<int>(std::lround(frame.column(p.x)));
      const auto y = static_cast<int>(std::lround(frame.row(p.y)));
      if (inside_.contains(x, y)) inside_(x, y) = 1;
    }
  }

  /// Narrows [from, to] to where u + t (v - u) lies in [-1/2, high].
  static void clip(double u, double v, double high, double& from, double& to) {
    if (std::max(u, v) < -0.5 || std::min(u, v) > high) to = -1.0;
    if (u == v) return;
    const double enter = ((u < v ? -0.5 : high) - u) / (v - u);
    const double leave = ((u < v ? high : -0.5) - u) / (v - u);
    from = std::max(from, enter);
    to = std::min(to, leave);
  }

  /// Adds all cells within `reach_` rows and columns of one that is in.
  void widen() {
    const int width = cells_.width;
    std::vector<int> last(static_cast<size_t>(width), -rows_);
    for (int y = 0; y < rows_; ++y) spread_row(inside_.row(y));
    Grid<uint8_t> wide(inside_.frame(), uint8_t{0});
    for (int y = 0; y < rows_ + reach_; ++y) {  // row y - reach_ is in if one of the last 2 reach_ + 1 rows is
      for (int x = 0; x < width; ++x) {
        int& seen = last[static_cast<size_t>(x)];
        if (y < rows_ && inside_(x, y) != 0) seen = y;
        if (y >= reach_ && y - seen <= 2 * reach_) wide(x, y - reach_) = 1;
      }
    }
    inside_ = std::move(wide);
  }

  void spread_row(std::span<uint8_t> row) const {
    const auto width = static_cast<int>(row.size());
    int until = -1;
    for (int x = 0; x < width; ++x) {
      if (row[static_cast<size_t>(x)] == 1) {
        for (int i = std::max({0, x - reach_, until + 1}); i < x; ++i) row[static_cast<size_t>(i)] |= 2;
        until = x + reach_;
      } else if (x <= until) {
        row[static_cast<size_t>(x)] = 2;
      }
    }
  }

  const Cells& cells_;
  int reach_, south_, rows_;
  int top_ = rows_ - 1 - reach_;
  Grid<uint8_t> inside_;
};

/// The tiles with cells that the sampling covers, by rows.
std::vector<std::vector<Tile>> make_tiles(const std::vector<Polygon>& areas, double margin_m, const Cells& cells,
                                          const RunContext& run) {
  const int reach = static_cast<int>(std::ceil(margin_m / cells.cell_m)) + 1;
  std::vector<std::vector<Tile>> rows(static_cast<size_t>(cells.tiles_y));
  parallel_blocks(run, cells.tiles_y, 1, [&](int64_t tile_y, int64_t) {
    Strip strip(cells, static_cast<int>(tile_y), reach);
    strip.cover(areas);
    for (int tile_x = 0; tile_x < cells.tiles_x; ++tile_x) {
      Tile tile{tile_x, static_cast<int>(tile_y)};
      bool any = false;
      for (int y = 0; y < kCells; ++y) {
        for (int x = 0; x < kCells && tile_x * kCells + x < cells.width; ++x) {
          if (!strip(tile_x * kCells + x, y)) continue;
          tile.open[static_cast<size_t>(y)] |= 1U << x;
          any = true;
        }
      }
      if (any) rows[static_cast<size_t>(tile_y)].push_back(tile);
    }
  });
  return rows;
}

/// All tiles and where each is.
class TileMap {
 public:
  TileMap(std::vector<std::vector<Tile>> rows, const Cells& cells)
      : tiles_x_(cells.tiles_x),
        tiles_y_(cells.tiles_y),
        index_(static_cast<size_t>(cells.tiles_x) * static_cast<size_t>(cells.tiles_y), -1) {
    for (std::vector<Tile>& row : rows) {
      for (const Tile& tile : row) {
        index_[at(tile.x, tile.y)] = static_cast<int32_t>(tiles.size());
        tiles.push_back(tile);
      }
      std::vector<Tile>().swap(row);
    }
  }

  /// Adds points to one tile beside what it and its neighbours hold already; in the last round all that fit.
  void fill(Tile& tile, int round, Seed seed) {
    DiscTile work;
    constexpr int kRim = DiscTile::kRim;
    for (int y = -kRim; y < kCells + kRim; ++y) {
      for (int x = -kRim; x < kCells + kRim; ++x) work.set_point(x, y, point(tile, x, y));
    }
    Rng rng(seed.derive("tile", at(tile.x, tile.y) * kRounds + static_cast<size_t>(round)));
    if (round + 1 < kRounds) {
      work.sprinkle(tile.open, kDartsPerRound, rng);
    } else {
      work.fill(tile.open, rng);
    }
    for (int y = 0; y < kCells; ++y) {
      for (int x = 0; x < kCells; ++x) tile.points[static_cast<size_t>(y * kCells + x)] = work.point(x, y);
    }
  }

  std::vector<Tile> tiles;

 private:
  size_t at(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(tiles_x_) + static_cast<size_t>(x);
  }

  /// The point in a cell counted from the tile's corner, which may lie in a neighbour.
  DiscTile::Offset point(const Tile& tile, int x, int y) const {
    const int tile_x = tile.x + (x < 0 ? -1 : x / kCells);
    const int tile_y = tile.y + (y < 0 ? -1 : y / kCells);
    if (tile_x < 0 || tile_y < 0 || tile_x >= tiles_x_ || tile_y >= tiles_y_) return {};
    const int32_t neighbour = index_[at(tile_x, tile_y)];
    if (neighbour < 0) return {};
    const int cell = (y & (kCells - 1)) * kCells + (x & (kCells - 1));
    return tiles[static_cast<size_t>(neighbour)].points[static_cast<size_t>(cell)];
  }

  int tiles_x_, tiles_y_;
  std::vector<int32_t> index_;
};

void fill_all(TileMap& map, Seed seed, const RunContext& run) {
  constexpr int kTurns = 4;
  std::array<std::vector<Tile*>, kTurns> turns;
  for (Tile& tile : map.tiles) turns[static_cast<size_t>((tile.x & 1) + 2 * (tile.y & 1))].push_back(&tile);
  for (int step = 0; step < kRounds * kTurns; ++step) {
    const std::vector<Tile*>& now = turns[static_cast<size_t>(step % kTurns)];
    const RunContext part = run.part(static_cast<double>(step) / (kRounds * kTurns), (step + 1.0) / (kRounds * kTurns));
    parallel_blocks(part, static_cast<int64_t>(now.size()), 16, [&](int64_t begin, int64_t end) {
      for (int64_t i = begin; i < end; ++i) map.fill(*now[static_cast<size_t>(i)], step / kTurns, seed);
    });
  }
}

}  // namespace

DiscSampling poisson_discs(const std::vector<Polygon>& areas, double margin_m, const Box& box, double spacing_m,
                           Seed seed, const RunContext& run) {
  static_assert(DiscTile::kSpacingUnits == DiscSampling::kSpacing);
  const Cells cells(box, spacing_m);
  TileMap map(make_tiles(areas, margin_m, cells, run.part(0.0, 0.2)), cells);
  fill_all(map, seed, run.part(0.2, 0.9));
  std::vector<LatticePoint> points;
  for (const Tile& tile : map.tiles) {
    run.check_cancelled();
    for (int cell = 0; cell < kCells * kCells; ++cell) {
      const DiscTile::Offset offset = tile.points[static_cast<size_t>(cell)];
      if (offset.empty()) continue;
      points.push_back({(tile.x * kCells + cell % kCells) * DiscTile::kCellUnits + offset.x,
                        (tile.y * kCells + cell / kCells) * DiscTile::kCellUnits + offset.y});
    }
  }
  const std::vector<int32_t> order = spatial_order(points, run);
  DiscSampling sampling{{box.low, spacing_m / DiscSampling::kSpacing}, {}};
  sampling.points.reserve(points.size());
  run.check_cancelled();
  for (const int32_t i : order) sampling.points.push_back(points[static_cast<size_t>(i)]);
  return sampling;
}

}  // namespace seamount::geom
