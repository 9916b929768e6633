// A mesh of the user's as the model of a thing: the first byte says which format the rest is taken as.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "seamount/base/error.h"
#include "seamount/io/thing_file.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  constexpr std::array<const char*, 2> kNames = {"x.glb", "x.obj"};
  try {
    seamount::io::read_thing(std::span(data, size).subspan(1), kNames[data[0] % kNames.size()]);
  } catch (const seamount::IoError&) {  // what is not a mesh is refused
  }
  return 0;
}
