// Speed of growth: one iteration of a scene that is full of life.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <string>

#include "seamount/base/rng.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/ops/ecosystem/grow.h"

namespace {

using namespace seamount;

constexpr int kClasses = 5;

/// Six materials that slopes and currents move, two of them turning into others.
std::vector<Material> materials() {
  std::vector<Material> made;
  for (const char* name : {"sand", "lime", "silt", "polyp", "food", "rubble"}) {
    Material material;
    material.name = name;
    material.density = 0.05 + 0.02 * static_cast<double>(made.size());
    material.flow_coupling = 0.3 + 0.1 * static_cast<double>(made.size());
    material.diffusivity_m2_s = 2.0;
    material.decay_1_s = 0.005;
    made.push_back(material);
  }
  return made;
}

/// Five classes of points that read materials, depth, current, themselves and one another; two push the water about,
/// one raises the ground.
Catalogue reef_life() {
  Catalogue catalogue;
  catalogue.materials = materials();
  catalogue.transformations = {{"rubble", "sand", 0.002, 1.0}, {"sand", "silt", 0.001, 1.0}};
  for (int c = 0; c < kClasses; ++c) {
    const std::string self = "class" + std::to_string(c), other = "class" + std::to_string((c + 1) % kClasses);
    ObjectClass of;
    of.name = self;
    of.fitness = "bell(depth, 12, 14) * ramp(silt, 9, 3) * ramp(current, 3, 1) * ramp(distance(" + self +
                 "), 1, 5) + 0.02 * min(1, lime + food) + 0.05 * ramp(distance(" + other + "), 90, 0) + 0.01 * polyp";
    of.birth = 0.5;
    of.death = 0.2;
    of.shape = {.size_m = 6.0, .variation = 0.3, .steps = 4};
    of.placement.per_iteration = 4;
    of.placement.most = 1 << 20;
    of.placement.spacing_m = 4.0;
    of.deposits = {{catalogue.materials[static_cast<size_t>(c)].name, 0.01, 8.0}, {"rubble", 0.002, 12.0}};
    if (c == 1 || c == 2) of.currents = {{CurrentShape::scale, 0.02, 12.0}};
    if (c == 3) of.height = {HeightShape::bump, HeightGroup::surface, 0.5, 16.0};
    catalogue.classes.push_back(of);
  }
  return catalogue;
}

HeightField floor_of_hills(int cells) {
  const GridFrame frame = GridFrame::centred(cells, cells, 4.0);
  HeightField ground = geom::fbm_grid(frame, Seed{3}, {.wavelength_m = 600.0, .octaves = 5}, {});
  for (float& z : ground.cells()) z = -12.0F + 8.0F * z;
  return ground;
}

/// So many objects, after some iterations in which whatever cannot live died.
Scene settled(int64_t objects, const HeightField& ground, const Catalogue& catalogue) {
  Scene scene;
  scene.catalogue = catalogue;
  scene.frame = ground.frame();
  scene.surroundings.current_m_s = 0.3;
  scene.seed = 5;
  Rng rng(Seed{8});
  for (int64_t i = 0; i < objects; ++i) {
    const Vec2 at{rng.uniform(scene.frame.west_m, scene.frame.east_m()),
                  rng.uniform(scene.frame.south_m(), scene.frame.north_m)};
    scene.objects.push_back({.id = scene.next_id++,
                             .of_class = static_cast<int>(i % kClasses),
                             .skeleton = {SkeletonKind::point, {at}},
                             .size = std::exp(0.3 * rng.normal())});
  }
  ecosystem::GrowParams params;
  params.iterations = 3;
  return ecosystem::grow({ground, nullptr, &scene}, params, Seed{1}, {}).scene;
}

double seconds_of(int iterations, const HeightField& ground, const Scene& scene) {
  ecosystem::GrowParams params;
  params.iterations = iterations;
  const auto begin = std::chrono::steady_clock::now();
  benchmark::DoNotOptimize(ecosystem::grow({ground, nullptr, &scene}, params, Seed{1}, {}));
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Arguments: objects, cells a side (100 000 as densely as 10 000). The time of an iteration without that of beginning
/// and ending.
void step(benchmark::State& state) {
  const HeightField ground = floor_of_hills(static_cast<int>(state.range(1)));
  const Scene scene = settled(state.range(0), ground, reef_life());
  for (auto _ : state) {
    const double one = seconds_of(1, ground, scene);
    state.SetIterationTime((seconds_of(5, ground, scene) - one) / 4.0);
  }
  state.counters["objects"] = static_cast<double>(scene.objects.size());
}
BENCHMARK(step)
    ->Name("ecosystem/step")
    ->Args({1000, 512})
    ->Args({10000, 512})
    ->Args({100000, 1620})
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();

}  // namespace
