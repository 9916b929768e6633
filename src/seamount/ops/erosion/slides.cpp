#include "seamount/ops/erosion/slides.h"

#include <array>
#include <cmath>
#include <numbers>

#include "seamount/base/parallel.h"

namespace seamount::erosion {
namespace {

/// Three rows of a map around one row, each readable from index -1 to `width`.
struct Rows {
  const float* up;
  const float* mid;
  const float* down;
};

/// Copies rows of a map with a rim of one cell: what lies off the map has the value `outside`.
class Window {
 public:
  Window(const ScalarField& map, float outside)
      : map_(map), outside_(outside), width_(static_cast<size_t>(map.width())) {
    for (auto& row : rows_) row.assign(width_ + 2, outside);
  }
  Rows at(int y) {
    if (y != next_) {
      fill(rows_[0], y - 1);
      fill(rows_[1], y);
    } else {
      std::swap(rows_[0], rows_[1]);
      std::swap(rows_[1], rows_[2]);
    }
    fill(rows_[2], y + 1);
    next_ = y + 1;
    return {rows_[0].data() + 1, rows_[1].data() + 1, rows_[2].data() + 1};
  }

 private:
  void fill(std::vector<float>& row, int y) const {
    if (y < 0 || y >= map_.height()) {
      row.assign(width_ + 2, outside_);
    } else {
      std::copy_n(map_.data() + static_cast<size_t>(y) * width_, width_, row.begin() + 1);
    }
  }

  const ScalarField& map_;
  float outside_;
  size_t width_;
  int next_ = -1;
  std::array<std::vector<float>, 3> rows_;
};

struct Talus {
  float straight, diagonal;  ///< height over a neighbour at the angle of repose
  float speed;
};

SEAMOUNT_INLINE float over(float excess) { return excess > 0.0F ? excess : 0.0F; }

SEAMOUNT_INLINE void add_excess(float z, float other, float mask, float talus, float& sum, float& most) {
  const float excess = over(z - other - talus);
  sum += excess * mask;
  most = most > excess ? most : excess;
}

/// How much of each metre of excess leaves each cell.
SEAMOUNT_VECTORISED void share_row(const Talus talus, const Rows z, const Rows mask, const float* loose,
                                   float* __restrict share, int count) {
  for (int i = 0; i < count; ++i) {
    float sum = 0.0F, most = 0.0F;
    const float here = z.mid[i];
    add_excess(here, z.mid[i + 1], mask.mid[i + 1], talus.straight, sum, most);
    add_excess(here, z.down[i + 1], mask.down[i + 1], talus.diagonal, sum, most);
    add_excess(here, z.down[i], mask.down[i], talus.straight, sum, most);
    add_excess(here, z.down[i - 1], mask.down[i - 1], talus.diagonal, sum, most);
    add_excess(here, z.mid[i - 1], mask.mid[i - 1], talus.straight, sum, most);
    add_excess(here, z.up[i - 1], mask.up[i - 1], talus.diagonal, sum, most);
    add_excess(here, z.up[i], mask.up[i], talus.straight, sum, most);
    add_excess(here, z.up[i + 1], mask.up[i + 1], talus.diagonal, sum, most);
    const float wanted = talus.speed * mask.mid[i] * most * sum / (sum + most + 1e-30F);
    share[i] = (loose[i] < wanted ? loose[i] : wanted) / (sum + 1e-30F);
  }
}

SEAMOUNT_INLINE void add_flow(float z, float other, float mask, float share, float talus, float& in, float& out) {
  out += over(z - other - talus) * mask;
  in += over(other - z - talus) * share;
}

/// What arrives and what leaves. `kept`: 1 where the layer loses what leaves, 0 where bedrock below it does.
SEAMOUNT_VECTORISED void move_row(const Talus talus, float kept, const Rows z, const Rows mask, const Rows share,
                                  float* __restrict next, float* __restrict layer, int count) {
  for (int i = 0; i < count; ++i) {
    float in = 0.0F, out = 0.0F;
    const float here = z.mid[i];
    add_flow(here, z.mid[i + 1], mask.mid[i + 1], share.mid[i + 1], talus.straight, in, out);
    add_flow(here, z.down[i + 1], mask.down[i + 1], share.down[i + 1], talus.diagonal, in, out);
    add_flow(here, z.down[i], mask.down[i], share.down[i], talus.straight, in, out);
    add_flow(here, z.down[i - 1], mask.down[i - 1], share.down[i - 1], talus.diagonal, in, out);
    add_flow(here, z.mid[i - 1], mask.mid[i - 1], share.mid[i - 1], talus.straight, in, out);
    add_flow(here, z.up[i - 1], mask.up[i - 1], share.up[i - 1], talus.diagonal, in, out);
    add_flow(here, z.up[i], mask.up[i], share.up[i], talus.straight, in, out);
    add_flow(here, z.up[i + 1], mask.up[i + 1], share.up[i + 1], talus.diagonal, in, out);
    in *= mask.mid[i];
    out *= share.mid[i];
    next[i] = here + (in - out);
    layer[i] = over(layer[i] + (in - kept * out));
  }
}

constexpr float kEndless = 1e30F;  // bedrock

}  // namespace

void slide(HeightField& surface, ScalarField& layer, Sliding what, const Maps& site, double angle_deg, double speed,
           ScalarField& share, ScalarField& next, const RunContext& run) {
  const double straight = std::tan(angle_deg * std::numbers::pi / 180.0) * surface.cell_m();
  const Talus talus{static_cast<float>(straight), static_cast<float>(straight * std::sqrt(2.0)),
                    static_cast<float>(speed)};
  const int width = surface.width(), height = surface.height();
  const bool from_below = what == Sliding::bedrock_below;
  const std::vector<float> ones(static_cast<size_t>(width) + 2, 1.0F), endless(static_cast<size_t>(width), kEndless);
  const Rows all_open{ones.data() + 1, ones.data() + 1, ones.data() + 1};
  // Off the map everything stands too high to slide there, and nothing comes from there.
  constexpr float kWall = 1e9F;
  const ScalarField& limits = site.mask.empty() ? surface : site.mask;
  const auto open = [&](Window& mask, int y) { return site.mask.empty() ? all_open : mask.at(y); };
  parallel_rows(run, width, height, [&](int begin, int end) {
    Window heights(surface, kWall), mask(limits, 0.0F);
    for (int y = begin; y < end; ++y) {
      const float* loose = from_below ? endless.data() : layer.row(y).data();
      share_row(talus, heights.at(y), open(mask, y), loose, share.row(y).data(), width);
    }
  });
  parallel_rows(run, width, height, [&](int begin, int end) {
    Window heights(surface, kWall), mask(limits, 0.0F), shares(share, 0.0F);
    for (int y = begin; y < end; ++y) {
      move_row(talus, from_below ? 0.0F : 1.0F, heights.at(y), open(mask, y), shares.at(y), next.row(y).data(),
               layer.row(y).data(), width);
    }
  });
  std::swap(surface, next);
}

}  // namespace seamount::erosion
