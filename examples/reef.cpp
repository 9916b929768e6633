// A barrier reef on a shelf of one's own making, and its outlines for a GIS.
#include <cstdio>

#include "seamount/io/raster.h"
#include "seamount/io/vector.h"
#include "seamount/ops/reef/grow.h"
#include "seamount/ops/terrain/noise.h"

int main() {
  using namespace seamount;
  const GridFrame frame = GridFrame::centred(200, 200, 20.0);
  const RunContext run;

  HeightField shelf = terrain::noise({.kind = terrain::NoiseKind::smooth}, frame, Seed{1}, run);
  for (float& z : shelf.cells()) z = -15.0F + 0.01F * z;  // a sea floor 15 m down, hardly uneven

  const reef::Grown grown = reef::grow({.terrain = shelf}, {}, Seed{2}, run);
  io::write_heights(grown.terrain, "reef.tif");
  io::write_drawing(reef::reef_outlines(grown.aggregate, run), "reef.geojson");

  int64_t on_reef = 0;
  for (const float a : grown.aggregate.cells()) on_reef += a >= 0.5F ? 1 : 0;
  std::printf("%.1f %% of the shelf are reef\n",
              100.0 * static_cast<double>(on_reef) / static_cast<double>(frame.cells()));
  return on_reef > 0 ? 0 : 1;
}
