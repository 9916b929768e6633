#include "seamount/geom/tin/tin_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/geom/solve/extrapolation.h"
#include "seamount/geom/tin/tin_border.h"

namespace seamount::geom {
namespace {

constexpr int kBand = 16;       ///< rows, the unit of parallel work
constexpr double kFall = 0.04;  ///< of the ground beyond the network

struct Corner {
  double x, y;  ///< in cells, row 0 north
  double z;
};

std::array<Corner, 3> corners_of(const Tin& tin, size_t triangle, const GridFrame& frame) {
  std::array<Corner, 3> corners;
  for (size_t i = 0; i < 3; ++i) {
    const auto node = static_cast<size_t>(tin.triangles[triangle][i]);
    corners[i] = {frame.column(tin.nodes[node].x), frame.row(tin.nodes[node].y), tin.height_m[node]};
  }
  return corners;
}

struct Rows {
  int first, last;
};
Rows rows_of(const std::array<Corner, 3>& t, int low, int high) {
  const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
  return {static_cast<int>(std::clamp(std::ceil(top), static_cast<double>(low), high + 1.0)),
          static_cast<int>(std::clamp(std::floor(bottom), low - 1.0, static_cast<double>(high)))};
}

/// Centres within the triangle, borders included, so that no gap opens between neighbours.
void fill_triangle(const std::array<Corner, 3>& t, const Rows& rows, HeightField& heights) {
  const double area = (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[2].x - t[0].x) * (t[1].y - t[0].y);
  if (area == 0.0) return;
  for (int row = rows.first; row <= rows.last; ++row) {
    double west = std::numeric_limits<double>::infinity();
    double east = -west;
    for (size_t i = 0; i < 3; ++i) {
      const Corner& a = t[i];
      const Corner& b = t[(i + 1) % 3];
      if (std::min(a.y, b.y) > row || std::max(a.y, b.y) < row) continue;
      const double x = a.y == b.y ? a.x : a.x + (b.x - a.x) * std::clamp((row - a.y) / (b.y - a.y), 0.0, 1.0);
      west = std::min({west, x, a.y == b.y ? b.x : x});
      east = std::max({east, x, a.y == b.y ? b.x : x});
    }
    constexpr double kSlack = 1e-9;
    const double first = std::max(0.0, std::ceil(west - kSlack));
    const double last = std::min(heights.width() - 1.0, std::floor(east + kSlack));
    for (double x = first; x <= last; ++x) {
      double u = ((x - t[0].x) * (t[2].y - t[0].y) - (t[2].x - t[0].x) * (row - t[0].y)) / area;
      double v = ((t[1].x - t[0].x) * (row - t[0].y) - (x - t[0].x) * (t[1].y - t[0].y)) / area;
      u = std::clamp(u, 0.0, 1.0);
      v = std::clamp(v, 0.0, 1.0 - u);
      heights(static_cast<int>(x), row) = static_cast<float>(t[0].z + u * (t[1].z - t[0].z) + v * (t[2].z - t[0].z));
    }
  }
}

}  // namespace

HeightField rasterise_tin(const Tin& tin, const GridFrame& frame, const RunContext& run) {
  const int bands = (frame.height + kBand - 1) / kBand;
  std::vector<std::vector<uint32_t>> members(static_cast<size_t>(bands));
  for (size_t i = 0; i < tin.triangles.size(); ++i) {
    if (i % 16384 == 0) run.check_cancelled();
    const Rows rows = rows_of(corners_of(tin, i, frame), 0, frame.height - 1);
    for (int band = rows.first / kBand; band * kBand <= rows.last; ++band)
      members[static_cast<size_t>(band)].push_back(static_cast<uint32_t>(i));
  }
  HeightField heights(frame, std::nanf(""));
  parallel_blocks(run, bands, 1, [&](int64_t begin, int64_t end) {
    for (int64_t band = begin; band < end; ++band) {
      const int low = static_cast<int>(band) * kBand;
      const int high = std::min(low + kBand, frame.height) - 1;
      for (const uint32_t i : members[static_cast<size_t>(band)]) {
        const std::array<Corner, 3> corners = corners_of(tin, i, frame);
        fill_triangle(corners, rows_of(corners, low, high), heights);
      }
    }
  });
  const std::span<float> cells = heights.cells();
  if (std::none_of(cells.begin(), cells.end(), [](float z) { return std::isnan(z); })) return heights;
  Grid<uint8_t> covered(frame);
  std::transform(cells.begin(), cells.end(), covered.cells().begin(), [](float z) { return std::isnan(z) ? 0 : 1; });
  if (std::all_of(cells.begin(), cells.end(), [](float z) { return std::isnan(z); }))
    throw IncompatibleInputs("the network's triangles cover no cell of the terrain");
  extrapolate_ground(heights, covered, kFall, run);
  return heights;
}

std::vector<int32_t> find_low_nodes(const Tin& tin, const RunContext& run) {
  std::vector<char> drains(tin.nodes.size(), 0);
  std::vector<char> used(tin.nodes.size(), 0);
  size_t done = 0;
  for (const std::array<int32_t, 3>& t : tin.triangles) {
    if (++done % 65536 == 0) run.check_cancelled();
    for (size_t i = 0; i < 3; ++i) {
      const auto here = static_cast<size_t>(t[i]);
      used[here] = 1;
      for (const size_t k : {(i + 1) % 3, (i + 2) % 3})
        if (tin.height_m[static_cast<size_t>(t[k])] < tin.height_m[here]) drains[here] = 1;
    }
  }
  for (const std::vector<int32_t>& ring : border_rings(tin, run))
    for (const int32_t node : ring) drains[static_cast<size_t>(node)] = 1;
  std::vector<int32_t> low;
  for (size_t i = 0; i < drains.size(); ++i)
    if (used[i] != 0 && drains[i] == 0) low.push_back(static_cast<int32_t>(i));
  return low;
}

}  // namespace seamount::geom
