#include "seamount/geom/water/settle.h"

#include <algorithm>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/resample.h"

namespace seamount::geom {
namespace {

class Lakes {
 public:
  Lakes(const HeightField& terrain, const HeightField& filled, float sea_level_m)
      : terrain_(terrain), filled_(filled), wet_(terrain.frame(), 0) {
    for (size_t i = 0; i < wet_.size(); ++i)
      wet_.data()[i] = terrain.data()[i] > sea_level_m && filled.data()[i] > terrain.data()[i] ? 1 : 0;
  }

  void spread(HeightField& heights, const RunContext& run) {
    for (int y = 0; y < wet_.height(); ++y) {
      run.check_cancelled();
      for (int x = 0; x < wet_.width(); ++x)
        if (wet_(x, y) != 0) spread_one(x, y, heights);
    }
  }

 private:
  /// The lake of a cell, which is dry afterwards.
  void spread_one(int x, int y, HeightField& heights) {
    cells_.assign(1, {x, y});
    wet_(x, y) = 0;
    double room = 0, laid = 0;
    for (size_t k = 0; k < cells_.size(); ++k) {
      const auto [cx, cy] = cells_[k];
      room += filled_(cx, cy) - terrain_(cx, cy);
      laid += heights(cx, cy) - terrain_(cx, cy);
      for (int v = std::max(cy - 1, 0); v <= std::min(cy + 1, wet_.height() - 1); ++v) {
        for (int u = std::max(cx - 1, 0); u <= std::min(cx + 1, wet_.width() - 1); ++u) {
          if (wet_(u, v) == 0) continue;
          wet_(u, v) = 0;
          cells_.push_back({u, v});
        }
      }
    }
    const auto share = static_cast<float>(std::min(1.0, laid / room));
    if (share <= 0) return;  // its outlet was cut deeper
    for (const auto [cx, cy] : cells_)
      heights(cx, cy) = terrain_(cx, cy) + share * (filled_(cx, cy) - terrain_(cx, cy));
  }

  struct Cell {
    int x, y;
  };
  const HeightField &terrain_, &filled_;
  Grid<uint8_t> wet_;
  std::vector<Cell> cells_;
};

void settle_in_sea(const HeightField& terrain, const Settling& settling, Incised& made, const RunContext& run) {
  constexpr float kLeastWater = 1e-4F;  // share of sea around from which a load is spread
  ScalarField water(terrain.frame(), 0.0F), load(terrain.frame(), 0.0F);
  bool any = false;
  for (size_t i = 0; i < terrain.size(); ++i) {
    if (terrain.data()[i] > settling.sea_level_m) continue;
    water.data()[i] = 1;
    load.data()[i] = made.load.data()[i];
    any = any || load.data()[i] > 0;
  }
  if (!any) return;
  const double width_m = std::min(terrain.frame().width_m(), terrain.frame().height_m());
  const double reach_m = std::min(settling.reach_m, width_m / 4);
  gaussian_blur(water, reach_m, run);
  for (size_t i = 0; i < load.size(); ++i) load.data()[i] /= std::max(water.data()[i], kLeastWater);
  gaussian_blur(load, reach_m, run);
  for (size_t i = 0; i < terrain.size(); ++i) {
    const float depth = settling.sea_level_m - terrain.data()[i];
    if (depth >= 0) made.heights.data()[i] = terrain.data()[i] + std::min(load.data()[i], settling.fill * depth);
  }
}

}  // namespace

void settle(const HeightField& terrain, const HeightField& filled, const Settling& settling, Incised& made,
            const RunContext& run) {
  Lakes(terrain, filled, settling.sea_level_m).spread(made.heights, run);
  settle_in_sea(terrain, settling, made, run);
}

}  // namespace seamount::geom
