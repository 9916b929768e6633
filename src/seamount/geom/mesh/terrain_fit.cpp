#include "seamount/geom/mesh/terrain_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "seamount/base/parallel.h"

namespace seamount::geom {
namespace {

/// `places` and so many between that no two are more than `most` apart, evenly.
std::vector<int> divided(const std::vector<int>& places, int most) {
  std::vector<int> all = {places.front()};
  for (size_t i = 1; i < places.size(); ++i) {
    const int from = places[i - 1], length = places[i] - from;
    const int parts = (length + most - 1) / most;
    for (int k = 1; k <= parts; ++k) all.push_back(from + static_cast<int>(int64_t{length} * k / parts));
  }
  return all;
}

bool holds(const CellBox& box, LatticePoint p) {
  return p.x >= box.first.x && p.x <= box.last.x && p.y >= box.first.y && p.y <= box.last.y;
}

bool is_on(const std::vector<int>& places, int i) { return std::binary_search(places.begin(), places.end(), i); }

int64_t pieces(const HeightField& heights, int steps) {
  return int64_t{(heights.width() - 2) / steps + 1} * ((heights.height() - 2) / steps + 1);
}

/// Steps between the first vertices: wide enough that they are few of what is wanted, close enough that no triangle is
/// long to measure.
int lattice_steps(const HeightField& heights, int64_t max_triangles) {
  constexpr int kClosest = 16, kWidest = 64, kShare = 16;
  if (max_triangles == 0) return kWidest;
  int steps = kClosest;
  while (2 * kShare * pieces(heights, steps) > max_triangles && steps < BlockFit::kMostSteps) steps += steps / 4;
  return steps;
}

/// Blocks are small enough for all processors to have some, and large enough that their borders do not matter.
int block_steps(const HeightField& heights, int64_t max_triangles) {
  constexpr int kSmallest = 512, kTriangles = 4000;
  int steps = kSmallest;
  while (max_triangles > 0 && pieces(heights, steps) > std::max<int64_t>(1, max_triangles / kTriangles) &&
         steps < BlockFit::kMostSteps)
    steps += steps / 4;
  return std::min(steps, BlockFit::kMostSteps);
}

}  // namespace

CellBox TileCuts::box(int column, int row) const {
  const auto i = static_cast<size_t>(column), j = static_cast<size_t>(row);
  return {{columns[i], rows[j]}, {columns[i + 1], rows[j + 1]}};
}

std::vector<int> even_cuts(int last, int parts) {
  std::vector<int> cuts(static_cast<size_t>(parts) + 1);
  for (size_t k = 0; k < cuts.size(); ++k) cuts[k] = static_cast<int>(static_cast<int64_t>(k) * last / parts);
  return cuts;
}

TerrainFit::TerrainFit(const HeightField& heights, const MeshDomain& domain, TileCuts tiles,
                       const TerrainFitOptions& options)
    : heights_(heights),
      domain_(domain),
      tiles_(std::move(tiles)),
      options_(options),
      lattice_(lattice_steps(heights, options.max_triangles)) {
  const int block = block_steps(heights, options.max_triangles);
  columns_ = divided(tiles_.columns, block);
  rows_ = divided(tiles_.rows, block);
  for (size_t j = 1; j < rows_.size(); ++j) {
    for (size_t i = 1; i < columns_.size(); ++i)
      blocks_.emplace_back(heights_, domain_, CellBox{{columns_[i - 1], rows_[j - 1]}, {columns_[i], rows_[j]}});
  }
  add_edges();
}

void TerrainFit::add_edges() {
  const auto across = static_cast<int>(columns_.size()) - 1, down = static_cast<int>(rows_.size()) - 1;
  const auto add = [&](LatticePoint from, LatticePoint to, bool between, std::initializer_list<LatticePoint> beside) {
    Edge edge{.fit = EdgeFit(heights_, domain_, from, to), .between_tiles = between};
    for (const auto [i, j] : beside) {
      if (i >= 0 && j >= 0 && i < across && j < down) edge.blocks.push_back(j * across + i);
    }
    edges_.push_back(std::move(edge));
  };
  const auto column = [&](int i) { return columns_[static_cast<size_t>(i)]; };
  const auto row = [&](int j) { return rows_[static_cast<size_t>(j)]; };
  for (int j = 0; j <= down; ++j) {
    for (int i = 0; i < across; ++i)
      add({column(i), row(j)}, {column(i + 1), row(j)}, is_on(tiles_.rows, row(j)), {{i, j - 1}, {i, j}});
  }
  for (int j = 0; j < down; ++j) {
    for (int i = 0; i <= across; ++i)
      add({column(i), row(j)}, {column(i), row(j + 1)}, is_on(tiles_.columns, column(i)), {{i - 1, j}, {i, j}});
  }
}

/// The highest and the lowest cell, the first ones in reading order.
std::vector<LatticePoint> TerrainFit::extremes() const {
  float low = std::numeric_limits<float>::infinity(), high = -low;
  LatticePoint lowest, highest;
  for (int y = 0; y < heights_.height(); ++y) {
    for (int x = 0; x < heights_.width(); ++x) {
      const float z = heights_(x, y);
      if (z < low && domain_.holds({x, y})) low = z, lowest = {x, y};
      if (z > high && domain_.holds({x, y})) high = z, highest = {x, y};
    }
  }
  return {lowest, highest};
}

void TerrainFit::start(std::span<const LatticePoint> borders, const RunContext& run) {
  const std::vector<LatticePoint> peaks = extremes();
  const std::vector<int> lattice_x = divided(columns_, lattice_), lattice_y = divided(rows_, lattice_);
  for (Edge& edge : edges_) {
    const CellBox box{edge.fit.from(), edge.fit.to()};
    std::vector<LatticePoint> cells;
    const bool frozen = edge.between_tiles && !borders.empty();
    const auto take = [&](LatticePoint p) {
      if (holds(box, p) && domain_.holds(p)) cells.push_back(p);
    };
    if (frozen) {
      for (const LatticePoint p : borders) take(p);
    } else {
      for (const int x : lattice_x) take({x, box.first.y});
      for (const int y : lattice_y) take({box.first.x, y});
      for (const LatticePoint p : peaks) take(p);
    }
    edge.fit.start(std::move(cells), frozen);
    edge.given = edge.fit.vertices().size();
  }
  parallel_blocks(run, static_cast<int64_t>(blocks_.size()), 1, [&](int64_t b, int64_t) {
    BlockFit& block = blocks_[static_cast<size_t>(b)];
    const CellBox box = block.box();
    const CellBox inner{{box.first.x + 1, box.first.y + 1}, {box.last.x - 1, box.last.y - 1}};
    std::vector<LatticePoint> cells;
    for (const Edge& edge : edges_) {
      if (std::find(edge.blocks.begin(), edge.blocks.end(), b) == edge.blocks.end()) continue;
      cells.insert(cells.end(), edge.fit.vertices().begin(), edge.fit.vertices().end());
    }
    for (const int y : lattice_y) {
      for (const int x : lattice_x) {
        if (holds(inner, {x, y}) && domain_.holds({x, y})) cells.push_back({x, y});
      }
    }
    for (const LatticePoint p : peaks) {
      if (holds(inner, p)) cells.push_back(p);
    }
    for (int y = inner.first.y; y <= inner.last.y && !domain_.is_whole(); ++y) {
      for (int x = inner.first.x; x <= inner.last.x; ++x) {
        if (domain_.is_rim({x, y})) cells.push_back({x, y});
      }
    }
    block.start(std::move(cells));
  });
}

int64_t TerrainFit::count() const {
  int64_t count = 0;
  for (const BlockFit& block : blocks_) count += block.triangle_count();
  return count;
}

/// One round of all blocks towards a smaller error. False if there is nothing left to do, or little.
bool TerrainFit::refine_once(const RunContext& run) {
  constexpr int64_t kAny = std::numeric_limits<int64_t>::max() / 4;
  const int64_t before = count(), most = options_.max_triangles > 0 ? options_.max_triangles : kAny;
  const double worst = this->worst();
  const auto parts = static_cast<int64_t>(blocks_.size() + edges_.size());
  const int64_t kept = std::max(most / 100, 2 * parts);  // for finish()
  if (worst <= options_.max_error_m || most - before <= 2 * kept) return false;
  // Triangles grow about as the error shrinks. All get to the same error, but none may take what others need.
  double aim = options_.max_error_m;
  if (options_.max_triangles > 0)
    aim = std::max(aim, worst * std::clamp(1.2 * static_cast<double>(before) / static_cast<double>(most), 0.5, 0.95));
  const auto share = [&](const auto& all, int64_t triangles, const auto& error) {
    const auto active = std::count_if(all.begin(), all.end(), [&](const auto& one) { return error(one) > aim; });
    return triangles / std::max<int64_t>(1, active);
  };
  const int64_t edge_share = share(edges_, (most - kept - before) / 8, [](const Edge& e) { return e.fit.error_m(); });
  for (Edge& edge : edges_) edge.fit.refine(aim, std::max<int64_t>(1, edge_share));
  parallel_blocks(run, static_cast<int64_t>(blocks_.size()), 1, [&](int64_t b, int64_t) {
    for (const Edge& edge : edges_) {
      if (std::find(edge.blocks.begin(), edge.blocks.end(), b) == edge.blocks.end()) continue;
      blocks_[static_cast<size_t>(b)].insert(std::span(edge.fit.vertices()).subspan(edge.given));
    }
  });
  for (Edge& edge : edges_) edge.given = edge.fit.vertices().size();
  const int64_t block_share =
      share(blocks_, most - kept - count(), [](const BlockFit& block) { return block.error_m(); });
  parallel_blocks(run, static_cast<int64_t>(blocks_.size()), 1, [&](int64_t b, int64_t) {
    BlockFit& block = blocks_[static_cast<size_t>(b)];
    block.refine(aim, block.triangle_count() + block_share);
  });
  return true;
}

double TerrainFit::worst() const {
  double worst = 0.0;
  for (const Edge& edge : edges_) worst = std::max(worst, edge.fit.error_m());
  for (const BlockFit& block : blocks_) worst = std::max(worst, block.error_m());
  return worst;
}

/// One more vertex, where the error is largest. False if it is small enough.
bool TerrainFit::add_worst() {
  const auto block = std::max_element(blocks_.begin(), blocks_.end(),
                                      [](const BlockFit& a, const BlockFit& b) { return a.error_m() < b.error_m(); });
  const auto edge = std::max_element(edges_.begin(), edges_.end(),
                                     [](const Edge& a, const Edge& b) { return a.fit.error_m() < b.fit.error_m(); });
  if (std::max(block->error_m(), edge->fit.error_m()) <= options_.max_error_m) return false;
  if (block->error_m() >= edge->fit.error_m()) {
    block->refine(options_.max_error_m, block->triangle_count() + 2);
  } else {
    edge->fit.refine(options_.max_error_m, 1);
    for (const int b : edge->blocks) blocks_[static_cast<size_t>(b)].insert(std::span(edge->fit.vertices()).last(1));
  }
  return true;
}

/// The last vertices, the worst first. A new vertex turns edges, which may make some place worse than all others were:
/// of the last states the best is taken.
void TerrainFit::finish(const RunContext& run) {
  const int64_t most = options_.max_triangles, last = std::min<int64_t>(64, most / 200);
  while (count() + 2 <= most - 2 * last) {
    run.check_cancelled();
    if (!add_worst()) return;
  }
  std::vector<BlockFit> blocks = blocks_;
  std::vector<Edge> edges = edges_;
  double least = worst();
  int added = 0, best = 0;
  while (count() + 2 <= most && add_worst()) {
    ++added;
    if (worst() > least) continue;
    least = worst();
    best = added;
  }
  if (best == added) return;
  blocks_.swap(blocks);
  edges_.swap(edges);
  for (int i = 0; i < best; ++i) add_worst();
}

void TerrainFit::refine(std::span<const LatticePoint> borders, const RunContext& run) {
  RunContext quiet = run;  // a round knows nothing of the whole
  quiet.progress = nullptr;
  start(borders, quiet);
  for (bool more = true; more;) {
    run.check_cancelled();
    more = refine_once(quiet);
    if (options_.max_triangles > 0)
      run.report(std::min(1.0, static_cast<double>(count()) / static_cast<double>(options_.max_triangles)));
  }
  if (options_.max_triangles > 0) finish(run);
}

std::vector<LatticePoint> TerrainFit::border_vertices() const {
  std::vector<LatticePoint> vertices;
  for (const Edge& edge : edges_) {
    if (edge.between_tiles) vertices.insert(vertices.end(), edge.fit.vertices().begin(), edge.fit.vertices().end());
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

CellMesh TerrainFit::tile(int column, int row, const RunContext& run) const {
  const CellBox box = tiles_.box(column, row);
  std::vector<const BlockFit*> blocks;
  for (const BlockFit& block : blocks_) {
    if (holds(box, block.box().first) && holds(box, block.box().last)) blocks.push_back(&block);
  }
  CellMesh mesh;
  const auto key = [](LatticePoint p) {
    return uint64_t{static_cast<uint32_t>(p.y)} << 32 | static_cast<uint32_t>(p.x);
  };
  std::unordered_map<uint64_t, uint32_t> numbers;
  for (const BlockFit* block : blocks) {
    block->for_each_triangle([&](LatticePoint a, LatticePoint b, LatticePoint c) {
      for (const LatticePoint p : {a, b, c}) {
        const auto [at, is_new] = numbers.emplace(key(p), static_cast<uint32_t>(mesh.cells.size()));
        if (is_new) mesh.cells.push_back(p);
        mesh.corners.push_back(at->second);
      }
    });
  }
  std::vector<SurfaceError> errors(blocks.size());
  parallel_blocks(run, static_cast<int64_t>(blocks.size()), 1, [&](int64_t b, int64_t) {
    errors[static_cast<size_t>(b)] = blocks[static_cast<size_t>(b)]->measure(box);
  });
  for (const SurfaceError& error : errors) mesh.error.add(error);
  return mesh;
}

}  // namespace seamount::geom
