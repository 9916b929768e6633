#include "seamount/io/geotiff_rows.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>

#include "seamount/io/atomic_file.h"

namespace seamount::io {
namespace {

namespace fs = std::filesystem;

/// Packed by several threads, tiles stand in the file as one thread would write them.
TEST(GeotiffRows, TheBytesHangNotOnThreads) {
  const GridFrame frame{1700, 1300, 10.0, 0.0, 0.0, "EPSG:32627"};
  const fs::path folder = fs::temp_directory_path() / ("seamount_rows_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  std::vector<std::vector<uint8_t>> files;
  for (const int threads : {1, 2, 5}) {
    for (const CellMeaning meaning : {CellMeaning::heights, CellMeaning::regions}) {
      const bool bytes = meaning == CellMeaning::regions;
      const RowSource rows = [&](int first, int count, void* cells) {
        for (int64_t i = 0; i < int64_t{count} * frame.width; ++i) {
          const int64_t cell = int64_t{first} * frame.width + i;
          if (bytes)
            static_cast<uint8_t*>(cells)[i] = static_cast<uint8_t>(cell / 777 % 5);
          else
            static_cast<float*>(cells)[i] = static_cast<float>(std::sin(0.001 * static_cast<double>(cell % 12345)));
        }
      };
      const std::string path = (folder / "rows.tif").string();
      write_geotiff_rows(frame, meaning, rows, path, {}, false, {.threads = threads});
      files.push_back(read_file(path));
    }
  }
  fs::remove_all(folder);
  for (size_t i = 2; i < files.size(); ++i) EXPECT_TRUE(files[i] == files[i % 2]) << i;
}

}  // namespace
}  // namespace seamount::io
