// GeoJSON and SVG in memory, all features and one by name.
#include <cstddef>
#include <cstdint>
#include <span>

#include "seamount/base/error.h"
#include "seamount/io/vector.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace seamount;
  for (const char* feature : {"", "a"}) {
    try {
      io::read_geojson({data, size}, "fuzz.geojson", {.feature = feature});
    } catch (const Error&) {
    }
    try {
      io::read_svg({data, size}, "fuzz.svg", {.feature = feature});
    } catch (const Error&) {
    }
  }
  return 0;
}
