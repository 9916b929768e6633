// Reading grids between their samples, at other sizes, and blurred. Beyond its edge a grid goes on with its nearest
// cell.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// Value at fractional (column, row), cell centres at whole numbers: linear, continuous.
float sample_bilinear(const Grid<float>& grid, double column, double row);

/// Catmull-Rom: through every sample, once differentiable, overshoots a little at steps.
float sample_bicubic(const Grid<float>& grid, double column, double row);

/// Cubic B-spline: twice differentiable, never overshoots, softens the samples a little.
float sample_bspline(const Grid<float>& grid, double column, double row);

/// The same surface on another frame: averaged over the target's cells where they are larger, Catmull-Rom where they
/// are smaller or equal. Frames are matched by metres. Near unknown cells (NaN) only the known ones count; NaN where
/// they are less than half. Parallel.
HeightField resample(const HeightField& source, const GridFrame& target, const RunContext& run);

/// The same row by row, for a source that is not in memory as a whole, or for a target that is a window of a larger
/// one: the same bits.
class RowResampler {
 public:
  RowResampler(const GridFrame& source, const GridFrame& target);
  ~RowResampler();
  RowResampler(const RowResampler&) = delete;
  RowResampler& operator=(const RowResampler&) = delete;

  /// Rows of the source that rows [begin, end) of the target are made from, and columns that all of it is made from.
  struct Span {
    int first = 0, count = 0;
  };
  Span rows(int begin, int end) const;
  Span columns() const;

  /// Row y of the target, from a part of the source that begins at (first_column, first_row) of it and has all that it
  /// needs. `mixed` is scratch.
  void row(const HeightField& part, int first_column, int first_row, int y, std::vector<float>& mixed,
           std::span<float> out) const;

 private:
  bool averages() const;

  struct Axes;
  GridFrame source_, target_;
  double ratio_;
  std::unique_ptr<const Axes> axes_;
};

/// The category at the middle of each target cell, or, where target cells are larger, the most frequent one in it (ties
/// to the smaller value). Values below 256. Parallel.
Grid<uint8_t> resample_labels(const Grid<uint8_t>& source, const GridFrame& target, const RunContext& run);

/// Mean of factor x factor cells. Throws InvalidArgument unless factor >= 1 divides both sides.
Grid<float> box_downsample(const Grid<float>& grid, int factor, const RunContext& run);

/// Gaussian blur of deviation sigma_m in place by three box filters of fractional width (everywhere within 13 %
/// of the true kernel's peak); edges are reflected, so the mean stays. Cost does not depend on sigma_m; 0 leaves the
/// field alone. Throws InvalidArgument for a negative sigma_m. Parallel; one more grid of memory.
void gaussian_blur(ScalarField& field, double sigma_m, const RunContext& run);

/// Cells on every side that a blurred cell hangs on. Saturates at 2^24.
int blur_reach(double sigma_m, double cell_m);

}  // namespace seamount::geom
