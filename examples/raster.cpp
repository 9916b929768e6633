// Makes a terrain by hand, writes it as GeoTIFF, reads it back and sums it in parallel.
#include <cmath>
#include <cstdio>

#include "seamount/base/parallel.h"
#include "seamount/io/raster.h"

int main() {
  // 300 x 200 cells of 10 m around (0, 0): a cone of 500 m in a sea of 50 m.
  seamount::HeightField cone(seamount::GridFrame::centred(300, 200, 10.0));
  const seamount::GridFrame& frame = cone.frame();
  for (int y = 0; y < cone.height(); ++y) {
    for (int x = 0; x < cone.width(); ++x) {
      const double distance = std::hypot(frame.x(x), frame.y(y));
      cone(x, y) = static_cast<float>(std::fmax(500.0 - 0.8 * distance, -50.0));
    }
  }
  seamount::io::write_heights(cone, "cone.tif");
  const seamount::HeightField read = seamount::io::read_heights("cone.tif");

  // Blocks of rows, each summed by one thread and added in their order: the same sum with any number of threads.
  const seamount::RunContext run;
  const double volume_m3 = seamount::parallel_sum<double>(run, read.height(), 16, [&](int64_t begin, int64_t end) {
    double sum = 0.0;
    for (int64_t y = begin; y < end; ++y)
      for (const float z : read.row(static_cast<int>(y)))
        if (z > 0) sum += z * read.cell_m() * read.cell_m();
    return sum;
  });
  std::printf("%d x %d cells, %.4f km3 above the sea\n", read.width(), read.height(), volume_m3 / 1e9);
  return read == cone ? 0 : 1;
}
