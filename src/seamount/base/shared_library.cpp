#include "seamount/base/shared_library.h"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>

#include "seamount/base/error.h"
#include "seamount/base/installation.h"

namespace seamount {

std::optional<std::string> find_part(const std::string& file) {
  std::error_code error;
  if (const char* const folder = std::getenv("SEAMOUNT_PARTS");
      folder != nullptr && std::filesystem::exists(std::filesystem::path(folder) / file, error))
    return (std::filesystem::path(folder) / file).string();
  const std::filesystem::path program = program_file();
  if (program.empty()) return std::nullopt;
  for (const std::filesystem::path& folder :
       {program.parent_path(), program.parent_path().parent_path() / "lib" / "seamount"}) {
    const std::filesystem::path path = folder / file;
    if (std::filesystem::exists(path, error)) return path.string();
  }
  return std::nullopt;
}

void* load_function(const std::string& library, const char* function) {
  void* const handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) throw Error(library + " cannot be loaded: " + dlerror());
  void* const found = dlsym(handle, function);
  if (found == nullptr) throw Error(library + " has no " + function + ": it is of another version");
  return found;
}

}  // namespace seamount
