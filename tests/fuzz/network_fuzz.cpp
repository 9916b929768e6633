// Networks from PLY files in memory.
#include <cstddef>
#include <cstdint>

#include "seamount/base/error.h"
#include "seamount/geom/contour/marching_triangles.h"
#include "seamount/io/tin_file.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace seamount;
  try {
    geom::find_tin_defect(io::read_tin({data, size}, "fuzz.ply"));
  } catch (const Error&) {
  }
  return 0;
}
