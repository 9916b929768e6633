// Real elevation models for tests and benchmarks that have them: they are too large for the repository. Looked for in
// the folder that the environment variable SEAMOUNT_DEMS names, else in ../shared/data/dem beside the checkout.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

namespace seamount::recipe {

/// The path of a real elevation model ("alps_n46e008_3arcsec.tif"), or nothing: the test then calls GTEST_SKIP().
inline std::optional<std::string> find_dem(const std::string& name) {
  const char* given = std::getenv("SEAMOUNT_DEMS");
  const std::filesystem::path beside = std::filesystem::path(__FILE__).parent_path() / "../../../../shared/data/dem";
  const std::filesystem::path path = (given != nullptr ? std::filesystem::path(given) : beside) / name;
  if (!std::filesystem::exists(path)) return std::nullopt;
  return path.string();
}

}  // namespace seamount::recipe
