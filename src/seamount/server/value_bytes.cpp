#include "seamount/server/value_bytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/parallel.h"
#include "seamount/io/image_file.h"
#include "seamount/io/report.h"
#include "seamount/recipe/kinds.h"

namespace seamount::server {
namespace {

namespace kinds = recipe::kinds;

[[noreturn]] void throw_wrong_kind(const recipe::Value& value, const char* wanted) {
  throw IncompatibleInputs(fmt::format("a result of the kind '{}' cannot be had as {}", value.kind().name, wanted));
}

/// Cells along one side at a level, at least one.
int cells_at(int cells, int level) { return std::max(1, (cells + (1 << level) - 1) >> level); }

struct Cut {
  int columns, rows, step;
};

Cut cut_of(const GridFrame& frame, const RasterWindow& window) {
  if (window.level < 0 || window.level > 16) throw InvalidArgument("level", "is outside [0, 16]");
  const int wide = cells_at(frame.width, window.level), high = cells_at(frame.height, window.level);
  if (window.x < 0 || window.x >= wide) throw InvalidArgument("x", "lies outside the raster");
  if (window.y < 0 || window.y >= high) throw InvalidArgument("y", "lies outside the raster");
  const Cut cut{window.columns.value_or(wide - window.x), window.rows.value_or(high - window.y), 1 << window.level};
  if (cut.columns < 1 || cut.columns > wide - window.x) throw InvalidArgument("columns", "lies outside the raster");
  if (cut.rows < 1 || cut.rows > high - window.y) throw InvalidArgument("rows", "lies outside the raster");
  return cut;
}

/// Calls put(bytes of a row's cells, row) for each row of the window; `size`: bytes of a cell.
template <class PutCell>
RasterBytes cut_out(const GridFrame& frame, const RasterWindow& window, std::string type, size_t size,
                    const PutCell& put) {
  const Cut cut = cut_of(frame, window);
  RasterBytes result{cut.columns, cut.rows, std::move(type), {}};
  const size_t row_bytes = size * static_cast<size_t>(cut.columns);
  result.bytes.resize(row_bytes * static_cast<size_t>(cut.rows));
  parallel_rows({}, cut.columns, cut.rows, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      char* out = result.bytes.data() + row_bytes * static_cast<size_t>(row);
      const int y = std::min((window.y + row) * cut.step, frame.height - 1);
      for (int column = 0; column < cut.columns; ++column)
        put(std::min((window.x + column) * cut.step, frame.width - 1), y, out + size * static_cast<size_t>(column));
    }
  });
  return result;
}

void put_float(float value, char* out) { std::copy_n(reinterpret_cast<const char*>(&value), sizeof value, out); }

RasterBytes scalar_bytes(const Grid<float>& grid, const RasterWindow& window) {
  return cut_out(grid.frame(), window, "f32", sizeof(float),
                 [&](int x, int y, char* out) { put_float(grid(x, y), out); });
}

const Grid<float>* scalar_of(const recipe::Value& value) {
  if (value.is<kinds::Terrain>()) return &value.get<kinds::Terrain>();
  if (value.is<kinds::Field>()) return &value.get<kinds::Field>();
  return nullptr;
}

/// Mean of the step x step pixels that become one.
void average_block(const Image& image, int x, int y, int step, uint8_t* out) {
  for (int channel = 0; channel < 3; ++channel) {
    int sum = 0, count = 0;
    for (int v = y * step; v < std::min((y + 1) * step, image.height); ++v) {
      for (int u = x * step; u < (x + 1) * step; ++u, ++count) sum += image.pixel(u, v)[channel];
    }
    out[channel] = static_cast<uint8_t>((sum + count / 2) / std::max(1, count));
  }
}

}  // namespace

RasterBytes raster_bytes(const recipe::Value& value, const RasterWindow& window) {
  if (const Grid<float>* grid = scalar_of(value)) return scalar_bytes(*grid, window);
  if (value.is<kinds::Labels>()) {
    const LabelMap& labels = value.get<kinds::Labels>();
    return cut_out(labels.frame(), window, "u8", 1,
                   [&](int x, int y, char* out) { *out = static_cast<char>(labels(x, y)); });
  }
  if (value.is<kinds::Current>()) {
    const VectorField& current = value.get<kinds::Current>();
    return cut_out(current.frame(), window, "f32x2", 2 * sizeof(float), [&](int x, int y, char* out) {
      put_float(current.x(x, y), out);
      put_float(current.y(x, y), out + sizeof(float));
    });
  }
  throw_wrong_kind(value, "a raster");
}

std::string mask_bytes(const GridFrame& frame, const RasterWindow& window, const std::function<bool(int, int)>& holds) {
  const auto put = [&](int x, int y, char* out) { *out = holds(x, y) ? '\xff' : '\0'; };
  return cut_out(frame, window, "u8", 1, put).bytes;
}

std::optional<std::pair<float, float>> raster_range(const recipe::Value& value) {
  const Grid<float>* grid = scalar_of(value);
  if (grid == nullptr) return std::nullopt;
  float low = std::numeric_limits<float>::infinity(), high = -low;
  for (const float cell : grid->cells()) {  // comparisons with what is unknown are false
    low = cell < low ? cell : low;
    high = cell > high ? cell : high;
  }
  return low <= high ? std::optional(std::pair(low, high)) : std::nullopt;
}

std::vector<uint8_t> picture_bytes(const recipe::Value& value, int most_columns) {
  if (!value.is<kinds::Image>()) throw_wrong_kind(value, "a picture");
  const Image& image = value.get<kinds::Image>();
  const int step = std::max(1, (image.width + most_columns - 1) / most_columns);
  if (step == 1) return io::encode_png(image);
  Image small(image.width / step, std::max(1, image.height / step));
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) average_block(image, x, y, step, small.pixel(x, y));
  }
  return io::encode_png(small);
}

std::string report_json(const recipe::Value& value) {
  if (!value.is<kinds::Report>()) throw_wrong_kind(value, "a report");
  return io::report_json(value.get<kinds::Report>());
}

}  // namespace seamount::server
