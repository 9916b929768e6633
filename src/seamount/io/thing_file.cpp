#include "seamount/io/thing_file.h"

#include <filesystem>

#include "seamount/base/error.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/thing_parts.h"

namespace seamount::io {
namespace {

std::string_view text_of(std::span<const uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The materials beside an OBJ; empty if there are none. Only a plain name in the same folder is followed.
std::string materials_beside(const std::string& path, std::string_view text) {
  const std::filesystem::path name(obj_materials(text));
  if (name.empty() || name.has_parent_path()) return "";
  const std::string file = (std::filesystem::path(path).parent_path() / name).string();
  constexpr uint64_t kMost = uint64_t{1} << 20;
  try {
    const auto bytes = read_file(file, kMost);
    return std::string(text_of(bytes));
  } catch (const IoError&) {
    return "";
  }
}

}  // namespace

ThingMesh read_thing(std::span<const uint8_t> bytes, const std::string& name, const RunContext& run) {
  const std::string extension = extension_of(name);
  if (extension == ".obj") return obj_thing(text_of(bytes), name, "", run);
  if (extension == ".glb") return glb_thing(bytes, name, run);
  throw IoError(name, "is no .glb or .obj file");
}

ThingMesh read_thing(const std::string& path, const RunContext& run) {
  const std::string extension = extension_of(path);
  if (extension != ".obj" && extension != ".glb") throw IoError(path, "is no .glb or .obj file");
  constexpr uint64_t kMost = uint64_t{256} << 20;
  const auto bytes = read_file(path, kMost);
  if (extension == ".glb") return glb_thing(bytes, path, run);
  const std::string materials = materials_beside(path, text_of(bytes));
  if (materials.empty() && !obj_materials(text_of(bytes)).empty())
    run.say(path + ": its materials are not to be read; it is grey where it has no colours of its own");
  return obj_thing(text_of(bytes), path, materials, run);
}

}  // namespace seamount::io
