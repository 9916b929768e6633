// Gaussian blur (resample.h) by three box filters: Wells 1986; fractional boxes after Gwosdek et al. 2012. Lines of
// cells go eight at a time, so that rows and columns cost the same and sums fill vector registers.
//
// A box is the end of one block of cells and the beginning of the next, both summed once (van Herk 1992 does so for
// extremes). Blocks are as long as the box and begin at cell 0 of the whole raster, so that a mean hangs on the cells
// in its box alone, to the bit: a window of a raster has the means of the whole.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/base/text.h"
#include "seamount/geom/grid/resample.h"

namespace seamount::geom {
namespace {

constexpr int kLanes = 8;
constexpr int kPasses = 3;

/// Whole radius and weight of the two cells beyond it; three such boxes have the wanted variance.
struct Box {
  int radius;
  double edge;
  double scale;  ///< 1 / (2 radius + 1 + 2 edge)
};

Box make_box(double sigma_cells) {
  const double variance = sigma_cells * sigma_cells / kPasses;
  const int radius = static_cast<int>((std::sqrt(1.0 + 12.0 * variance) - 1.0) / 2.0);
  const double r = radius;
  const double edge =
      (variance * (2.0 * r + 1.0) - r * (r + 1.0) * (2.0 * r + 1.0) / 3.0) / (2.0 * ((r + 1.0) * (r + 1.0) - variance));
  return {radius, edge, 1.0 / (2.0 * r + 1.0 + 2.0 * edge)};
}

/// Eight lines of `count` cells, reflected at both ends by `pad` cells, and sums over the blocks that they fall into.
struct Lines {
  Lines(int cells, int padding)
      : count(cells),
        pad(padding),
        values(static_cast<size_t>(cells + 2 * padding) * kLanes),
        means(values.size()),
        until(values.size()),
        from(values.size()) {}
  int count;
  int pad;
  std::vector<double> values;
  std::vector<double> means;
  std::vector<double> until;  ///< sum of a block from its first cell to this one
  std::vector<double> from;   ///< sum from this cell to its block's last; 0 at the first, where `until` says it all
};

int reflected(int i, int count) {
  const int period = 2 * count;
  const int j = ((i % period) + period) % period;
  return j < count ? j : period - 1 - j;
}

void reflect(Lines& lines) {
  const auto copy = [&](int to) {
    const int from = reflected(to, lines.count);
    std::copy_n(lines.values.begin() + (from + lines.pad) * kLanes, kLanes,
                lines.values.begin() + (to + lines.pad) * kLanes);
  };
  for (int i = 1; i <= lines.pad; ++i) {
    copy(-i);
    copy(lines.count - 1 + i);
  }
}

/// Sums over the cells [begin, end) of one block, both ways. `whole_begin`: its first cell is among them.
SEAMOUNT_VECTORISED void block_sums(const double* values, double* until, double* from, int begin, int end,
                                    bool whole_begin) {
  double sums[kLanes] = {};
  for (int i = begin; i < end; ++i) {
    for (int lane = 0; lane < kLanes; ++lane) {
      sums[lane] += values[i * kLanes + lane];
      until[i * kLanes + lane] = sums[lane];
    }
  }
  for (int lane = 0; lane < kLanes; ++lane) sums[lane] = 0.0;
  for (int i = end - 1; i >= begin; --i) {
    for (int lane = 0; lane < kLanes; ++lane) {
      sums[lane] += values[i * kLanes + lane];
      from[i * kLanes + lane] = sums[lane];
    }
  }
  if (whole_begin) {
    for (int lane = 0; lane < kLanes; ++lane) from[begin * kLanes + lane] = 0.0;
  }
}

/// Sums of all blocks of `length` cells, of which one begins `offset` cells before cell 0. REQUIRES: 0 <= offset <
/// length.
void sum_blocks(Lines& lines, int length, int offset) {
  const int count = lines.count + 2 * lines.pad;
  for (int begin = -offset; begin < count; begin += length)
    block_sums(lines.values.data(), lines.until.data(), lines.from.data(), std::max(begin, 0),
               std::min(begin + length, count), begin >= 0);
}

/// means[i] <- box mean around i, for i in [pad, pad + count).
SEAMOUNT_VECTORISED void box_means(const double* values, const double* until, const double* from,
                                   double* __restrict means, int pad, int count, Box box) {
  const int reach = box.radius * kLanes;
  for (int i = 0; i < count * kLanes; ++i) {
    const int at = pad * kLanes + i;
    const double edges = values[at - reach - kLanes] + values[at + reach + kLanes];
    means[at] = ((from[at - reach] + until[at + reach]) + box.edge * edges) * box.scale;
  }
}

/// Blurs kLanes lines: cell i of line k is data[i step + k across], and lies `first` + i cells into the whole raster.
void blur_lines(Lines& lines, Box box, int first, float* data, int64_t step, int64_t across, int lanes) {
  const int length = 2 * box.radius + 1;
  const int offset = ((first - lines.pad) % length + length) % length;
  for (int i = 0; i < lines.count; ++i) {
    for (int k = 0; k < kLanes; ++k) {
      lines.values[static_cast<size_t>((i + lines.pad) * kLanes + k)] =
          data[i * step + std::min(k, lanes - 1) * across];
    }
  }
  for (int pass = 0; pass < kPasses; ++pass) {
    reflect(lines);
    sum_blocks(lines, length, offset);
    box_means(lines.values.data(), lines.until.data(), lines.from.data(), lines.means.data(), lines.pad, lines.count,
              box);
    std::swap(lines.values, lines.means);
  }
  for (int i = 0; i < lines.count; ++i) {
    for (int k = 0; k < lanes; ++k) {
      data[i * step + k * across] = static_cast<float>(lines.values[static_cast<size_t>((i + lines.pad) * kLanes + k)]);
    }
  }
}

void blur_axis(ScalarField& field, Box box, bool rows, const RunContext& run) {
  const int width = field.width();
  const int count = rows ? width : field.height();
  const int lines_in_all = rows ? field.height() : width;
  const int first = rows ? field.frame().first_column() : field.frame().first_row();
  const int64_t step = rows ? 1 : width;
  const int64_t across = rows ? width : 1;
  parallel_blocks(run, lines_in_all, 8 * kLanes, [&](int64_t begin, int64_t end) {
    Lines lines(count, box.radius + 2);
    for (int64_t line = begin; line < end; line += kLanes) {
      const int lanes = static_cast<int>(std::min<int64_t>(kLanes, end - line));
      blur_lines(lines, box, first, field.data() + line * across, step, across, lanes);
    }
  });
}

}  // namespace

int blur_reach(double sigma_m, double cell_m) {
  constexpr double kMost = 1 << 24;
  if (!(sigma_m > 0.0)) return 0;
  return kPasses * (make_box(std::min(sigma_m / cell_m, kMost / 8)).radius + 1);
}

void gaussian_blur(ScalarField& field, double sigma_m, const RunContext& run) {
  if (!(sigma_m >= 0.0) || !std::isfinite(sigma_m)) {
    throw InvalidArgument("sigma_m", format_number(sigma_m) + " is not a length of 0 or more");
  }
  if (sigma_m == 0.0 || field.empty()) return;
  const double largest = 4.0 * std::max(field.width(), field.height());
  const Box box = make_box(std::min(sigma_m / field.cell_m(), largest));
  blur_axis(field, box, true, run.part(0.0, 0.5));
  blur_axis(field, box, false, run.part(0.5, 1.0));
}

}  // namespace seamount::geom
