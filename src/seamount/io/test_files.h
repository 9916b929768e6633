// What the tests of this module share: a folder of their own and some terrain.
#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/rng.h"
#include "seamount/io/atomic_file.h"
#include "seamount/model/grid.h"

namespace seamount::io {

/// A new folder that is gone with this object.
class TestFolder {
 public:
  TestFolder() {
    static int count = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("seamount-test-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
    std::filesystem::create_directories(path_);
  }
  ~TestFolder() { std::filesystem::remove_all(path_); }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  std::string operator()(const std::string& name) const { return (path_ / name).string(); }
  size_t files() const {
    size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(path_)) ++count;
    return count;
  }

 private:
  std::filesystem::path path_;
};

/// Stands in for a full disk: no file may grow beyond some bytes.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit small{bytes, old_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit old_{};
  void (*handler_)(int);
};

/// A cone above the sea with rough cells, not symmetric in any way.
inline HeightField test_terrain(const GridFrame& frame, uint64_t seed = 1) {
  HeightField heights(frame);
  Rng rng(Seed{seed}.derive("terrain"));
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const double r = std::hypot(x - 0.4 * frame.width, y - 0.6 * frame.height) / frame.width;
      heights(x, y) = static_cast<float>(900.0 - 2500.0 * r + rng.uniform(-20, 20));
    }
  }
  return heights;
}

inline float largest_difference(const Grid<float>& a, const Grid<float>& b) {
  float largest = 0;
  for (size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a.cells()[i] - b.cells()[i]));
  return largest;
}

/// The message of the Error that `call` throws; empty if it throws none.
template <class Call>
std::string error_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace seamount::io
