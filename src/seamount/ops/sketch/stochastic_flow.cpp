#include "seamount/ops/sketch/stochastic_flow.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <optional>
#include <vector>

#include "seamount/base/parallel.h"

namespace seamount::sketch {
namespace {

/// Sums of the falls to the neighbours 0 to k; the last is the sum of all.
using Falls = std::array<float, 8>;

class Rain {
 public:
  Rain(const HeightField& surface, float sea, float highest_pass, const StochasticFlow& params, const RunContext& run)
      : surface_(surface),
        sea_(sea),
        params_(params),
        codes_(geom::flow_directions(surface, sea, run)),
        routes_(codes_),
        falls_(surface.frame()),
        pit_(surface.frame(), -1),
        steps_(geom::flow_steps(surface.width())),
        water_{Grid<uint32_t>(surface.frame(), 0U), Grid<uint32_t>(surface.frame(), 0U)} {
    geom::route_through_pits(surface, routes_, highest_pass, run);
    parallel_rows(run, surface.width(), surface.height(), [&](int begin, int end) {
      for (int64_t i = static_cast<int64_t>(begin) * surface.width(); i < static_cast<int64_t>(end) * surface.width();
           ++i)
        falls_.data()[i] = codes_.data()[i] == geom::kOutlet ? Falls{} : falls_of(i);
    });
    find_ways_out(run);
  }

  void run_drop(int64_t cell, Rng& rng) {
    const uint8_t* code = codes_.data();
    while (true) {
      count(water_.passed, cell);
      if (code[cell] == geom::kOutlet) return;
      const Falls& falls = falls_.data()[cell];
      if (falls[7] > 0.0F) {
        cell += steps_[choose(falls, rng)];
      } else if (code[cell] < 8) {
        cell += steps_[code[cell]];
      } else if (!leave(cell, rng)) {
        count(water_.ended, cell);
        return;
      }
    }
  }

  Water take() { return std::move(water_); }

 private:
  static void count(Grid<uint32_t>& counts, int64_t cell) {
    std::atomic_ref(counts.data()[cell]).fetch_add(1, std::memory_order_relaxed);
  }

  Falls falls_of(int64_t cell) const {
    Falls falls{};
    float sum = 0.0F;
    for (size_t k = 0; k < 8; ++k) {
      sum += std::max(0.0F, surface_.data()[cell] - std::max(sea_, surface_.data()[cell + steps_[k]]));
      falls[k] = sum;
    }
    return falls;
  }

  static size_t choose(const Falls& falls, Rng& rng) {
    const float at = static_cast<float>(rng.bits() >> 40) * 0x1p-24F * falls[7];
    size_t k = 0;
    while (k < 7 && !(at < falls[k])) ++k;
    return k;
  }

  /// Of all pits, where many drops end.
  void find_ways_out(const RunContext& run) {
    std::vector<int64_t> pits;
    for (int64_t i = 0; i < surface_.frame().cells(); ++i) {
      if (codes_.data()[i] != geom::kPit || falls_.data()[i][7] > 0.0F) continue;
      pit_.data()[i] = static_cast<int32_t>(pits.size());
      pits.push_back(i);
    }
    ways_.resize(pits.size());
    constexpr int64_t kPitsPerBlock = 64;
    parallel_blocks(run, static_cast<int64_t>(pits.size()), kPitsPerBlock, [&](int64_t begin, int64_t end) {
      for (int64_t k = begin; k < end; ++k)
        ways_[static_cast<size_t>(k)] = way_out(surface_, routes_, pits[static_cast<size_t>(k)]);
    });
  }

  /// Moves a drop from a pit over its lowest pass, if it is to leave and there is one.
  bool leave(int64_t& cell, Rng& rng) {
    const std::optional<WayOut>& way = ways_[static_cast<size_t>(pit_.data()[cell])];
    if (!way || (way->depth_m > params_.shallow_m && !rng.chance(params_.leave))) return false;
    for (cell += steps_[routes_.data()[cell]]; cell != way->end; cell += steps_[routes_.data()[cell]])
      count(water_.passed, cell);
    return true;
  }

  const HeightField& surface_;
  float sea_;
  StochasticFlow params_;
  geom::FlowDirections codes_, routes_;
  Grid<Falls> falls_;
  Grid<int32_t> pit_;  ///< of a pit's cell: its number
  std::vector<std::optional<WayOut>> ways_;
  std::array<int64_t, 8> steps_;
  Water water_;
};

}  // namespace

std::optional<WayOut> way_out(const HeightField& surface, const geom::FlowDirections& routes, int64_t pit) {
  const std::array<int64_t, 8> steps = geom::flow_steps(surface.width());
  const float floor = surface.data()[pit];
  float pass = floor;
  int64_t end = pit;
  do {
    if (routes.data()[end] >= 8) break;
    end += steps[routes.data()[end]];
    pass = std::max(pass, surface.data()[end]);
  } while (surface.data()[end] >= floor);
  if (surface.data()[end] >= floor && routes.data()[end] == geom::kPit) return std::nullopt;
  return WayOut{end, pass - floor};
}

Water stochastic_flow(const HeightField& surface, const Grid<uint8_t>& starts, float sea_level_m, float highest_pass_m,
                      const StochasticFlow& params, Seed seed, const RunContext& run) {
  Rain rain(surface, sea_level_m, highest_pass_m, params, run.part(0.0, 0.2));
  constexpr int64_t kCellsPerBlock = 1024;
  parallel_blocks(run.part(0.2, 1.0), surface.frame().cells(), kCellsPerBlock, [&](int64_t begin, int64_t end) {
    for (int64_t i = begin; i < end; ++i) {
      if (starts.data()[i] == 0) continue;
      Rng rng(seed.derive("drop", static_cast<uint64_t>(i)));
      for (int drop = 0; drop < params.drops; ++drop) rain.run_drop(i, rng);
    }
  });
  return rain.take();
}

}  // namespace seamount::sketch
