#include "seamount/ops/erosion/repose.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace seamount::erosion {
namespace {

constexpr float kHigh = std::numeric_limits<float>::infinity();

/// One step of fast sweeping (Zhao 2005) over a ground whose slope has a limit.
class Sweep {
 public:
  Sweep(ScalarField& level, const Drainage& drainage, const Maps& site, double steepest)
      : level_(level),
        drainage_(drainage),
        site_(site),
        width_(level.width()),
        height_(level.height()),
        rise_(static_cast<float>(steepest * level.cell_m())) {}

  /// Both ways along a row; the second only where the first has moved something.
  void row(int y) {
    if (pass<1>(y)) pass<-1>(y);
  }

 private:
  template <int way>
  bool pass(int y) {
    float* row = level_.data() + static_cast<size_t>(y) * width_;
    const float* up = y > 0 ? row - width_ : row;
    const float* down = y + 1 < height_ ? row + width_ : row;
    bool moved = false;
    for (int k = 0; k < width_; ++k) {
      const int x = way > 0 ? k : width_ - 1 - k;
      const float along_y = up == down ? kHigh : up == row ? down[x] : down == row ? up[x] : std::min(up[x], down[x]);
      const float along_x = std::min(x > 0 ? row[x - 1] : kHigh, x + 1 < width_ ? row[x + 1] : kHigh);
      moved |= cell(y * width_ + x, row[x], along_x, along_y);
    }
    return moved;
  }

  /// Lowers a cell to where the gradient towards the lower ground in x and in y is the limit, by Godunov's upwind
  /// differences; so that what stands around a point is a cone, not a pyramid of eight sides.
  bool cell(int32_t index, float& here, float along_x, float along_y) const {
    const float low = std::min(along_x, along_y), above = here - low;
    const float square = rise_ * rise_ * value_or_one(site_.hardness, index);
    if (above <= 0.0F || above * above <= 0.5F * square || drainage_.is_root(index)) return false;
    const float apart = std::abs(along_x - along_y), own = std::sqrt(square);
    const float limit = apart < own ? 0.5F * (along_x + along_y + std::sqrt(2.0F * square - apart * apart)) : low + own;
    if (here <= limit) return false;
    here += value_or_one(site_.mask, index) * (limit - here);
    return true;
  }

  ScalarField& level_;
  const Drainage& drainage_;
  const Maps& site_;
  int width_, height_;
  float rise_;
};

}  // namespace

void limit_slopes(ScalarField& level, const Drainage& drainage, const Maps& site, double steepest,
                  const RunContext& run) {
  Sweep sweep(level, drainage, site, steepest);
  for (int y = 0; y < level.height(); ++y) run.check_cancelled(), sweep.row(y);
  for (int y = level.height() - 1; y >= 0; --y) run.check_cancelled(), sweep.row(y);
}

}  // namespace seamount::erosion
