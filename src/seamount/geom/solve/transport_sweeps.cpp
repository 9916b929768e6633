// Gauss-Seidel waits for the cell before. Four rows therefore advance together, each one cell behind the row before it:
// the order of every dependence is kept, and four sums are on their way at a time.
#include "seamount/geom/solve/transport_sweeps.h"

#include <algorithm>

namespace seamount::geom::transport {
namespace {

constexpr int kRows = 4;

/// One cell's new value; its neighbours' are named as a sweep to the east and south meets them.
template <int kX, int kY, bool kHeld>
inline float relaxed(const Cell& cell, float behind, float above, float ahead, float below) {
  const float w = kX > 0 ? cell.west : cell.east, e = kX > 0 ? cell.east : cell.west;
  const float n = kY > 0 ? cell.north : cell.south, s = kY > 0 ? cell.south : cell.north;
  const float value = (((cell.right + e * ahead) + s * below) + n * above) + w * behind;
  return !kHeld || value > 0.0F ? value : 0.0F;
}

/// Sweeps kCount rows, the first of which begins at `first`, in direction (kX, kY).
template <int kCount, int kX, int kY, bool kHeld>
void sweep_rows(Cell* first, std::ptrdiff_t stride, int width) {
  const std::ptrdiff_t down = kY * stride;
  const std::ptrdiff_t diagonal = down - kX;  // from one row's cell to the next row's of the same time
  const auto single = [&](int row, int column) {
    Cell* cell = first + row * down + column * kX;
    cell->value = relaxed<kX, kY, kHeld>(*cell, cell[-kX].value, cell[-down].value, cell[kX].value, cell[down].value);
  };
  const int lead = std::min(kCount - 1, width);
  for (int time = 0; time < lead; ++time)
    for (int row = 0; row <= time; ++row) single(row, time - row);
  float behind[kCount];  // the newest value of each row
  for (int row = 0; row < kCount; ++row) behind[row] = (first + row * down + (lead - row - 1) * kX)->value;
  Cell* leader = first + lead * kX;
  for (int time = lead; time < width; ++time, leader += kX) {
    float ahead[kCount + 1], value[kCount];  // a row's cell ahead lies below the row before it
    for (int row = 0; row < kCount; ++row) ahead[row] = leader[row * diagonal + kX].value;
    ahead[kCount] = leader[(kCount - 1) * diagonal + down].value;
    for (int row = kCount - 1; row > 0; --row)
      value[row] =
          relaxed<kX, kY, kHeld>(leader[row * diagonal], behind[row], behind[row - 1], ahead[row], ahead[row + 1]);
    value[0] = relaxed<kX, kY, kHeld>(*leader, behind[0], leader[-down].value, ahead[0], ahead[1]);
    for (int row = 0; row < kCount; ++row) leader[row * diagonal].value = behind[row] = value[row];
  }
  for (int time = std::max(lead, width); time < width + kCount - 1; ++time)
    for (int row = time - width + 1; row < std::min(kCount, time + 1); ++row) single(row, time - row);
}

/// Rows [from, from + count) as counted in direction kY.
template <int kX, int kY, bool kHeld>
void sweep_block(Level& level, int from, int count) {
  const auto first = [&](int k) {
    return level.row(kY > 0 ? from + k : level.height - 1 - from - k) + (kX > 0 ? 0 : level.width - 1);
  };
  int k = 0;
  for (; k + kRows <= count; k += kRows) sweep_rows<kRows, kX, kY, kHeld>(first(k), level.stride, level.width);
  for (; k < count; ++k) sweep_rows<1, kX, kY, kHeld>(first(k), level.stride, level.width);
}

/// Both sweeps in one pass through memory: the second follows the first at a distance at which it reads what it would
/// read afterwards.
template <int kY, bool kHeld>
void sweep_both(Level& level) {
  int done = 0;
  for (int from = 0; from < level.height; from += kRows) {
    const int count = std::min(kRows, level.height - from);
    sweep_block<1, kY, kHeld>(level, from, count);
    const bool last = from + count == level.height;
    const int ready = last ? level.height - done : (from + count - 1 - done) / kRows * kRows;
    sweep_block<-1, kY, kHeld>(level, done, ready);
    done += ready;
  }
}

}  // namespace

void sweep_south(Level& level, bool held) { held ? sweep_both<1, true>(level) : sweep_both<1, false>(level); }
void sweep_north(Level& level, bool held) { held ? sweep_both<-1, true>(level) : sweep_both<-1, false>(level); }

}  // namespace seamount::geom::transport
