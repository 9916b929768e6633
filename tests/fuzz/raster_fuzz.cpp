// Rasters in memory: the first byte chooses the format, the rest is the file.
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "seamount/base/error.h"
#include "seamount/io/image_file.h"
#include "seamount/io/raster.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace seamount;
  if (size < 1) return 0;
  const std::span<const uint8_t> file(data + 1, size - 1);
  const auto& extensions = io::readable_raster_extensions();
  const auto coding = static_cast<io::ElevationCoding>(data[0] / (extensions.size() + 1) % 3);
  const io::ReadOptions options{.cell_m = 1.0, .range = io::HeightRange{0, 1}, .coding = coding, .max_cells = 1 << 16};
  try {
    if (data[0] % (extensions.size() + 1) == extensions.size()) {
      io::read_image(file, "fuzz.png");
    } else {
      io::read_heights(file, "fuzz" + extensions[data[0] % (extensions.size() + 1)], options);
    }
  } catch (const Error&) {
  }
  return 0;
}
