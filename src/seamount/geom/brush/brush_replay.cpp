#include "seamount/geom/brush/brush_replay.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/scalar/blend.h"

namespace seamount::geom {
namespace {

constexpr int kBlock_cells = 8192;
constexpr int kFewestRows = 8;

void check_ring(const Ring& ring, const std::string& name) {
  if (ring.size() < 3)
    throw InvalidArgument(name, "has a ring of " + std::to_string(ring.size()) + " points; an area needs 3");
  for (const Vec2 p : ring)
    if (!(std::abs(p.x) <= 1e12 && std::abs(p.y) <= 1e12))
      throw InvalidArgument(name, "has a point that is no place: " + format_place(p));
}

Box bounds(const std::vector<Polygon>& polygons, const std::string& name) {
  Box box;
  for (const Polygon& polygon : polygons) {
    check_ring(polygon.outer, name);
    for (const Ring& hole : polygon.holes) check_ring(hole, name);
    const Box one = bounding_box(polygon.outer);
    if (box.empty()) box = one;
    box.low = {std::min(box.low.x, one.low.x), std::min(box.low.y, one.low.y)};
    box.high = {std::max(box.high.x, one.high.x), std::max(box.high.y, one.high.y)};
  }
  if (box.empty()) throw InvalidArgument(name, "has no polygon");
  return box;
}

}  // namespace

std::vector<BrushPath> brush_paths(std::span<const Brush* const> brushes, const GridFrame& frame,
                                   const std::string& name, const RunContext& run) {
  constexpr int64_t kAtATime = 16;
  std::vector<BrushPath> paths(brushes.size());
  parallel_blocks(run, static_cast<int64_t>(brushes.size()), kAtATime, [&](int64_t begin, int64_t end) {
    for (auto i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i)
      if (brushes[i] != nullptr) paths[i] = brush_path(*brushes[i], frame, name + "[" + std::to_string(i) + "]");
  });
  return paths;
}

void replay(const std::vector<BrushPath>& paths, size_t begin, size_t end, const GridFrame& frame,
            const RunContext& run, const std::function<void(size_t, int, int, std::span<const float>)>& draw) {
  int top = frame.height, bottom = 0;
  for (size_t i = begin; i < end; ++i) {
    const CellWindow window = cells_of(paths[i].box, frame);
    if (window.empty()) continue;
    top = std::min(top, window.top);
    bottom = std::max(bottom, window.bottom);
  }
  if (top >= bottom) return;
  parallel_blocks(run, bottom - top, std::max(kFewestRows, kBlock_cells / frame.width), [&](int64_t from, int64_t to) {
    BrushBand band;
    for (size_t i = begin; i < end; ++i) {
      run.check_cancelled();
      if (!band.read(paths[i], frame, top + static_cast<int>(from), top + static_cast<int>(to))) continue;
      band.each_row([&](int y, int x, std::span<const float> weights) { draw(i, y, x, weights); });
    }
  });
}

AreaWeights area_weights(const std::vector<Polygon>& polygons, double feather_m, const GridFrame& frame,
                         const std::string& name, const RunContext& run) {
  const Box box = bounds(polygons, name);
  AreaWeights out;
  out.window = cells_of(box, frame, feather_m + frame.cell_m);
  if (out.window.empty()) return out;
  out.weights = signed_distance(polygons, cells_frame(box, frame, feather_m + frame.cell_m), run);
  const auto cell = static_cast<float>(frame.cell_m), feather = static_cast<float>(feather_m);
  for (float& d : out.weights.cells())
    d = feather > cell ? 1.0F - smoothstep(d / feather) : std::clamp(0.5F - d / cell, 0.0F, 1.0F);
  return out;
}

}  // namespace seamount::geom
