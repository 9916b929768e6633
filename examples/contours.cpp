// Mountains from one drawn outline: a network grows in it, gets heights, and becomes contours and a terrain.
#include <cstdio>

#include "seamount/geom/contour/lines.h"
#include "seamount/io/raster.h"
#include "seamount/io/vector.h"
#include "seamount/ops/contour/convert/extract.h"
#include "seamount/ops/contour/convert/reconstruct.h"
#include "seamount/ops/contour/growth/grow.h"
#include "seamount/ops/contour/heights/heights.h"

int main() {
  using namespace seamount;
  const GridFrame domain = GridFrame::centred(200, 150, 100.0);
  const RunContext run;

  RegionOutline coast;
  coast.name = "coast";
  coast.ring = {{-7000, -4000}, {1000, -5500}, {7500, -2500}, {6000, 4000}, {-1000, 5000}, {-6500, 2000}};
  const contour::RegionTree regions = contour::regions_from_outlines({coast}, domain, "outlines");
  Tin network = contour::grow(regions, domain, nullptr, {}, {.particles = 4000}, Seed{3}, run);
  network = contour::heights(std::move(network), nullptr, {.max_m = 1500}, run);

  const ContourSet contours = contour::extract(network, {.interval_m = 50}, run);
  io::write_drawing(geom::to_lines(contours), "contours.gpkg");
  io::write_heights(contour::reconstruct(contours, {}, run), "mountains.tif");
  std::printf("%zu contours of %zu nodes\n", contours.contours.size(), network.nodes.size());
  return contours.contours.size() > 20 ? 0 : 1;
}
