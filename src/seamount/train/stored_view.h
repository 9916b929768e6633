// How a training looks at a stored sample: a square of it, turned and mirrored.
#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include "seamount/base/error.h"
#include "seamount/base/rng.h"
#include "seamount/io/image_file.h"
#include "seamount/io/raster.h"

namespace seamount::train {

/// Cells a side of what is learned from samples of `stored` cells: at most 256, a multiple of the network's stride.
/// Throws InvalidArgument{"--set"} below 64.
inline int learned_size(int stored) {
  constexpr int kLargest = 256, kStride = 64;
  if (stored < kStride)
    throw InvalidArgument("--set", "its samples have " + std::to_string(stored) + " cells a side; 64 are needed");
  return std::min(stored, kLargest) / kStride * kStride;
}

struct StoredView {
  int size = 0, left = 0, top = 0;
  bool flip_x = false, flip_y = false, transpose = false;

  /// Some square of `size` cells in one of `stored`.
  static StoredView any(int size, int stored, Rng& rng) {
    StoredView view{.size = size};
    view.left = rng.integer(0, stored - size);
    view.top = rng.integer(0, stored - size);
    view.flip_x = rng.chance(0.5);
    view.flip_y = rng.chance(0.5);
    view.transpose = rng.chance(0.5);
    return view;
  }

  /// Where cell (x, y) of the view lies in the sample.
  std::pair<int, int> from(int x, int y) const {
    int u = flip_x ? size - 1 - x : x, v = flip_y ? size - 1 - y : y;
    if (transpose) std::swap(u, v);
    return {left + u, top + v};
  }
};

inline void check_stored_size(int width, int height, int size, const std::string& file) {
  if (width == size && height == size) return;
  throw IoError(file, "has " + std::to_string(width) + " x " + std::to_string(height) +
                          " pixels, and those of the set " + std::to_string(size) + " a side");
}

/// Throw IoError, also for a picture of another size.
inline Image read_stored_picture(const std::string& file, int size) {
  Image image = io::read_image(file);
  check_stored_size(image.width, image.height, size, file);
  return image;
}
inline HeightField read_stored_heights(const std::string& file, int size, double cell_m, io::HeightRange range) {
  io::ReadOptions options;
  options.range = range;
  options.cell_m = cell_m;
  HeightField heights = io::read_heights(file, options);
  check_stored_size(heights.width(), heights.height(), size, file);
  return heights;
}

/// The part of a grid that is seen, in a frame of its own.
template <class T>
Grid<T> seen(const Grid<T>& stored, const StoredView& view) {
  Grid<T> out(GridFrame::centred(view.size, view.size, stored.cell_m()));
  for (int y = 0; y < view.size; ++y) {
    for (int x = 0; x < view.size; ++x) {
      const auto [u, v] = view.from(x, y);
      out(x, y) = stored(u, v);
    }
  }
  return out;
}

}  // namespace seamount::train
