// Real elevation models for tests: looked for in the folder $SEAMOUNT_DEM_DIR, else in ../shared/data/dem beside the
// checkout. They are not part of the repository; a test without them says so and is skipped.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#ifndef SEAMOUNT_SOURCE_DIR  // test programs are told; the header compiles without
#define SEAMOUNT_SOURCE_DIR "."
#endif

namespace seamount::recipe {

/// The path of `name`.tif, if it is there.
inline std::optional<std::string> find_dem(const std::string& name) {
  namespace fs = std::filesystem;
  const char* folder = std::getenv("SEAMOUNT_DEM_DIR");
  const fs::path path =
      (folder != nullptr ? fs::path(folder) : fs::path(SEAMOUNT_SOURCE_DIR) / "../shared/data/dem") / (name + ".tif");
  std::error_code error;
  return fs::exists(path, error) ? std::optional<std::string>(path.string()) : std::nullopt;
}

}  // namespace seamount::recipe
