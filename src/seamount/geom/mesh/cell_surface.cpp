#include "seamount/geom/mesh/cell_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "seamount/base/parallel.h"
#include "seamount/geom/tin/delaunay.h"

namespace seamount::geom {
namespace {

/// Rise of the terrain per metre between the known ones of two cells beside a cell, seen from the first to the second.
double slope(const HeightField& heights, LatticePoint cell, LatticePoint first, LatticePoint last) {
  const auto known = [&](LatticePoint p) { return heights.contains(p.x, p.y) && !std::isnan(heights(p.x, p.y)); };
  if (!known(first)) first = cell;
  if (!known(last)) last = cell;
  const int steps = std::abs(last.x - first.x) + std::abs(last.y - first.y);
  if (steps == 0) return 0.0;
  return (double{heights(last.x, last.y)} - heights(first.x, first.y)) / (steps * heights.cell_m());
}

using Steps = std::vector<std::pair<uint32_t, uint32_t>>;

/// Edges of one triangle only, in its direction: the surface lies to their left.
Steps border_steps(const std::vector<uint32_t>& corners) {
  Steps steps;
  steps.reserve(corners.size());
  for (size_t i = 0; i < corners.size(); i += 3)
    for (size_t k = 0; k < 3; ++k) steps.emplace_back(corners[i + k], corners[i + (k + 1) % 3]);
  std::sort(steps.begin(), steps.end());
  Steps border;
  for (const auto& [from, to] : steps)
    if (!std::binary_search(steps.begin(), steps.end(), std::pair(to, from))) border.emplace_back(from, to);
  return border;
}

class PartBuilder {
 public:
  explicit PartBuilder(MeshPart& part) : part_(part) {}
  uint32_t add(std::array<float, 3> position, std::array<float, 3> normal, float u, float v) {
    part_.positions.insert(part_.positions.end(), position.begin(), position.end());
    part_.normals.insert(part_.normals.end(), normal.begin(), normal.end());
    part_.uvs.insert(part_.uvs.end(), {u, v});
    return static_cast<uint32_t>(part_.vertex_count() - 1);
  }

 private:
  MeshPart& part_;
};

void add_walls(MeshPart& ground, const Steps& border, float floor_z) {
  PartBuilder builder(ground);
  for (const auto& [a, b] : border) {
    const auto at = [&](uint32_t v) { return &ground.positions[3 * size_t{v}]; };
    const std::array<float, 3> top_a{at(a)[0], at(a)[1], at(a)[2]}, top_b{at(b)[0], at(b)[1], at(b)[2]};
    const float dx = top_b[0] - top_a[0], dy = top_b[1] - top_a[1], length = std::hypot(dx, dy);
    const std::array<float, 3> out{dy / length, -dx / length, 0};
    const auto wall = [&](const std::array<float, 3>& top, float z, uint32_t v) {
      return builder.add({top[0], top[1], z}, out, ground.uvs[2 * size_t{v}], ground.uvs[2 * size_t{v} + 1]);
    };
    const std::array<uint32_t, 4> corners{wall(top_a, top_a[2], a), wall(top_a, floor_z, a), wall(top_b, floor_z, b),
                                          wall(top_b, top_b[2], b)};
    for (const size_t corner : {0, 1, 2, 0, 2, 3}) ground.indices.push_back(corners[corner]);
  }
}

/// The border's cells and a wide lattice between them, which keeps triangles from being needles.
std::vector<LatticePoint> floor_cells(const CellMesh& mesh, const Steps& border, const MeshDomain& domain) {
  std::vector<LatticePoint> cells;
  for (const auto& [from, to] : border) cells.push_back(mesh.cells[from]);
  const auto [west, east] = std::minmax_element(cells.begin(), cells.end());
  const auto [north, south] =
      std::minmax_element(cells.begin(), cells.end(), [](LatticePoint a, LatticePoint b) { return a.y < b.y; });
  const int x0 = west->x, y0 = north->y, across = east->x - x0, down = south->y - y0;
  const int steps = std::max({4, across / 64, down / 64});
  for (int y = y0 + steps; y < y0 + down; y += steps) {
    for (int x = x0 + steps; x < x0 + across; x += steps) {
      if (domain.holds({x, y})) cells.push_back({x, y});
    }
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

}  // namespace

CellMesh every_cell(const HeightField& heights, const MeshDomain& domain, const CellBox& box) {
  CellMesh mesh;
  const int across = box.last.x - box.first.x + 1, down = box.last.y - box.first.y + 1;
  std::vector<uint32_t> number(static_cast<size_t>(across) * static_cast<size_t>(down), 0);
  for (int y = box.first.y; y <= box.last.y; ++y) {
    for (int x = box.first.x; x <= box.last.x; ++x) {
      if (!domain.holds({x, y})) continue;
      number[static_cast<size_t>(y - box.first.y) * static_cast<size_t>(across) +
             static_cast<size_t>(x - box.first.x)] = static_cast<uint32_t>(mesh.cells.size());
      mesh.cells.push_back({x, y});
    }
  }
  const auto add = [&](LatticePoint a, LatticePoint b, LatticePoint c) {
    for (const LatticePoint p : {a, b, c})
      mesh.corners.push_back(number[static_cast<size_t>(p.y - box.first.y) * static_cast<size_t>(across) +
                                    static_cast<size_t>(p.x - box.first.x)]);
  };
  for (int y = box.first.y; y < box.last.y; ++y) {
    for (int x = box.first.x; x < box.last.x; ++x) {
      const LatticePoint nw{x, y}, ne{x + 1, y}, sw{x, y + 1}, se{x + 1, y + 1};
      switch (domain.square(x, y)) {
        case MeshSquare::none:
          break;
        case MeshSquare::whole:
          if (std::abs(heights(x, y) - heights(x + 1, y + 1)) <= std::abs(heights(x + 1, y) - heights(x, y + 1))) {
            add(nw, sw, se);
            add(nw, se, ne);
          } else {
            add(nw, sw, ne);
            add(ne, sw, se);
          }
          break;
        case MeshSquare::without_nw:
          add(ne, sw, se);
          break;
        case MeshSquare::without_ne:
          add(nw, sw, se);
          break;
        case MeshSquare::without_sw:
          add(nw, se, ne);
          break;
        case MeshSquare::without_se:
          add(nw, sw, ne);
          break;
      }
    }
  }
  mesh.error.cells = static_cast<int64_t>(mesh.cells.size());
  return mesh;
}

CellPlaces::CellPlaces(const GridFrame& frame, LatticePoint first)
    : width_(0.5 * (frame.width - 1) - first.x),
      height_(0.5 * (frame.height - 1) - first.y),
      cell_m_(frame.cell_m),
      unit_(std::exp2(std::ceil(std::log2(0.5 * (std::max(frame.width, frame.height) - 1) * cell_m_)) - 24)) {}

double CellPlaces::x(double column) const { return std::round((column - width_) * cell_m_ / unit_) * unit_; }
double CellPlaces::y(double row) const { return std::round((height_ - row) * cell_m_ / unit_) * unit_; }

MeshPart surface(const CellMesh& mesh, const HeightField& heights, double vertical_scale, const CellPlaces& places,
                 Vec2 offset, const RunContext& run) {
  MeshPart part;
  part.indices = mesh.corners;
  part.positions.resize(3 * mesh.cells.size());
  part.normals.resize(3 * mesh.cells.size());
  part.uvs.resize(2 * mesh.cells.size());
  constexpr int64_t kGrain = 1 << 14;
  parallel_blocks(run, static_cast<int64_t>(mesh.cells.size()), kGrain, [&](int64_t begin, int64_t end) {
    for (auto v = static_cast<size_t>(begin); v < static_cast<size_t>(end); ++v) {
      const auto [x, y] = mesh.cells[v];
      part.positions[3 * v] = static_cast<float>(places.x(x) - offset.x);
      part.positions[3 * v + 1] = static_cast<float>(places.y(y) - offset.y);
      part.positions[3 * v + 2] = static_cast<float>(heights(x, y) * vertical_scale);
      const double slope_x = slope(heights, {x, y}, {x - 1, y}, {x + 1, y}) * vertical_scale;
      const double slope_y = slope(heights, {x, y}, {x, y + 1}, {x, y - 1}) * vertical_scale;
      const double length = std::sqrt(slope_x * slope_x + slope_y * slope_y + 1.0);
      part.normals[3 * v] = static_cast<float>(-slope_x / length);
      part.normals[3 * v + 1] = static_cast<float>(-slope_y / length);
      part.normals[3 * v + 2] = static_cast<float>(1.0 / length);
      part.uvs[2 * v] = static_cast<float>((x + 0.5) / heights.width());
      part.uvs[2 * v + 1] = static_cast<float>((y + 0.5) / heights.height());
    }
  });
  return part;
}

void close_below(MeshPart& ground, const CellMesh& mesh, const MeshDomain& domain, const CellPlaces& places,
                 Vec2 offset, float floor_z, const RunContext& run) {
  ground.hard_edges = true;
  const Steps border = border_steps(mesh.corners);
  const std::vector<LatticePoint> cells = floor_cells(mesh, border, domain);
  add_walls(ground, border, floor_z);
  const auto first = static_cast<uint32_t>(ground.vertex_count());
  PartBuilder builder(ground);
  for (const LatticePoint p : cells) {
    builder.add({static_cast<float>(places.x(p.x) - offset.x), static_cast<float>(places.y(p.y) - offset.y), floor_z},
                {0, 0, -1}, static_cast<float>((p.x + 0.5) / domain.width()),
                static_cast<float>((p.y + 0.5) / domain.height()));
  }
  // Counter-clockwise in columns and rows is clockwise seen from above: to face down.
  for (const auto& [a, b, c] : delaunay(cells, run)) {
    const auto cell = [&](int32_t i) { return cells[static_cast<size_t>(i)]; };
    if (!domain.holds_triangle(cell(a), cell(b), cell(c))) continue;
    for (const int32_t corner : {a, b, c}) ground.indices.push_back(first + static_cast<uint32_t>(corner));
  }
}

}  // namespace seamount::geom
