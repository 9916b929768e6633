#include "seamount/ops/render/splat_layers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "seamount/geom/scalar/noise.h"

namespace seamount::render {
namespace {

/// An island on a deep floor: a cone whose flanks rise steeper towards the summit, roughened.
HeightField island(uint64_t seed, int side, double peak_m, double depth_m) {
  HeightField ground = geom::fbm_grid(GridFrame::centred(side, side, 20.0), Seed{seed}, {.wavelength_m = 800}, {});
  const double radius_m = 0.33 * ground.frame().width_m();
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const double in = 1.0 - std::hypot(ground.frame().x(x), ground.frame().y(y)) / radius_m;
      const double height = in > 0 ? peak_m * std::pow(in, 1.5) : std::max(-depth_m, 2 * depth_m * in);
      ground(x, y) = static_cast<float>(height + 0.05 * peak_m * static_cast<double>(ground(x, y)));
    }
  }
  return ground;
}

void expect_sums(const std::vector<GroundLayer>& layers) {
  for (size_t i = 0; i < layers[0].weights.size(); ++i) {
    double sum = 0;
    for (const GroundLayer& layer : layers) {
      ASSERT_GE(layer.weights.cells()[i], 0.0F);
      sum += layer.weights.cells()[i];
    }
    ASSERT_NEAR(sum, 1.0, 1e-4);
  }
}

TEST(SplatLayers, EveryLayerHasASensibleShareOfAnIslandHoweverDeepTheSea) {
  for (const uint64_t seed : {1, 2, 3}) {
    for (const double depth_m : {100.0, 4000.0}) {
      const HeightField ground = island(seed, 150 + 20 * static_cast<int>(seed), 900, depth_m);
      const auto layers = splat_layers(ground, {}, {}, {});
      ASSERT_EQ(layers.size(), terrain_layer_names().size());
      expect_sums(layers);
      for (size_t m = 0; m < layers.size(); ++m) {
        EXPECT_EQ(layers[m].name, terrain_layer_names()[m]);
        double land = 0, share = 0;
        for (size_t i = 0; i < ground.size(); ++i) {
          if (ground.cells()[i] < 0) continue;
          ++land;
          share += layers[m].weights.cells()[i];
        }
        if (layers[m].name == "seabed") {
          EXPECT_LT(share / land, 0.1);
        } else {
          EXPECT_GT(share / land, 0.05) << layers[m].name << " over " << depth_m << " m";
          EXPECT_LT(share / land, 0.85) << layers[m].name << " over " << depth_m << " m";
        }
      }
    }
  }
}

TEST(SplatLayers, BordersAreAsWideAsAskedFor) {
  LabelMap halves(GridFrame::centred(200, 4, 10.0), Region::beach);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 100; ++x) halves(x, y) = Region::reef;
  for (const double soft_m : {60.0, 200.0, 400.0}) {
    const auto layers = splat_layers(halves, halves.frame(), soft_m, {});
    expect_sums(layers);
    const Mask& beach = layers[1].weights;
    double mixed = 0;
    for (int x = 0; x < 200; ++x) mixed += beach(x, 2) > 0.1F && beach(x, 2) < 0.9F ? 10.0 : 0.0;
    EXPECT_NEAR(mixed, soft_m, 0.1 * soft_m + 20.0);
  }
  for (const GroundLayer& layer : splat_layers(halves, halves.frame(), 0.0, {}))
    for (const float weight : layer.weights.cells()) ASSERT_TRUE(weight == 0 || weight == 1);
  EXPECT_THROW(splat_layers(halves, halves.frame(), -1.0, {}), InvalidArgument);
}

TEST(SplatLayers, RegionsKeepTheirSharesOnFinerAndCoarserSamples) {
  LabelMap labels(GridFrame::centred(120, 120, 10.0), Region::abyss);
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 120; ++x)
      labels(x, y) = kRegions[static_cast<size_t>(std::min(4.0, std::hypot(x - 60.0, y - 55.0) / 12.0))];
  const auto share = [](const GroundLayer& layer) {
    double sum = 0;
    for (const float weight : layer.weights.cells()) sum += static_cast<double>(weight);
    return sum / static_cast<double>(layer.weights.size());
  };
  const auto own = splat_layers(labels, labels.frame(), {}, {});
  for (const int size : {61, 253}) {
    GridFrame frame = labels.frame();
    frame.width = frame.height = size;
    frame.cell_m = 1200.0 / size;
    const auto layers = splat_layers(labels, frame, {}, {});
    expect_sums(layers);
    for (size_t m = 0; m < layers.size(); ++m) {
      EXPECT_EQ(layers[m].name, region_layer_names()[m]);
      EXPECT_NEAR(share(layers[m]), share(own[m]), 0.01) << size << layers[m].name;
    }
  }
}

}  // namespace
}  // namespace seamount::render
