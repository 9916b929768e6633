#include "seamount/ops/erosion/undermining.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "seamount/geom/scalar/noise.h"
#include "seamount/ops/erosion/rivers.h"

namespace seamount::erosion {
namespace {

/// A plateau over a lowland in the west, capped by hard rock.
Layers plateau(uint64_t seed) {
  const GridFrame frame = GridFrame::centred(96, 64, 50);
  const geom::Fbm shape{.wavelength_m = 1500, .octaves = 6, .cell_m = frame.cell_m};
  HeightField z = geom::fbm_grid(frame, Seed{seed}, shape, {});
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 96; ++x)
      z(x, y) = x < 8 ? static_cast<float>(x) : 300 + 2.0F * static_cast<float>(x) + 10 * z(x, y);
  }
  return {std::move(z), ScalarField(frame, 0.0F), ScalarField(frame, 0.0F)};
}

const Lithology& capped() {
  static const Lithology rock({.beds = {{"cap", 80, 10}, {"shale", 1000, 0.3}}, .repeat = false, .top_m = 500},
                              Seed{1});
  return rock;
}

/// What so many steps of all in all 40 000 years leave.
HeightField worn(uint64_t seed, int steps) {
  Layers ground = plateau(seed);
  const GridFrame frame = ground.frame();
  Maps site;
  Beds beds(capped(), frame, {});
  site.beds = &beds;
  Grid<uint8_t> outlets(frame, 0);
  for (int y = 0; y < 64; ++y) outlets(0, y) = 1;
  Drainage drainage;
  ScalarField room(frame), flow(frame), load(frame), level(frame);
  Ledger ledger;
  const Rivers rivers{.years = 40000.0 / steps, .erodibility = 1e-5, .deposition = 0, .steepest = 0.84, .sea_m = -1000};
  for (int i = 0; i < steps; ++i) {
    beds.settle(ground, site, 0, {});
    drainage.route(ground.surface, outlets, {-1000}, Seed{static_cast<uint64_t>(i)}, room, {});
    gather(drainage, site, rivers, flow, {});
    run_rivers(ground, site, drainage, flow, rivers, load, level, ledger, {});
  }
  return std::move(ground.surface);
}

TEST(Undermining, StepsOfAnyLengthTakeAScarpAsFarBack) {
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    const HeightField start = plateau(seed).surface, slow = worn(seed, 160);
    const auto gone = [&](const HeightField& z) {
      double sum = 0;
      for (size_t i = 0; i < z.size(); ++i) sum += start.data()[i] - z.data()[i];
      return sum / static_cast<double>(z.size());
    };
    EXPECT_GT(gone(slow), 50) << seed;
    for (const int steps : {8, 24}) EXPECT_NEAR(gone(worn(seed, steps)), gone(slow), 0.2 * gone(slow)) << steps;
  }
}

TEST(Undermining, NothingFailsWithoutBeds) {
  const Drainage drainage;
  Undermining none({}, drainage, 0.8);
  EXPECT_EQ(none.standing(100, 0, 500), 500);
  EXPECT_EQ(none.time_left(100, 400, 500, 1), 1.0F);
}

}  // namespace
}  // namespace seamount::erosion
