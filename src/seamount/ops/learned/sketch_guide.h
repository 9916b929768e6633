// What nobody drew of a sketch: lines and heights for its wide empty parts, from a rough terrain of the same sketch.
//
// Ours, after P1 sec. 6.1 (fig. 25: few strokes, a dense sketch): a network knows ground as far as it sees, some dozens
// of cells, and makes hills without valleys where that shows no stroke. On cells four times as wide the same strokes
// are near each other. So the sketch is made rough first, that terrain is drawn again, and what is far from the user's
// strokes is added to them.
#pragma once

#include <functional>
#include <optional>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"
#include "seamount/ops/learned/sketch_planes.h"

namespace seamount::learned {

/// How a terrain is drawn again: lines of value 0 (river) and 1 (ridge) of which at least least_m2 of ground runs off,
/// points with heights.
using Redraw = std::function<Drawing(const HeightField& terrain, double least_m2, Seed seed, const RunContext& run)>;

/// The map on cells kGuideFactor times as wide: what is drawn anywhere in a wide cell is drawn in it, heights are
/// means.
inline constexpr int kGuideFactor = 4;
SketchMap coarser(const SketchMap& map);

/// Distance in metres from all that is drawn of a map with wide gaps: more than a fiftieth of it is empty and far, and
/// wide cells would still show it. Nothing for other maps.
std::optional<ScalarField> distance_in_gaps(const SketchMap& map, const RunContext& run);

/// Adds lines and heights of `guide` to the map where it is empty and far from all that is drawn. Linear.
void add_guide(const Drawing& guide, const ScalarField& distance, SketchMap& map);

}  // namespace seamount::learned
