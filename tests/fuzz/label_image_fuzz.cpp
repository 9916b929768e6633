// Painted label maps: the first bytes give the sizes of picture and grid, the rest the pixels.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "seamount/base/error.h"
#include "seamount/geom/grid/painted_labels.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace seamount;
  if (size < 4) return 0;
  Image image(1 + data[0] % 32, 1 + data[1] % 32);
  for (size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = size > 4 ? data[4 + i % (size - 4)] : uint8_t{0};
  RunContext run;
  run.threads = 1;
  try {
    const geom::PaintedLabels painted =
        geom::decode_labels(image, GridFrame::centred(1 + data[2] % 40, 1 + data[3] % 40, 1.0), run);
    for (size_t i = 0; i < painted.labels.size(); ++i) {
      float sum = 0;
      for (const Mask& share : painted.shares) sum += share.cells()[i];
      if (!(std::abs(sum - 1) < 1e-3F)) std::abort();
    }
  } catch (const Error&) {
  }
  return 0;
}
