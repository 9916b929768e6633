// Label maps as pictures that people can paint, in the colours of model/label_map.h.
#pragma once

#include <array>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/image.h"
#include "seamount/model/label_map.h"

namespace seamount::geom {

/// A pixel a cell. Throws InvalidArgument if there are no cells or unless subsidence is in [0, 1].
Image encode_labels(const LabelMap& labels, double subsidence = 0.0);

/// What a painted picture says.
struct PaintedLabels {
  LabelMap labels;
  std::array<Mask, kRegionCount> shares;  ///< by region number, each in [0, 1], summing to 1 in every cell
  double subsidence = 0.0;                ///< median over the picture, in [0, 1]
  ScalarField subsidence_per_cell;        ///< in [0, 1], smooth
};

/// Reads a picture with anti-aliased edges, JPEG noise, over-bright, white, grey and black pixels. A pixel whose colour
/// lies on the straight line between the colours of two regions that are in its neighbourhood is a mix of both, so
/// that a seam between two regions never invents a third; a pixel without hue takes the nearest region; specks of a
/// few pixels vanish. The picture is read at its own size and sampled at the cells' centres.
/// Throws InvalidArgument{"image"} if it is empty or has no coloured pixel. Parallel; about 60 bytes a cell.
PaintedLabels decode_labels(const Image& image, const GridFrame& frame, const RunContext& run);

}  // namespace seamount::geom
