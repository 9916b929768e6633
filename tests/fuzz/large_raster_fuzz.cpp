// GeoTIFFs that are read window by window: whatever they are, they have the cells of the file read as a whole.
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>

#include "seamount/base/error.h"
#include "seamount/io/large_raster.h"
#include "seamount/io/raster.h"

namespace {

using namespace seamount;

constexpr int64_t kMostCells = 1 << 16;

/// A file for each process; its name goes with it.
std::string file_of(const uint8_t* data, size_t size) {
  static const std::string path =
      (std::filesystem::temp_directory_path() / ("seamount_fuzz_" + std::to_string(getpid()) + ".tif")).string();
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr || std::fwrite(data, 1, size, file) != size || std::fclose(file) != 0) std::abort();
  return path;
}

std::optional<HeightField> whole(const std::string& path, const io::ReadOptions& options) {
  try {
    return io::read_heights(path, options);
  } catch (const Error&) {
    return std::nullopt;
  }
}

void read_windows(const std::string& path, const io::ReadOptions& options) {
  const io::LargeRaster raster(path, options);
  const GridFrame& frame = raster.frame();
  if (frame.cells() > kMostCells) return;
  const std::optional<HeightField> all = whole(path, options);
  if (!all || !(all->frame() == frame)) std::abort();
  const int width = (frame.width + 2) / 3, height = (frame.height + 1) / 2;
  for (int row = 0; row < frame.height; row += height) {
    for (int column = 0; column < frame.width; column += width) {
      const GridFrame window =
          frame.window(column, row, std::min(width, frame.width - column), std::min(height, frame.height - row));
      const HeightField part = raster.read(window, {});
      for (int y = 0; y < part.height(); ++y) {
        const auto cells = part.row(y), expected = all->row(row + y).subspan(static_cast<size_t>(column), cells.size());
        if (std::memcmp(cells.data(), expected.data(), cells.size_bytes()) != 0) std::abort();
      }
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string path = file_of(data, size);
  try {
    const auto [width, height] = io::stored_size(path);
    if (int64_t{width} * height <= kMostCells) read_windows(path, {.max_cells = kMostCells});
  } catch (const Error&) {
  }
  std::remove(path.c_str());
  return 0;
}
