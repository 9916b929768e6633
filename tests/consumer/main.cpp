// Makes a terrain and sums it in parallel with the installed library.
#include <cstdio>

#include "seamount/base/parallel.h"
#include "seamount/model/grid.h"

int main() {
  seamount::HeightField terrain(seamount::GridFrame::centred(64, 32, 10.0), 2.5F);
  const double total = seamount::parallel_sum<double>({}, terrain.height(), 4, [&](int64_t begin, int64_t end) {
    double sum = 0.0;
    for (int64_t y = begin; y < end; ++y) {
      for (const float z : terrain.row(static_cast<int>(y))) sum += z;
    }
    return sum;
  });
  std::printf("%g m over %lld cells\n", total, static_cast<long long>(terrain.frame().cells()));
  return total == 2.5 * 64 * 32 ? 0 : 1;
}
