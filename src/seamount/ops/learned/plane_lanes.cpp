#include "seamount/ops/learned/plane_lanes.h"

#include <cstring>

#include "seamount/base/simd.h"

namespace seamount::learned {
namespace {

using Eight = float __attribute__((vector_size(32)));

/// Eight cells of eight lanes, `stride` numbers apart, to eight numbers of eight cells, `planes` apart.
SEAMOUNT_INLINE void turn(const float* lanes, size_t stride, size_t planes, float* out) {
  Eight row[8], pair[8], four[8];
  for (size_t k = 0; k < 8; ++k) std::memcpy(&row[k], lanes + k * stride, sizeof row[k]);
  for (int k = 0; k < 8; k += 2) {
    pair[k] = __builtin_shufflevector(row[k], row[k + 1], 0, 8, 1, 9, 4, 12, 5, 13);
    pair[k + 1] = __builtin_shufflevector(row[k], row[k + 1], 2, 10, 3, 11, 6, 14, 7, 15);
  }
  for (int k = 0; k < 8; k += 4) {
    for (int i = 0; i < 2; ++i) {
      four[k + 2 * i] = __builtin_shufflevector(pair[k + i], pair[k + 2 + i], 0, 1, 8, 9, 4, 5, 12, 13);
      four[k + 2 * i + 1] = __builtin_shufflevector(pair[k + i], pair[k + 2 + i], 2, 3, 10, 11, 6, 7, 14, 15);
    }
  }
  for (size_t k = 0; k < 4; ++k) {
    const Eight near = __builtin_shufflevector(four[k], four[k + 4], 0, 1, 2, 3, 8, 9, 10, 11),
                far = __builtin_shufflevector(four[k], four[k + 4], 4, 5, 6, 7, 12, 13, 14, 15);
    std::memcpy(out + k * planes, &near, sizeof near);
    std::memcpy(out + (k + 4) * planes, &far, sizeof far);
  }
}

SEAMOUNT_VECTORISED void turn_all(const float* lanes, size_t stride, size_t width, size_t planes, float* out) {
  const size_t cells = width / 8 * 8, together = planes / 8 * 8;
  for (size_t x = 0; x < cells; x += 8) {
    for (size_t k = 0; k < together; k += 8) turn(lanes + k * stride + x, stride, planes, out + x * planes + k);
    for (size_t k = together; k < planes; ++k)
      for (size_t i = x; i < x + 8; ++i) out[i * planes + k] = lanes[k * stride + i];
  }
  for (size_t x = cells; x < width; ++x)
    for (size_t k = 0; k < planes; ++k) out[x * planes + k] = lanes[k * stride + x];
}

}  // namespace

void PlaneLanes::interleave(float* out) const {
  turn_all(values_.data(), stride_, static_cast<size_t>(width_), static_cast<size_t>(planes_), out);
}

}  // namespace seamount::learned
