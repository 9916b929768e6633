// What a brush stroke weighs at the cells of a grid: about the greatest of pressure times profile along the way, so
// that a stroke that crosses itself does not count twice there; but without the creases that a greatest has where one
// part of the stroke meets another: in bends, at crossings, between the lines of a scribble.
//
// With a Gaussian g of deviation s = r / sqrt(24) and means over the stroke's length weighted by g(d) pressure^6
//
//   weight(p) = profile(D) mean(pressure),   D^2 = mean(d^2) - s^2,   d the distance from p to a place of the stroke
//
// which for a straight stroke is the profile of the distance exactly. The ends weigh half a dab more, whose D is d.
#pragma once

#include <span>
#include <vector>

#include "seamount/geom/brush/brush_path.h"

namespace seamount::geom {

/// A rectangle of cells; right and bottom excluded.
struct CellWindow {
  int left = 0, top = 0, right = 0, bottom = 0;
  bool empty() const { return left >= right || top >= bottom; }
  int width() const { return right - left; }
};

/// The cells of a frame within `margin_m` of a box.
CellWindow cells_of(const Box& box, const GridFrame& frame, double margin_m = 0.0);

/// The frame of cells_of(). Of a frame that is itself a window of a larger raster it is a window of what these cells
/// are in the whole: what is computed on it has the same bits.
GridFrame cells_frame(const Box& box, const GridFrame& frame, double margin_m = 0.0);

/// Weights of one stroke after another on bands of rows; keeps its memory. One per thread. A path on a raster may be
/// read on a window of it: the same bits.
class BrushBand {
 public:
  /// Reads rows [begin, end) of a stroke. False where it does not reach them. Less than 1 ns for each cell and sample
  /// that reaches it; a cell is reached by about ten. Vectorised; the same bits whatever the rows are read with.
  bool read(const BrushPath& path, const GridFrame& frame, int begin, int end);

  /// Calls row(y, x0, weights) for each row read that the stroke touches: weights of the cells from column x0 on.
  template <class Row>
  void each_row(Row&& row) const {
    for (int y = window_.top; y < window_.bottom; ++y) {
      const Span& s = spans_[static_cast<size_t>(y - window_.top)];
      if (s.from < s.to) row(y, s.from, std::span<const float>(at(s.from, y), static_cast<size_t>(s.to - s.from)));
    }
  }

 private:
  struct Span {
    int from, to;
  };
  const float* at(int x, int y) const { return weights_.data() + index(x, y); }
  size_t index(int x, int y) const {
    return static_cast<size_t>(y - window_.top) * static_cast<size_t>(window_.width()) +
           static_cast<size_t>(x - window_.left);
  }
  void add(const BrushPath& path, const BrushSample& sample, const GridFrame& frame);

  CellWindow window_;
  int whole_left_ = 0;                   ///< where its cells begin in the whole, counted as the frame's columns
  std::vector<float> weights_;           ///< sums of masses, then weights
  std::vector<float> squares_;           ///< sums of squared distances
  std::vector<float> pressures_;         ///< sums of pressures, where they differ
  std::vector<float> across_, across2_;  ///< the Gaussian along a row, and times the squared distance
  std::vector<Span> spans_;
};

}  // namespace seamount::geom
