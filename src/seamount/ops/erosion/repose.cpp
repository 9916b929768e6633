#include "seamount/ops/erosion/repose.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/scalar/noise.h"

#include "seamount/ops/erosion/beds.h"

namespace seamount::erosion {
namespace {

/// Share by which each doubling of the water that gathers in it takes away from the steepness of a hollow.
constexpr float kHollowed = 0.03F;
/// Joints and weak beds: their largest spacing, and the logarithm of how much steeper rock stands for them, over the
/// variation of hardness and the noise.
constexpr double kJoints_m = 200.0, kUnevenness = 2.2;
constexpr float kHigh = std::numeric_limits<float>::infinity();

/// One step of fast sweeping (Zhao 2005) over a ground whose slope has a limit.
class Sweep {
 public:
  Sweep(ScalarField& level, const Drainage& drainage, const Maps& site, const ScalarField& rise)
      : level_(level), drainage_(drainage), site_(site), rise_(rise), width_(level.width()), height_(level.height()) {}

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
    if (above <= 0.0F || drainage_.is_root(index)) return false;
    const float own = rise_.data()[index], square = own * own;
    float limit = here;
    if (site_.beds != nullptr) {
      limit = site_.beds->stand(static_cast<size_t>(index), low, std::max(along_x, along_y), here, own);
    } else {
      if (above * above <= 0.5F * square) return false;
      const float apart = std::abs(along_x - along_y);
      limit = apart < own ? 0.5F * (along_x + along_y + std::sqrt(2.0F * square - apart * apart)) : low + own;
    }
    if (here <= limit) return false;
    here += value_or_one(site_.mask, index) * (limit - here);
    return true;
  }

  ScalarField& level_;
  const Drainage& drainage_;
  const Maps& site_;
  const ScalarField& rise_;
  int width_, height_;
};

}  // namespace

void find_steepest_rise(const ScalarField& discharge, const Maps& site, const Strength& strength, ScalarField& rise,
                        const RunContext& run) {
  const GridFrame& frame = rise.frame();
  const auto most = static_cast<float>(strength.steepest * frame.cell_m);
  const auto per_hollow = static_cast<float>(1.0 / strength.hollow_m3_yr);
  const float hollowed = site.beds == nullptr ? kHollowed : 0.0F;  // beds are undermined instead (undermining.h)
  const auto uneven = static_cast<float>(kUnevenness * strength.variation);
  const geom::Fbm joints{.wavelength_m = kJoints_m, .octaves = 5, .gain = 0.8, .cell_m = frame.cell_m};
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    std::vector<float> noise(static_cast<size_t>(frame.width));
    for (int y = begin; y < end; ++y) {
      if (uneven > 0.0F) geom::fbm_row(strength.seed, joints, frame.x(0), frame.cell_m, frame.y(y), noise);
      for (int x = 0; x < frame.width; ++x) {
        const auto cell = static_cast<size_t>(y) * frame.width + x;
        const float hollow = 1.0F + hollowed * std::log2(1.0F + discharge.data()[cell] * per_hollow);
        const float own = uneven > 0.0F ? std::exp(uneven * noise[x]) : 1.0F;
        rise.data()[cell] = most * own * std::sqrt(value_or_one(site.hardness, cell)) / hollow;
      }
    }
  });
}

void limit_slopes(ScalarField& level, const Drainage& drainage, const Maps& site, const ScalarField& rise,
                  const RunContext& run) {
  Sweep sweep(level, drainage, site, rise);
  for (int y = 0; y < level.height(); ++y) run.check_cancelled(), sweep.row(y);
  for (int y = level.height() - 1; y >= 0; --y) run.check_cancelled(), sweep.row(y);
}

}  // namespace seamount::erosion
