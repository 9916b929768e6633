// What `seamount info` reads of meshes: the first byte says which format the rest is taken as.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "seamount/base/error.h"
#include "seamount/io/mesh_info.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  constexpr std::array<const char*, 4> kNames = {"x.glb", "x.obj", "x.ply", "x.stl"};
  try {
    seamount::io::describe_mesh(std::span(data, size).subspan(1), kNames[data[0] % kNames.size()]);
  } catch (const seamount::IoError&) {  // what is not a mesh is refused
  }
  return 0;
}
