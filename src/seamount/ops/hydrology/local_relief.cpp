#include "seamount/ops/hydrology/local_relief.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "seamount/base/parallel.h"

namespace seamount::hydrology {
namespace {

constexpr float kLow = -std::numeric_limits<float>::infinity();

/// Running maxima of `width` vectors of `lanes` values side by side: out[i] = max of in[i - radius .. i + radius].
/// Blocks of 2 radius + 1 are scanned forwards and backwards; a window is the end of one and the start of the next.
void running_max(const std::vector<float>& in, std::vector<float>& forward, std::vector<float>& backward, int count,
                 int lanes, int radius, std::vector<float>& out) {
  const int window = 2 * radius + 1, padded = count + 2 * radius;
  const auto at = [&](std::vector<float>& list, int i) {
    return list.data() + static_cast<size_t>(i) * static_cast<size_t>(lanes);
  };
  const auto source = [&](int i) -> const float* {
    const int place = i - radius;
    return place < 0 || place >= count ? nullptr : in.data() + static_cast<size_t>(place) * static_cast<size_t>(lanes);
  };
  forward.resize(static_cast<size_t>(padded) * static_cast<size_t>(lanes));
  backward.resize(forward.size());
  for (int i = 0; i < padded; ++i) {
    const float* here = source(i);
    float* f = at(forward, i);
    for (int k = 0; k < lanes; ++k) f[k] = here != nullptr ? here[k] : kLow;
    if (i % window != 0)
      for (int k = 0; k < lanes; ++k) f[k] = std::max(f[k], f[k - lanes]);
  }
  for (int i = padded - 1; i >= 0; --i) {
    const float* here = source(i);
    float* b = at(backward, i);
    for (int k = 0; k < lanes; ++k) b[k] = here != nullptr ? here[k] : kLow;
    if (i % window != window - 1 && i + 1 < padded)
      for (int k = 0; k < lanes; ++k) b[k] = std::max(b[k], b[k + lanes]);
  }
  out.resize(static_cast<size_t>(count) * static_cast<size_t>(lanes));
  for (int i = 0; i < count; ++i) {
    const float* b = at(backward, i);
    const float* f = at(forward, i + window - 1);
    float* o = at(out, i);
    for (int k = 0; k < lanes; ++k) o[k] = std::max(b[k], f[k]);
  }
}

/// sign * terrain, its maximum over the square around each cell.
ScalarField square_max(const HeightField& terrain, float sign, int radius, const RunContext& run) {
  const int width = terrain.width(), height = terrain.height();
  ScalarField out(terrain.frame());
  parallel_rows(run, width, height, [&](int begin, int end) {
    std::vector<float> in(static_cast<size_t>(width)), forward, backward, result;
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < width; ++x) in[static_cast<size_t>(x)] = sign * terrain(x, y);
      running_max(in, forward, backward, width, 1, std::min(radius, width), result);
      std::copy(result.begin(), result.end(), out.row(y).begin());
    }
  });
  constexpr int kLanes = 32;  // columns at once
  parallel_blocks(run, width, kLanes, [&](int64_t begin, int64_t end) {
    const int lanes = static_cast<int>(end - begin);
    std::vector<float> in(static_cast<size_t>(lanes) * static_cast<size_t>(height)), forward, backward, result;
    for (int y = 0; y < height; ++y)
      std::copy_n(out.row(y).data() + begin, lanes, in.data() + static_cast<size_t>(y) * static_cast<size_t>(lanes));
    running_max(in, forward, backward, height, lanes, std::min(radius, height), result);
    for (int y = 0; y < height; ++y)
      std::copy_n(result.data() + static_cast<size_t>(y) * static_cast<size_t>(lanes), lanes,
                  out.row(y).data() + begin);
  });
  return out;
}

}  // namespace

ScalarField local_relief(const HeightField& terrain, int radius, const RunContext& run) {
  ScalarField relief = square_max(terrain, 1.0F, radius, run);
  const ScalarField lowest = square_max(terrain, -1.0F, radius, run);
  for (size_t i = 0; i < relief.size(); ++i) relief.data()[i] += lowest.data()[i];
  return relief;
}

}  // namespace seamount::hydrology
