#include "seamount/ops/learned/sketch_guide.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/geom/polygon/distance.h"
#include "seamount/ops/learned/sketch_map.h"

namespace seamount::learned {
namespace {

constexpr double kFarCells = 16.0;   ///< from what is drawn: there the network is on its own
constexpr double kGapShare = 0.02;   ///< of a map that is far before it gets a guide
constexpr int kLeastWide = 40;       ///< wide cells a side
constexpr double kWidest_m = 500.0;  ///< wide cells, more than twice those of the training

GridFrame widened(const GridFrame& frame) {
  GridFrame wide = frame;
  wide.width = (frame.width + kGuideFactor - 1) / kGuideFactor;
  wide.height = (frame.height + kGuideFactor - 1) / kGuideFactor;
  wide.cell_m = frame.cell_m * kGuideFactor;
  return wide;
}

/// Calls visit(cell, wide cell) for all cells.
template <class Visit>
void for_each_cell(const GridFrame& frame, const GridFrame& wide, Visit&& visit) {
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x)
      visit(static_cast<size_t>(y) * frame.width + x,
            static_cast<size_t>(y / kGuideFactor) * wide.width + x / kGuideFactor);
  }
}

Grid<uint8_t> any_of(const Grid<uint8_t>& cells, const GridFrame& wide) {
  if (cells.empty()) return {};
  Grid<uint8_t> out(wide, 0);
  for_each_cell(cells.frame(), wide, [&](size_t i, size_t k) { out.data()[k] |= cells.data()[i]; });
  return out;
}

/// Means of values where `counts`; NaN where none does.
template <class Counts>
ScalarField means_of(const ScalarField& values, const GridFrame& wide, const Counts& counts) {
  ScalarField sum(wide, 0.0F), number(wide, 0.0F);
  for_each_cell(values.frame(), wide, [&](size_t i, size_t k) {
    if (!counts(i)) return;
    sum.data()[k] += values.data()[i];
    number.data()[k] += 1;
  });
  for (size_t k = 0; k < sum.size(); ++k) sum.data()[k] /= number.data()[k];
  return sum;
}

ScalarField from_drawn(const SketchMap& map, const RunContext& run) {
  Grid<uint8_t> drawn(map.frame, 0);
  for (const Grid<uint8_t>* cells : {&map.river, &map.ridge, &map.cue}) {
    for (size_t i = 0; i < cells->size(); ++i) drawn.data()[i] |= cells->data()[i];
  }
  for (size_t i = 0; i < map.known_m.size(); ++i) drawn.data()[i] |= !std::isnan(map.known_m.data()[i]);
  return geom::distance_to(drawn, run);
}

}  // namespace

SketchMap coarser(const SketchMap& map) {
  SketchMap out;
  out.frame = widened(map.frame);
  out.low_m = map.low_m;
  out.relief_m = map.relief_m;
  out.river = any_of(map.river, out.frame);
  out.ridge = any_of(map.ridge, out.frame);
  out.cue = any_of(map.cue, out.frame);
  if (!map.cue.empty()) {
    out.cue_m = means_of(map.cue_m, out.frame, [&](size_t i) { return map.cue.data()[i] != 0; });
    for (float& z : out.cue_m.cells()) z = std::isnan(z) ? 0.0F : z;
  }
  if (!map.known_m.empty())
    out.known_m = means_of(map.known_m, out.frame, [&](size_t i) { return !std::isnan(map.known_m.data()[i]); });
  if (!map.level.empty()) {
    Grid<int> votes(out.frame, 0);
    for_each_cell(map.frame, out.frame, [&](size_t i, size_t k) { votes.data()[k] += map.level.data()[i]; });
    out.level = Grid<int8_t>(out.frame, 0);
    for (size_t k = 0; k < votes.size(); ++k)
      out.level.data()[k] = static_cast<int8_t>(std::clamp(votes.data()[k], -1, 1));
  }
  return out;
}

std::optional<ScalarField> distance_in_gaps(const SketchMap& map, const RunContext& run) {
  const GridFrame wide = widened(map.frame);
  if (std::min(wide.width, wide.height) < kLeastWide || wide.cell_m > kWidest_m) return std::nullopt;
  ScalarField distance = from_drawn(map, run);
  const auto far = static_cast<float>(kFarCells * map.frame.cell_m);
  const auto gaps = std::count_if(distance.cells().begin(), distance.cells().end(), [&](float d) { return d > far; });
  if (static_cast<double>(gaps) <= kGapShare * static_cast<double>(distance.size())) return std::nullopt;
  return distance;
}

void add_guide(const Drawing& guide, const ScalarField& distance, SketchMap& map) {
  const auto far = static_cast<float>(kFarCells * map.frame.cell_m);
  Grid<uint8_t> river(map.frame, 0), ridge(map.frame, 0);
  for (const ValuedLine& line : guide.lines) draw_cells(line.points, line.value == 0 ? river : ridge);
  if (map.river.empty()) map.river = Grid<uint8_t>(map.frame, 0);
  if (map.ridge.empty()) map.ridge = Grid<uint8_t>(map.frame, 0);
  for (size_t i = 0; i < distance.size(); ++i) {
    if (distance.data()[i] <= far) continue;
    map.river.data()[i] |= river.data()[i];
    map.ridge.data()[i] |= ridge.data()[i];
  }
  for (const ValuedPoint& point : guide.points) {
    const int x = static_cast<int>(std::lround(map.frame.column(point.place.x))),
              y = static_cast<int>(std::lround(map.frame.row(point.place.y)));
    if (distance.contains(x, y) && distance(x, y) > far) put_height(point.place, point.value, map);
  }
}

}  // namespace seamount::learned
