#include <benchmark/benchmark.h>

#include <filesystem>

#include "seamount/io/things_file.h"
#include "seamount/ops/ecosystem/place_things.h"
#include "seamount/ops/render/perspective.h"
#include "seamount/ops/render/test_terrain.h"

namespace seamount {
namespace {

HeightField terrain() { return render::test_island(512, 512, 3000.0, 200.0); }

std::vector<ecosystem::ThingSpec> specs() {
  std::vector<ecosystem::ThingSpec> all;
  for (const ThingForm form : {ThingForm::palm, ThingForm::broadleaf, ThingForm::rock, ThingForm::shrub})
    all.push_back({std::string(Choices<ThingForm>::names[static_cast<size_t>(form)]), {.shape = form}});
  return all;
}

std::vector<ecosystem::ThingPlace> placements(const HeightField& ground, int count) {
  Rng rng(Seed{1});
  std::vector<ecosystem::ThingPlace> all;
  const GridFrame& f = ground.frame();
  while (all.size() < static_cast<size_t>(count)) {
    const Vec2 place{rng.uniform(f.west_m, f.east_m()), rng.uniform(f.south_m(), f.north_m)};
    const float z = ground.clamped(static_cast<int>(f.column(place.x) + 0.5), static_cast<int>(f.row(place.y) + 0.5));
    if (z < 1.0F) continue;
    all.push_back({.place = place, .spec = static_cast<uint32_t>(rng.integer(0, 3)), .key = rng.bits()});
  }
  return all;
}

void place_and_write(benchmark::State& state) {
  const HeightField ground = terrain();
  const auto where = placements(ground, 10000);
  const std::string path = (std::filesystem::temp_directory_path() / "seamount_bench_things.glb").string();
  for (auto _ : state) {
    const Things all = place_things(ground, specs(), where, {.keep_ground = false}, {1}, {});
    io::write_things_glb(all, path);
  }
  std::filesystem::remove(path);
}
BENCHMARK(place_and_write)->Name("ecosystem/things/10k")->Unit(benchmark::kMillisecond);

void draw(benchmark::State& state) {
  const HeightField ground = terrain();
  const Things all = place_things(ground, specs(), placements(ground, 10000), {}, {1}, {});
  for (auto _ : state) benchmark::DoNotOptimize(render::perspective(ground, {.things = &all}, {}, {}));
}
BENCHMARK(draw)->Name("render/perspective_of_10k_things/1280x720")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace seamount
