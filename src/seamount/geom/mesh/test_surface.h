// What a mesh is, found plainly from its positions, for tests.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/model/grid.h"
#include "seamount/model/mesh.h"

namespace seamount::geom {

using Corner = std::array<float, 3>;

inline Corner corner_of(const MeshPart& mesh, size_t index, Vec2 offset = {}) {
  const size_t v = 3 * size_t{mesh.indices[index]};
  return {mesh.positions[v] + static_cast<float>(offset.x), mesh.positions[v + 1] + static_cast<float>(offset.y),
          mesh.positions[v + 2]};
}

struct SurfaceFaults {
  int64_t facing_down = 0, without_area = 0, doubled_edges = 0, open_edges = 0, pinched_corners = 0;
  double plan_area = 0.0, volume = 0.0;
  double open_length = 0.0;  ///< of the open edges, seen from above
};

/// Of some meshes taken together; vertices in one place are one.
inline SurfaceFaults faults_of(const std::vector<const Mesh*>& meshes) {
  SurfaceFaults faults;
  std::vector<std::pair<Corner, Corner>> edges;
  for (const Mesh* mesh : meshes) {
    const MeshPart& part = mesh->parts.at(0);
    for (size_t i = 0; i < part.indices.size(); i += 3) {
      const Corner a = corner_of(part, i, mesh->offset), b = corner_of(part, i + 1, mesh->offset),
                   c = corner_of(part, i + 2, mesh->offset);
      const double area =
          0.5 * ((double{b[0]} - a[0]) * (double{c[1]} - a[1]) - (double{b[1]} - a[1]) * (double{c[0]} - a[0]));
      faults.facing_down += area < 0;
      faults.without_area += area == 0;
      faults.plan_area += area;
      faults.volume += (double{a[0]} * (double{b[1]} * c[2] - double{b[2]} * c[1]) -
                        double{a[1]} * (double{b[0]} * c[2] - double{b[2]} * c[0]) +
                        double{a[2]} * (double{b[0]} * c[1] - double{b[1]} * c[0])) /
                       6;
      for (const auto& edge : {std::pair{a, b}, {b, c}, {c, a}}) edges.push_back(edge);
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Corner> leaving;  // where open edges begin
  for (size_t i = 0; i < edges.size(); ++i) {
    const auto& [from, to] = edges[i];
    faults.doubled_edges += i > 0 && edges[i] == edges[i - 1];
    if (std::binary_search(edges.begin(), edges.end(), std::pair{to, from})) continue;
    ++faults.open_edges;
    faults.open_length += std::hypot(double{to[0]} - from[0], double{to[1]} - from[1]);
    leaving.push_back(from);
  }
  for (size_t i = 1; i < leaving.size(); ++i) faults.pinched_corners += leaving[i] == leaving[i - 1];
  return faults;
}

inline SurfaceFaults faults_of(const MeshPart& part) {
  const Mesh mesh{.parts = {part}, .origin = {}};
  return faults_of({&mesh});
}

/// How far each cell is from the mesh, NaN where it covers none: every triangle against every cell of its box.
inline Grid<double> errors_of(const MeshPart& mesh, const HeightField& heights, Vec2 offset = {}, double scale = 1.0) {
  Grid<double> errors(heights.frame(), std::nan(""));
  const double cell = heights.cell_m(), left = 0.5 * (heights.width() - 1), top = 0.5 * (heights.height() - 1);
  const auto column = [&](const Corner& p) { return static_cast<int64_t>(std::lround(p[0] / cell + left)); };
  const auto row = [&](const Corner& p) { return static_cast<int64_t>(std::lround(top - p[1] / cell)); };
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    std::array<int64_t, 3> x{}, y{};
    std::array<double, 3> z{};
    for (size_t k = 0; k < 3; ++k) {
      const Corner p = corner_of(mesh, i + k, offset);
      x[k] = column(p), y[k] = row(p), z[k] = double{p[2]} / scale;
    }
    const int64_t area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
    for (int64_t v = *std::min_element(y.begin(), y.end()); v <= *std::max_element(y.begin(), y.end()); ++v) {
      for (int64_t u = *std::min_element(x.begin(), x.end()); u <= *std::max_element(x.begin(), x.end()); ++u) {
        const int64_t wc = (x[1] - x[0]) * (v - y[0]) - (y[1] - y[0]) * (u - x[0]);
        const int64_t wb = (u - x[0]) * (y[2] - y[0]) - (v - y[0]) * (x[2] - x[0]);
        const int64_t wa = area - wb - wc;
        if (std::max({wa, wb, wc}) > 0 || area >= 0) continue;  // rows run south: all are negative inside
        const double plane =
            (static_cast<double>(wa) * z[0] + static_cast<double>(wb) * z[1] + static_cast<double>(wc) * z[2]) /
            static_cast<double>(area);
        const int cx = static_cast<int>(u), cy = static_cast<int>(v);
        errors(cx, cy) = std::abs(plane - double{heights(cx, cy)});
      }
    }
  }
  return errors;
}

/// A cone above the sea with rough cells, not symmetric in any way.
inline HeightField rough_cone(const GridFrame& frame, uint64_t seed = 1, double roughness_m = 20) {
  HeightField heights(frame);
  Rng rng(Seed{seed}.derive("terrain"));
  const double middle_x = rng.uniform(0.3, 0.7), middle_y = rng.uniform(0.3, 0.7);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const double r = std::hypot(x - middle_x * frame.width, y - middle_y * frame.height) / frame.width;
      heights(x, y) = static_cast<float>(900.0 - 2500.0 * r + 60 * std::sin(0.11 * x) * std::cos(0.07 * y) +
                                         rng.uniform(-roughness_m, roughness_m));
    }
  }
  return heights;
}

/// Holes: discs, and single cells at random.
inline void make_holes(HeightField& heights, uint64_t seed, double single_share) {
  Rng rng(Seed{seed}.derive("holes"));
  const int w = heights.width(), h = heights.height();
  for (int disc = 0; disc < 6; ++disc) {
    const double cx = rng.uniform(0, w), cy = rng.uniform(0, h), radius = rng.uniform(1, 0.15 * w);
    for (int y = 0; y < h; ++y)
      for (int x = 0; x < w; ++x)
        if (std::hypot(x - cx, y - cy) < radius) heights(x, y) = std::nanf("");
  }
  for (float& z : heights.cells())
    if (rng.uniform() < single_share) z = std::nanf("");
}

}  // namespace seamount::geom
