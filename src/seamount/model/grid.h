// A raster in the real world: cells of one size, row-major in memory, x east and y north in metres.
//
//   column 0 is the western edge, row 0 the NORTHERN edge (as in every image file), a sample sits at its cell's centre:
//   x(column) = west_m + (column + 1/2) cell_m,  y(row) = north_m - (row + 1/2) cell_m.
//
// Calls are in (x, y) order: grid(column, row).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "seamount/base/large_block.h"

namespace seamount {

/// The raster that a window was cut from: its corner, and the window's first cell in it.
struct WindowOrigin {
  double west_m = 0.0;
  double north_m = 0.0;
  int column = 0;
  int row = 0;
  bool operator==(const WindowOrigin&) const = default;
};

/// Where a raster lies: size, cell, corner and, where it is known, the coordinate reference system. A window of a
/// larger raster knows its place in it: cells have the positions that they have in the whole, to the bit, which a
/// corner that was moved by some cells does not give (it is rounded).
struct GridFrame {
  int width = 0;          ///< columns, >= 1
  int height = 0;         ///< rows, >= 1
  double cell_m = 1.0;    ///< cell size in metres, > 0
  double west_m = 0.0;    ///< x of the western edge (not of the first centre)
  double north_m = 0.0;   ///< y of the northern edge
  std::string crs = {};   ///< WKT or PROJ text of a metric system in which (x, y) are coordinates; empty: local metres
  WindowOrigin cut = {};  ///< of a window; counts while cell and corner are as window() made them

  /// A frame whose middle is (0, 0).
  static GridFrame centred(int width, int height, double cell_m) {
    return {width, height, cell_m, -0.5 * width * cell_m, 0.5 * height * cell_m, {}};
  }

  /// `window_width` x `window_height` cells from (column, row) on. REQUIRES: they lie within.
  GridFrame window(int column, int row, int window_width, int window_height) const {
    const GridFrame whole = in_whole();
    const WindowOrigin from{whole.west_m, whole.north_m, first_column() + column, first_row() + row};
    const bool corner = from.column == 0 && from.row == 0;  // positions are counted from it anyhow
    return {window_width,
            window_height,
            cell_m,
            from.west_m + from.column * cell_m,
            from.north_m - from.row * cell_m,
            crs,
            corner ? WindowOrigin{} : from};
  }
  bool is_window() const {
    return (cut.column != 0 || cut.row != 0) && west_m == cut.west_m + cut.column * cell_m &&
           north_m == cut.north_m - cut.row * cell_m;
  }
  /// Columns and rows of the whole before a window's own; 0 of what is no window. What goes in steps of several cells
  /// counts them from the whole's corner.
  int first_column() const { return is_window() ? cut.column : 0; }
  int first_row() const { return is_window() ? cut.row : 0; }
  /// The same cells counted from the whole's corner: its (first_column(), first_row()) is this one's (0, 0).
  GridFrame in_whole() const {
    return is_window() ? GridFrame{width, height, cell_m, cut.west_m, cut.north_m, crs, {}} : *this;
  }

  double x(double column) const {
    return is_window() ? cut.west_m + (cut.column + column + 0.5) * cell_m : west_m + (column + 0.5) * cell_m;
  }
  double y(double row) const {
    return is_window() ? cut.north_m - (cut.row + row + 0.5) * cell_m : north_m - (row + 0.5) * cell_m;
  }
  /// Inverse of x(): fractional column of a place.
  double column(double x) const {
    return is_window() ? (x - cut.west_m) / cell_m - 0.5 - cut.column : (x - west_m) / cell_m - 0.5;
  }
  double row(double y) const {
    return is_window() ? (cut.north_m - y) / cell_m - 0.5 - cut.row : (north_m - y) / cell_m - 0.5;
  }
  double width_m() const { return width * cell_m; }
  double height_m() const { return height * cell_m; }
  double east_m() const { return west_m + width_m(); }
  double south_m() const { return north_m - height_m(); }
  int64_t cells() const { return static_cast<int64_t>(width) * height; }

  bool operator==(const GridFrame&) const = default;
};

namespace detail {
/// Large blocks (base/large_block.h) whose elements stay uninitialised, so that the threads that compute a grid also
/// touch its pages first.
template <class T>
struct UninitialisedAllocator : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = UninitialisedAllocator<U>;
  };
  using std::allocator<T>::allocator;
  T* allocate(size_t n) {
    if (n > std::numeric_limits<size_t>::max() / sizeof(T)) throw std::bad_array_new_length();
    return static_cast<T*>(allocate_block(n * sizeof(T)));
  }
  void deallocate(T* p, size_t n) noexcept { free_block(p, n * sizeof(T)); }
  template <class U>
  void construct(U* p) noexcept {
    ::new (static_cast<void*>(p)) U;
  }
  template <class U, class... Args>
  void construct(U* p, Args&&... args) {
    ::new (static_cast<void*>(p)) U(std::forward<Args>(args)...);
  }
};
}  // namespace detail

/// A value per cell. A regular value type: copies copy the cells, moves do not.
template <class T>
class Grid {
 public:
  using Value = T;

  Grid() = default;
  /// Cells are NOT initialised: for results of which every cell is written.
  explicit Grid(GridFrame frame) : frame_(std::move(frame)), cells_(static_cast<size_t>(frame_.cells())) {}
  Grid(GridFrame frame, T fill) : frame_(std::move(frame)), cells_(static_cast<size_t>(frame_.cells()), fill) {}

  const GridFrame& frame() const { return frame_; }
  int width() const { return frame_.width; }
  int height() const { return frame_.height; }
  double cell_m() const { return frame_.cell_m; }
  bool empty() const { return cells_.empty(); }
  size_t size() const { return cells_.size(); }

  T& operator()(int x, int y) { return cells_[index(x, y)]; }
  const T& operator()(int x, int y) const { return cells_[index(x, y)]; }
  /// The nearest cell of a place that may lie outside.
  const T& clamped(int x, int y) const {
    return (*this)(std::clamp(x, 0, width() - 1), std::clamp(y, 0, height() - 1));
  }
  bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width() && y < height(); }

  std::span<T> row(int y) { return {cells_.data() + index(0, y), static_cast<size_t>(width())}; }
  std::span<const T> row(int y) const { return {cells_.data() + index(0, y), static_cast<size_t>(width())}; }
  std::span<T> cells() { return cells_; }
  std::span<const T> cells() const { return cells_; }
  T* data() { return cells_.data(); }
  const T* data() const { return cells_.data(); }

  /// The same cells in another place (a translated or newly referenced raster). REQUIRES: same width and height.
  void set_frame(GridFrame frame) { frame_ = std::move(frame); }

  bool operator==(const Grid&) const = default;

 private:
  size_t index(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width()) + static_cast<size_t>(x);
  }

  GridFrame frame_;
  std::vector<T, detail::UninitialisedAllocator<T>> cells_;
};

/// Heights in metres above sea level (z = 0), z up.
using HeightField = Grid<float>;

/// Any other scalar per cell; its unit is stated where it is made.
using ScalarField = Grid<float>;

/// A selection: 0 outside, 1 inside, soft in between.
using Mask = Grid<float>;

}  // namespace seamount
