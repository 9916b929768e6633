// A random island, sunk a little and ringed by its reef, as heights, labels and a picture.
#include <algorithm>
#include <cstdio>

#include "seamount/io/image_file.h"
#include "seamount/io/raster.h"
#include "seamount/ops/island/build.h"
#include "seamount/ops/island/coral.h"
#include "seamount/ops/render/perspective.h"

int main() {
  using namespace seamount;
  const GridFrame frame = GridFrame::centred(240, 200, 50.0);
  const Seed seed{7};
  const RunContext run;

  const island::Plan plan = island::random_plan(frame, {0, 0}, 0.4, seed, {});
  const island::Island isle = island::build(plan, {.peak_m = 700}, frame, seed, run);
  const island::Reefed reefed =
      island::coral(isle.terrain, isle.labels, &isle.coordinate, {.subsidence = 0.1}, seed, run);

  io::write_heights(reefed.terrain, "island.tif");
  io::write_labels(reefed.labels, "island_labels.png");
  io::write_png(render::perspective(reefed.terrain, &reefed.labels, {.width_px = 480, .height_px = 300}, run),
                "island.png");

  float highest = reefed.terrain(0, 0);
  for (const float z : reefed.terrain.cells()) highest = std::max(highest, z);
  std::printf("an island of %.2f km2, %.0f m high\n", plan.land_m2 / 1e6, highest);
  return highest > 400 ? 0 : 1;
}
