#include "seamount/geom/mesh/window_mesh.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/geom/mesh/cell_surface.h"

namespace seamount::geom {
namespace {

constexpr int kLattice = 64;  ///< steps between vertices that every border has

void check(const TerrainWindow& window, const WindowMeshOptions& options) {
  if (!(options.max_error_m >= 0) || !std::isfinite(options.max_error_m))
    throw InvalidArgument("max_error_m", "is negative");
  if (options.levels < 1) throw InvalidArgument("lods", "is below 1");
  if (!(options.vertical_scale > 0) || !std::isfinite(options.vertical_scale))
    throw InvalidArgument("vertical_scale", format_number(options.vertical_scale) + " is not above 0");
  for (const float z : window.heights.cells())
    if (!std::isfinite(z)) throw InvalidArgument("heights", "a cell has no height");
}

/// The profiles along the tile's four sides, each simplified alone.
std::vector<LatticePoint> border_vertices(const HeightField& heights, const MeshDomain& domain, const CellBox& box,
                                          double error_m) {
  std::vector<LatticePoint> all;
  const auto add = [&](LatticePoint from, LatticePoint to) {
    std::vector<LatticePoint> lattice;
    for (int x = from.x + kLattice; x < to.x; x += kLattice) lattice.push_back({x, from.y});
    for (int y = from.y + kLattice; y < to.y; y += kLattice) lattice.push_back({from.x, y});
    EdgeFit edge(heights, domain, from, to);
    edge.start(std::move(lattice), false);
    edge.refine(error_m, int64_t{heights.width()} + heights.height());
    all.insert(all.end(), edge.vertices().begin(), edge.vertices().end());
  };
  const LatticePoint a = box.first, b = box.last;
  add(a, {b.x, a.y});
  add({a.x, b.y}, b);
  add(a, {a.x, b.y});
  add({b.x, a.y}, b);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// All cells along the sides, for a finest level that has every cell.
std::vector<LatticePoint> border_cells(const CellBox& box) {
  std::vector<LatticePoint> all;
  for (int x = box.first.x; x <= box.last.x; ++x) all.insert(all.end(), {{x, box.first.y}, {x, box.last.y}});
  for (int y = box.first.y; y <= box.last.y; ++y) all.insert(all.end(), {{box.first.x, y}, {box.last.x, y}});
  return all;
}

constexpr int kFarthest = 8;  ///< cells that a normal looks away at most

/// Half of the distance between a vertex and its neighbours: so far around it the cells are its own.
int reach_for(double steps) { return std::clamp(static_cast<int>(std::lround(0.5 * steps)), 1, kFarthest); }

bool is_on(const CellBox& box, LatticePoint p) {
  return p.x == box.first.x || p.x == box.last.x || p.y == box.first.y || p.y == box.last.y;
}

/// Of vertices on a tile's border, from those before and after them along it, which the neighbour knows too.
std::map<LatticePoint, int> border_reaches(const std::vector<LatticePoint>& borders, const CellBox& box) {
  std::map<LatticePoint, int> reaches;
  const auto along = [&](const auto& on_side) {
    std::vector<LatticePoint> side;
    std::copy_if(borders.begin(), borders.end(), std::back_inserter(side), on_side);
    for (size_t i = 1; i + 1 < side.size(); ++i) {
      const LatticePoint before = side[i - 1], after = side[i + 1];
      reaches[side[i]] = reach_for(0.5 * (after.x - before.x + after.y - before.y));
    }
  };
  along([&](LatticePoint p) { return p.x == box.first.x; });
  along([&](LatticePoint p) { return p.x == box.last.x; });
  along([&](LatticePoint p) { return p.y == box.first.y; });
  along([&](LatticePoint p) { return p.y == box.last.y; });
  return reaches;
}

/// How many cells away each vertex's normal looks.
std::vector<int> reaches_of(const CellMesh& mesh, const CellBox& box, const std::vector<LatticePoint>& borders) {
  constexpr int kAtCorners = 2;  // where four tiles meet, of which each knows two sides
  std::vector<double> length(mesh.cells.size(), 0.0);
  std::vector<int> count(mesh.cells.size(), 0), reaches(mesh.cells.size());
  for (size_t i = 0; i < mesh.corners.size(); i += 3) {
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t a = mesh.corners[i + k], b = mesh.corners[i + (k + 1) % 3];
      const double steps = std::hypot(mesh.cells[a].x - mesh.cells[b].x, mesh.cells[a].y - mesh.cells[b].y);
      length[a] += steps, ++count[a];
      length[b] += steps, ++count[b];
    }
  }
  const std::map<LatticePoint, int> shared = border_reaches(borders, box);
  for (size_t v = 0; v < reaches.size(); ++v) {
    const auto found = shared.find(mesh.cells[v]);
    reaches[v] = !is_on(box, mesh.cells[v]) ? reach_for(length[v] / std::max(1, count[v]))
                 : found != shared.end()    ? found->second
                                            : kAtCorners;
  }
  return reaches;
}

/// Rise per metre to the east and to the south of the plane that is nearest to the cells up to `reach` away.
Vec2 slopes(const HeightField& heights, LatticePoint cell, int reach) {
  const int x0 = std::max(0, cell.x - reach), x1 = std::min(heights.width() - 1, cell.x + reach);
  const int y0 = std::max(0, cell.y - reach), y1 = std::min(heights.height() - 1, cell.y + reach);
  const double middle_x = 0.5 * (x0 + x1), middle_y = 0.5 * (y0 + y1);
  double x_sum = 0, y_sum = 0, x_squares = 0, y_squares = 0;
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      const double z = double{heights(x, y)} - heights(cell.x, cell.y), dx = x - middle_x, dy = y - middle_y;
      x_sum += dx * z, x_squares += dx * dx;
      y_sum += dy * z, y_squares += dy * dy;
    }
  }
  return {x_sum / (x_squares * heights.cell_m()), y_sum / (y_squares * heights.cell_m())};
}

void smooth_normals(MeshPart& ground, const CellMesh& cells, const HeightField& heights, double vertical_scale,
                    const std::vector<int>& reaches) {
  for (size_t v = 0; v < cells.cells.size(); ++v) {
    const Vec2 rise = slopes(heights, cells.cells[v], reaches[v]);
    const double east = rise.x * vertical_scale, south = rise.y * vertical_scale;
    const double length = std::sqrt(east * east + south * south + 1.0);
    ground.normals[3 * v] = static_cast<float>(-east / length);
    ground.normals[3 * v + 1] = static_cast<float>(south / length);
    ground.normals[3 * v + 2] = static_cast<float>(1.0 / length);
  }
}

Mesh mesh_of(const TerrainWindow& window, const CellMesh& cells, const CellBox& box,
             const std::vector<LatticePoint>& borders, const WindowMeshOptions& options, const RunContext& run) {
  const GridFrame& whole = window.whole;
  const CellPlaces places(whole, window.first);
  const Vec2 middle{places.x(0.5 * (box.first.x + box.last.x)), places.y(0.5 * (box.first.y + box.last.y))};
  Mesh mesh{.parts = {surface(cells, window.heights, options.vertical_scale, places, middle, run)},
            .origin = {whole.west_m + 0.5 * whole.width_m(), whole.north_m - 0.5 * whole.height_m()},
            .crs = whole.crs,
            .vertical_scale = options.vertical_scale,
            .offset = middle,
            .largest_error_m = cells.error.largest_m};
  if (cells.error.cells > 0)
    mesh.rms_error_m = std::sqrt(cells.error.square_sum / static_cast<double>(cells.error.cells));
  MeshPart& ground = mesh.parts[0];
  if (options.max_error_m > 0)
    smooth_normals(ground, cells, window.heights, options.vertical_scale, reaches_of(cells, box, borders));
  for (size_t v = 0; v < cells.cells.size(); ++v) {
    ground.uvs[2 * v] = static_cast<float>((window.first.x + cells.cells[v].x + 0.5) / whole.width);
    ground.uvs[2 * v + 1] = static_cast<float>((window.first.y + cells.cells[v].y + 0.5) / whole.height);
  }
  return mesh;
}

}  // namespace

std::pair<float, float> heights_of(const MeshPart& part) {
  std::pair<float, float> range{part.positions[2], part.positions[2]};
  for (size_t i = 2; i < part.positions.size(); i += 3) {
    range.first = std::min(range.first, part.positions[i]);
    range.second = std::max(range.second, part.positions[i]);
  }
  return range;
}

double level_error_m(const WindowMeshOptions& options, double cell_m, int level) {
  constexpr double kShare = 0.05;
  if (level == 0) return options.max_error_m;
  return std::ldexp(options.max_error_m > 0 ? options.max_error_m : kShare * cell_m, level);
}

CellBox cells_around(const CellBox& box, const GridFrame& whole, const WindowMeshOptions& options) {
  const int more = options.max_error_m == 0 ? 1 : kFarthest;
  return {{std::max(0, box.first.x - more), std::max(0, box.first.y - more)},
          {std::min(whole.width - 1, box.last.x + more), std::min(whole.height - 1, box.last.y + more)}};
}

std::vector<Mesh> window_meshes(const TerrainWindow& window, const CellBox& box, const WindowMeshOptions& options,
                                const RunContext& run) {
  check(window, options);
  const CellBox own{{box.first.x - window.first.x, box.first.y - window.first.y},
                    {box.last.x - window.first.x, box.last.y - window.first.y}};
  const MeshDomain domain(window.heights, run);
  const bool all = options.max_error_m == 0;
  const std::vector<LatticePoint> borders =
      all ? border_cells(own) : border_vertices(window.heights, domain, own, options.max_error_m);
  std::vector<Mesh> meshes;
  for (int level = 0; level < options.levels; ++level) {
    run.check_cancelled();
    if (all && level == 0) {
      meshes.push_back(mesh_of(window, every_cell(window.heights, domain, own), own, borders, options, run));
      continue;
    }
    TerrainFit fit(window.heights, domain, {{own.first.x, own.last.x}, {own.first.y, own.last.y}},
                   {.max_error_m = level_error_m(options, window.whole.cell_m, level)});
    fit.refine(borders, {.threads = run.threads, .cancelled = run.cancelled});
    meshes.push_back(mesh_of(window, fit.tile(0, 0, {.threads = run.threads}), own, borders, options, run));
  }
  return meshes;
}

}  // namespace seamount::geom
