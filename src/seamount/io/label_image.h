// Label maps as pictures that people can paint (P0 sec. 1.7): hue is the region - abyss 0 (red), mountain 60 (yellow),
// beach 120 (green), lagoon 180 (cyan), reef 240 (blue) -, value is the subsidence: V = 1 - 0.8 lambda, never black.
// Saturation is 1.
#pragma once

#include <array>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/image.h"
#include "seamount/model/label_map.h"

namespace seamount::io {

/// Hue in degrees of each Region, by its number.
inline constexpr std::array<double, kRegionCount> kRegionHues_deg = {60.0, 120.0, 180.0, 240.0, 0.0};

/// Throws InvalidArgument unless subsidence is in [0, 1].
Image encode_labels(const LabelMap& labels, double subsidence = 0.0);

/// The colour of one region.
Colour region_colour(Region region, double subsidence = 0.0);

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

}  // namespace seamount::io
