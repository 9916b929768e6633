#include "seamount/geom/mesh/terrain_mesh.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/base/text.h"

namespace seamount::geom {
namespace {

void check_options(const HeightField& heights, const MeshOptions& options) {
  if (heights.width() < 2 || heights.height() < 2)
    throw InvalidArgument("heights", "a mesh needs at least 2 x 2 cells");
  for (const float z : heights.cells())
    if (!std::isfinite(z)) throw InvalidArgument("heights", "a cell is not finite");
  if (!(options.vertical_scale > 0) || !std::isfinite(options.vertical_scale))
    throw InvalidArgument("vertical_scale", format_number(options.vertical_scale) + " is not above 0");
  if (options.max_triangles < 0) throw InvalidArgument("max_triangles", "is negative");
  if (!(options.base_m >= 0) || !std::isfinite(options.base_m)) throw InvalidArgument("base_m", "is negative");
}

/// Every n-th index of [0, count), evenly, with both ends.
std::vector<int> thinned(int count, double factor) {
  const int kept = std::clamp(static_cast<int>(std::lround((count - 1) / factor)) + 1, 2, count);
  std::vector<int> indices(static_cast<size_t>(kept));
  for (int i = 0; i < kept; ++i)
    indices[static_cast<size_t>(i)] = static_cast<int>(static_cast<int64_t>(i) * (count - 1) / (kept - 1));
  return indices;
}

/// Positions, normals and texture coordinates of chosen columns and rows.
void place_vertices(MeshPart& mesh, const HeightField& heights, const std::vector<int>& columns,
                    const std::vector<int>& rows, double vertical_scale, const RunContext& run) {
  const size_t across = columns.size(), count = across * rows.size();
  mesh.positions.resize(3 * count);
  mesh.normals.resize(3 * count);
  mesh.uvs.resize(2 * count);
  const int width = heights.width(), height = heights.height();
  const double cell = heights.cell_m();
  parallel_rows(run, static_cast<int>(across), static_cast<int>(rows.size()), [&](int begin, int end) {
    for (int j = begin; j < end; ++j) {
      for (size_t i = 0; i < across; ++i) {
        const int x = columns[i], y = rows[static_cast<size_t>(j)];
        const size_t v = static_cast<size_t>(j) * across + i;
        mesh.positions[3 * v] = static_cast<float>((x - 0.5 * (width - 1)) * cell);
        mesh.positions[3 * v + 1] = static_cast<float>((0.5 * (height - 1) - y) * cell);
        mesh.positions[3 * v + 2] = static_cast<float>(heights(x, y) * vertical_scale);
        const int x0 = std::max(x - 1, 0), x1 = std::min(x + 1, width - 1);
        const int y0 = std::max(y - 1, 0), y1 = std::min(y + 1, height - 1);
        const double slope_x = (heights(x1, y) - heights(x0, y)) * vertical_scale / ((x1 - x0) * cell);
        const double slope_y = (heights(x, y0) - heights(x, y1)) * vertical_scale / ((y1 - y0) * cell);
        const double length = std::sqrt(slope_x * slope_x + slope_y * slope_y + 1.0);
        mesh.normals[3 * v] = static_cast<float>(-slope_x / length);
        mesh.normals[3 * v + 1] = static_cast<float>(-slope_y / length);
        mesh.normals[3 * v + 2] = static_cast<float>(1.0 / length);
        mesh.uvs[2 * v] = static_cast<float>((x + 0.5) / width);
        mesh.uvs[2 * v + 1] = static_cast<float>((y + 0.5) / height);
      }
    }
  });
}

/// Two triangles a cell, cut along the diagonal that is closer to level, which follows ridges and valleys.
void join_cells(MeshPart& mesh, size_t across, size_t down) {
  mesh.indices.reserve(6 * (across - 1) * (down - 1));
  const auto z = [&](size_t v) { return mesh.positions[3 * v + 2]; };
  for (size_t j = 0; j + 1 < down; ++j) {
    for (size_t i = 0; i + 1 < across; ++i) {
      const size_t nw = j * across + i, ne = nw + 1, sw = nw + across, se = sw + 1;
      const bool falling = std::abs(z(nw) - z(se)) <= std::abs(z(ne) - z(sw));
      const std::array<size_t, 6> corners =
          falling ? std::array{nw, sw, se, nw, se, ne} : std::array{nw, sw, ne, ne, sw, se};
      for (const size_t corner : corners) mesh.indices.push_back(static_cast<uint32_t>(corner));
    }
  }
}

/// Quadric simplification with the border locked, then only the vertices that are left.
void simplify(MeshPart& mesh, int64_t max_triangles) {
  const auto target = static_cast<size_t>(3 * max_triangles);
  if (mesh.indices.size() <= target) return;
  std::vector<uint32_t> fewer(mesh.indices.size());
  constexpr float kAnyError = 1.0F;  // relative to the mesh's extent: only the count matters
  fewer.resize(meshopt_simplify(fewer.data(), mesh.indices.data(), mesh.indices.size(), mesh.positions.data(),
                                mesh.vertex_count(), 3 * sizeof(float), target, kAnyError, meshopt_SimplifyLockBorder,
                                nullptr));
  constexpr uint32_t kUnused = UINT32_MAX;
  std::vector<uint32_t> place(mesh.vertex_count(), kUnused);
  for (const uint32_t v : fewer) place[v] = 0;
  uint32_t kept = 0;
  for (size_t v = 0; v < place.size(); ++v) {
    if (place[v] == kUnused) continue;
    for (size_t k = 0; k < 3; ++k) {
      mesh.positions[3 * kept + k] = mesh.positions[3 * v + k];
      mesh.normals[3 * kept + k] = mesh.normals[3 * v + k];
    }
    for (size_t k = 0; k < 2; ++k) mesh.uvs[2 * kept + k] = mesh.uvs[2 * v + k];
    place[v] = kept++;
  }
  mesh.positions.resize(3 * size_t{kept});
  mesh.normals.resize(3 * size_t{kept});
  mesh.uvs.resize(2 * size_t{kept});
  for (uint32_t& v : fewer) v = place[v];
  mesh.indices = std::move(fewer);
}

uint32_t add_vertex(MeshPart& mesh, std::array<float, 3> position, std::array<float, 3> normal, size_t uv_of) {
  mesh.positions.insert(mesh.positions.end(), position.begin(), position.end());
  mesh.normals.insert(mesh.normals.end(), normal.begin(), normal.end());
  const float u = mesh.uvs[2 * uv_of], v = mesh.uvs[2 * uv_of + 1];
  mesh.uvs.insert(mesh.uvs.end(), {u, v});
  return static_cast<uint32_t>(mesh.vertex_count() - 1);
}

/// Edges of one triangle only, in its direction: the surface lies to their left.
std::vector<std::pair<uint32_t, uint32_t>> border_edges(const std::vector<uint32_t>& indices) {
  std::vector<std::pair<uint32_t, uint32_t>> edges;
  for (size_t i = 0; i < indices.size(); i += 3)
    for (size_t k = 0; k < 3; ++k) edges.emplace_back(indices[i + k], indices[i + (k + 1) % 3]);
  std::sort(edges.begin(), edges.end());
  std::vector<std::pair<uint32_t, uint32_t>> border;
  for (const auto& [from, to] : edges)
    if (!std::binary_search(edges.begin(), edges.end(), std::pair(to, from))) border.emplace_back(from, to);
  return border;
}

/// Walls down from the border and a flat floor, so that the mesh encloses a volume.
void close_below(MeshPart& mesh, double floor_z) {
  const auto z = static_cast<float>(floor_z);
  const auto border = border_edges(mesh.indices);
  const uint32_t middle = add_vertex(mesh, {0, 0, z}, {0, 0, -1}, 0);
  for (const auto& [a, b] : border) {
    const auto at = [&](uint32_t v) {
      return std::array{mesh.positions[3 * v], mesh.positions[3 * v + 1], mesh.positions[3 * v + 2]};
    };
    const auto top_a = at(a), top_b = at(b);
    const float dx = top_b[0] - top_a[0], dy = top_b[1] - top_a[1], length = std::hypot(dx, dy);
    const std::array<float, 3> out{dy / length, -dx / length, 0}, down{0, 0, -1};
    const std::array<float, 3> foot_a{top_a[0], top_a[1], z}, foot_b{top_b[0], top_b[1], z};
    const uint32_t wall[] = {add_vertex(mesh, top_a, out, a), add_vertex(mesh, foot_a, out, a),
                             add_vertex(mesh, foot_b, out, b), add_vertex(mesh, top_b, out, b)};
    for (const int corner : {0, 1, 2, 0, 2, 3}) mesh.indices.push_back(wall[corner]);
    const uint32_t floor_b = add_vertex(mesh, foot_b, down, b), floor_a = add_vertex(mesh, foot_a, down, a);
    mesh.indices.insert(mesh.indices.end(), {floor_b, floor_a, middle});
  }
}

/// The rectangle of the terrain's centres at sea level.
MeshPart water_surface(const GridFrame& frame) {
  const auto x = static_cast<float>(0.5 * (frame.width - 1) * frame.cell_m);
  const auto y = static_cast<float>(0.5 * (frame.height - 1) * frame.cell_m);
  return {.material = MeshMaterial::water,
          .positions = {-x, y, 0, -x, -y, 0, x, -y, 0, x, y, 0},
          .normals = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1},
          .uvs = {},
          .indices = {0, 1, 2, 0, 2, 3}};
}

}  // namespace

Mesh make_mesh(const HeightField& heights, const MeshOptions& options, const RunContext& run) {
  check_options(heights, options);
  constexpr double kThinAbove = 6.0;  // simplification reads at most so many times the triangles that it shall leave
  const double triangles = 2.0 * (heights.width() - 1) * (heights.height() - 1);
  const double most = options.max_triangles > 0 ? kThinAbove * static_cast<double>(options.max_triangles) : triangles;
  const double factor = std::max(1.0, std::sqrt(triangles / most));
  const std::vector<int> columns = thinned(heights.width(), factor), rows = thinned(heights.height(), factor);
  const GridFrame& frame = heights.frame();
  const float lowest = *std::min_element(heights.cells().begin(), heights.cells().end());
  Mesh mesh{.parts = {{}},
            .origin = {frame.west_m + 0.5 * frame.width_m(), frame.north_m - 0.5 * frame.height_m()},
            .crs = frame.crs,
            .vertical_scale = options.vertical_scale};
  MeshPart& ground = mesh.parts[0];
  place_vertices(ground, heights, columns, rows, options.vertical_scale, run.part(0, 0.2));
  join_cells(ground, columns.size(), rows.size());
  run.check_cancelled();
  run.report(0.4);
  if (options.max_triangles > 0) simplify(ground, options.max_triangles);
  run.check_cancelled();
  run.report(0.9);
  if (options.base_m > 0) close_below(ground, lowest * options.vertical_scale - options.base_m);
  if (options.water && lowest < 0) mesh.parts.push_back(water_surface(frame));
  run.report(1.0);
  return mesh;
}

}  // namespace seamount::geom
