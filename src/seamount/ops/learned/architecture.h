// The one network that all synthesizers share: its description, which training and inference both follow.
//
// A U-Net whose skips are added, without transposed convolutions (a grid by construction: Odena et al. 2016) and
// without any normalisation (the same result in training, in use, and in any tile). Source: P1 sec. 4 is pix2pix's
// U-Net of 54 million parameters; this one has 3 million, and starts and ends at full size with few channels.
//
//   x          planes at full size, n of them
//   e0         relu(input(space_to_depth(x)))                        half size, widths[0]
//   e_k        relu(down_k(e_{k-1}))                                 stride 2, widths[k]
//   d_last     e_last + middle(e_last), relu
//   d_k        u = relu(up2(lift_k(d_{k+1})) + e_k); relu(join_k(u)); where widths[k] >= kDeepWidth then relu(d +
//   deep_k(d)) y          outer(relu(inner(concat(up2(thin(d_0)), x))))         full size, one plane, linear
//
// All convolutions are 3x3 with one cell of zeros around, but for lift and thin, which are 1x1; each has a bias.
// space_to_depth: channel 4 c + 2 dy + dx of a half-size cell is plane c at (2 x + dx, 2 y + dy). up2 doubles by
// bilinear interpolation between cell centres, clamped at the edge. concat: first the eight planes of `thin`, then x.
#pragma once

#include <string>
#include <vector>

#include "seamount/model/weights.h"

namespace seamount::learned {

inline constexpr int kThinWidth = 8;    ///< channels in which the half-size features reach full size
inline constexpr int kInnerWidth = 8;   ///< channels at full size
inline constexpr int kDeepWidth = 192;  ///< levels as wide as this have one convolution more

struct Architecture {
  int planes = 16;  ///< of the input, [1, 32]
  std::vector<int> widths = {32,  64,  128,
                             192, 192, 192};  ///< of the levels, strides 2, 4, 8 ...; [2, 8] of them in [8, 512]

  int levels() const { return static_cast<int>(widths.size()); }
  /// Cells in a side of the deepest level's cell: maps are padded to a multiple of it.
  int stride() const { return 1 << levels(); }

  bool operator==(const Architecture&) const = default;
};

/// A convolution: "NAME.weight" of shape [out, in, kernel, kernel] and "NAME.bias" of shape [out] in the weights.
struct Convolution {
  std::string name;
  int in, out, kernel, stride;
};

/// Every convolution, in the order of evaluation: input, down1 ..., middle, then from the deepest level but one
/// outwards lift_k, join_k, deep_k (where there is one), then thin, inner, outer.
std::vector<Convolution> convolutions(const Architecture& architecture);

/// What `about` says of a network ("planes", "widths": "32,64"). Throws InvalidArgument where it is missing or out of
/// range, or where a tensor of convolutions() is missing, has another shape or a number that is not finite.
Architecture architecture_of(const Weights& weights);

/// Writes "planes" and "widths".
void describe(const Architecture& architecture, Weights& weights);

}  // namespace seamount::learned
