// The shipped networks. Golden recipes cannot hold them, for their bits are promised on one machine only (ADR 14).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "seamount/geom/scalar/noise.h"
#include "seamount/io/find_model.h"
#include "seamount/io/weights.h"
#include "seamount/ops/erosion/run.h"
#include "seamount/ops/learned/erode.h"
#include "seamount/recipe/test_calls.h"

namespace seamount::recipe {
namespace {

HeightField made(const std::string& name, const Json& params, uint64_t seed, Values in = {}) {
  const Extent extent{128, 96, 500};
  const Operator& op = *standard_registry().find_operator(name);
  if (name == "learned.island" && in.empty()) in["labels"] = example_values(extent).at("labels");
  Diagnostics diagnostics;
  const Json complete = op.complete(params, {"", diagnostics});
  EXPECT_TRUE(diagnostics.empty());
  const GridFrame frame = frame_of(extent);
  const std::string folder;
  const RunContext run;
  return op.run(complete, in, {frame, true, Seed{seed}, folder, run}).at("terrain").get<kinds::Terrain>();
}

TEST(ShippedNetworks, AreSoundInEitherPrecision) {
  for (const std::string name : {"learned.sketch", "learned.island"}) {
    const HeightField plain = made(name, {{"precision", "f32"}}, 3),
                      other = made(name, {{"precision", "automatic"}}, 3);
    const auto [low, high] = std::minmax_element(plain.cells().begin(), plain.cells().end());
    EXPECT_GT(*high - *low, 50) << name;
    EXPECT_LT(*high - *low, 6000) << name;
    double off = 0;
    for (size_t i = 0; i < plain.size(); ++i) {
      ASSERT_TRUE(std::isfinite(plain.data()[i])) << name;
      off += std::abs(plain.data()[i] - other.data()[i]);
    }
    EXPECT_LT(off / static_cast<double>(plain.size()), 0.01 * (*high - *low)) << name;
    EXPECT_EQ(other, made(name, {{"precision", "automatic"}}, 3)) << name;
    EXPECT_NE(plain, made(name, {{"precision", "f32"}}, 4)) << name;
  }
}

/// A round island with its reef.
LabelMap round_island() {
  LabelMap labels(GridFrame::centred(128, 128, 160), Region::abyss);
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) {
      const double r = std::hypot(labels.frame().x(x), labels.frame().y(y));
      labels(x, y) = r < 2400   ? Region::mountain
                     : r < 2800 ? Region::beach
                     : r < 4000 ? Region::lagoon
                     : r < 4600 ? Region::reef
                                : Region::abyss;
    }
  }
  return labels;
}

/// Mean eastward place of the land.
double land_east_m(const HeightField& z) {
  double sum = 0;
  int cells = 0;
  for (int y = 0; y < z.height(); ++y) {
    for (int x = 0; x < z.width(); ++x) {
      if (z(x, y) <= 0) continue;
      sum += z.frame().x(x);
      ++cells;
    }
  }
  return sum / cells;
}

TEST(ShippedNetworks, IslandsYieldToTheirWind) {
  const Values in = {{"labels", Value::of<kinds::Labels>(round_island())}};
  const Json west_wind = {{{"points", {{-8000, 0}, {8000, 0}}}, {"width_m", 3000}, {"strength_m", 1500}}};
  const HeightField still = made("learned.island", Json::object(), 3, in),
                    bent = made("learned.island", {{"strokes", west_wind}}, 3, in);
  EXPECT_GT(land_east_m(bent), land_east_m(still) + 300);
}

/// Ground that no training shows: hills of another noise.
HeightField hills() {
  HeightField z = geom::fbm_grid(GridFrame::centred(192, 192, 40), Seed{71}, {.wavelength_m = 2600, .octaves = 7}, {});
  for (float& h : z.cells()) h = 700 * h + 900;
  return z;
}

double mean_off(const HeightField& a, const HeightField& b) {
  double sum = 0;
  for (size_t i = 0; i < a.size(); ++i) sum += std::abs(a.data()[i] - b.data()[i]);
  return sum / static_cast<double>(a.size());
}

TEST(ShippedNetworks, ErodeIsNearTheSimulation) {
  const learned::Network network(io::read_weights(io::find_model("erode")), learned::Precision::f32);
  const HeightField ground = hills();
  // How far off as a share of the change made, where no change is 1; seen: 0.48 and 0.77.
  for (const auto& [years, most_off] : {std::pair{10000.0, 0.55}, {100000.0, 0.85}}) {
    erosion::RunParams simulated;
    simulated.years = years;
    simulated.hardness_variation = 0;
    const HeightField real = erosion::run({ground, {}, {}}, {}, simulated, Seed{2}, {}).terrain;
    learned::ErodeParams params;
    params.years = years;
    const HeightField made = learned::erode(ground, nullptr, params, network, {});
    EXPECT_LT(mean_off(made, real), most_off * mean_off(ground, real)) << years;
  }
}

TEST(ShippedNetworks, ErodeKeepsReliefWhenRepeated) {
  const learned::Network network(io::read_weights(io::find_model("erode")));
  HeightField ground = hills();
  const auto relief = [&] {
    const auto [low, high] = std::minmax_element(ground.cells().begin(), ground.cells().end());
    return *high - *low;
  };
  const float first = relief();
  float last = first;
  for (int i = 0; i < 20; ++i) {
    ground = learned::erode(ground, nullptr, {}, network, {});
    for (const float z : ground.cells()) ASSERT_TRUE(std::isfinite(z));
    ASSERT_LE(relief(), last);
    last = relief();
  }
  EXPECT_GT(last, 0.1 * first);
}

}  // namespace
}  // namespace seamount::recipe
