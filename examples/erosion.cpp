// Hills of noise, worn by twenty thousand years of rain, with their rivers.
#include <cstdio>

#include "seamount/io/raster.h"
#include "seamount/ops/erosion/run.h"
#include "seamount/ops/terrain/noise.h"

int main() {
  using namespace seamount;
  const GridFrame frame = GridFrame::centred(160, 120, 100.0);
  RunContext run;
  run.note = [](const std::string& line) { std::printf("note: %s\n", line.c_str()); };

  const HeightField hills = terrain::noise({.kind = terrain::NoiseKind::smooth}, frame, Seed{5}, run);
  // No rock or sediment lies there yet; hardness, mask, uplift and rain are the same everywhere.
  const erosion::Eroded worn = erosion::run({hills, ScalarField(frame, 0.0F), ScalarField(frame, 0.0F)}, {},
                                            {.years = 20000, .sea_m = -10000}, Seed{5}, run);
  io::write_heights(worn.terrain, "worn.tif");
  io::write_field(worn.flow, "flow.tif");
  std::printf("%.4f km3 eroded, %.4f km3 laid down again\n", worn.ledger.eroded / 1e9, worn.ledger.deposited / 1e9);
  return worn.terrain == hills ? 1 : 0;
}
