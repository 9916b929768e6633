// render.perspective: a picture of a terrain from a point of view, with sun, sky, water and ground materials.
//
// Rays from the pixels' corners meet the height field in a pyramid of maxima (tracer.h); a pixel whose corners see one
// smooth surface is shaded once from mip-mapped forms, any other by nine rays of its own. Shadows and openness to the
// sky are found for the whole terrain first (light.h). The sea has one level, and ground below it that the sea does not
// reach is dry (geom/water/inland.h); a terrain whose border is mostly under
// water lies in an endless sea, any other is cut out as a block.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/image.h"
#include "seamount/model/label_map.h"
#include "seamount/model/things.h"
#include "seamount/ops/render/perspective_params.h"
#include "seamount/ops/render/shown.h"

namespace seamount::render {

/// What stands on the terrain is drawn from its models (thing_scene.h): things cast shadows on the ground and on one
/// another, keep the sky from what is under them, and are seen through the water. A camera with distance_m may be under
/// water itself (scene_underwater.cpp).
///
/// Draws the terrain with what is shown. Heights in metres, any size from
/// 1 x 1. Throws InvalidArgument for params out of range and heights that are not finite, IncompatibleInputs for labels
/// of another size. About 1 us a pixel plus 40 ns a cell (up to 2048 x 2048 cells are kept), parallel.
/// Things take about 5 us for each pixel that sees one or lies beside it.
Image perspective(const HeightField& terrain, const Shown& shown, const PerspectiveParams& params,
                  const RunContext& run);
/// With labels alone.
inline Image perspective(const HeightField& terrain, const LabelMap* labels, const PerspectiveParams& params,
                         const RunContext& run) {
  return perspective(terrain, Shown{.labels = labels}, params, run);
}

}  // namespace seamount::render
