// What a network does between its convolutions, a row at a time: what is bound by memory rather than by arithmetic.
// Each function for both types of numbers; all sums in f32.
#pragma once

#include "seamount/ops/learned/bf16.h"

namespace seamount::learned {

/// One row of relu(up2(low) + skip), 2 `width` cells. `near` and `far`: the rows of the smaller map that are closest
/// and next to closest, `width` cells of `channels`. `blend`: scratch of a smaller row.
void upsample_add_relu(const float* near, const float* far, const float* skip, int width, int channels, float* blend,
                       float* out);
void upsample_add_relu(const Bf16* near, const Bf16* far, const Bf16* skip, int width, int channels, float* blend,
                       Bf16* out);

/// One row of concat(up2(low), planes): 2 `width` cells of kThinWidth + `planes` numbers.
void upsample_concat(const float* near, const float* far, const float* plane_row, int width, int planes, float* blend,
                     float* out);
void upsample_concat(const Bf16* near, const Bf16* far, const float* plane_row, int width, int planes, float* blend,
                     Bf16* out);

/// One row of half the size: of each 2x2 cells first the upper two, then the lower two, all planes of a cell together.
/// `width`: of the result.
void halve(const float* upper, const float* lower, int width, int planes, float* out);
void halve(const float* upper, const float* lower, int width, int planes, Bf16* out);

/// One row of the last convolution: 3x3 from kInnerWidth planes to one, zeros left and right. `in`: its row and those
/// above and below, `width` cells each; the first `count` cells are written. `weight`: [row][column][plane].
void outer_row(const float* const in[3], const float* weight, float bias, int width, int count, float* out);

}  // namespace seamount::learned
