// Files of weights: whatever the bytes, they are read or refused as IoError, and what was read is written and read back
// as the same.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "seamount/base/error.h"
#include "seamount/io/weights.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace seamount;
  try {
    const Weights read = io::read_weights({data, size}, "fuzz.safetensors");
    if (io::read_weights(io::encode_weights(read, io::WeightType::f32), "again") != read) std::abort();
  } catch (const IoError&) {
  }
  return 0;
}
