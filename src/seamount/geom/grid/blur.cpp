// Gaussian blur (resample.h) by three box filters: Wells 1986; fractional boxes after Gwosdek et al. 2012. Lines of
// cells go eight at a time, so that rows and columns cost the same and running sums fill vector registers.
#include <algorithm>
#include <array>
#include <cmath>
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

/// Eight lines of `count` cells, reflected at both ends by `pad` cells, and their running sums.
struct Lines {
  Lines(int cells, int padding)
      : count(cells),
        pad(padding),
        values(static_cast<size_t>(cells + 2 * padding) * kLanes),
        sums(static_cast<size_t>(cells + 2 * padding + 1) * kLanes) {}
  int count;
  int pad;
  std::vector<double> values;
  std::vector<double> sums;
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

SEAMOUNT_VECTORISED void running_sums(const double* values, double* sums, int count) {
  for (int lane = 0; lane < kLanes; ++lane) sums[lane] = 0.0;
  for (int i = 0; i < count; ++i) {
    for (int lane = 0; lane < kLanes; ++lane) {
      sums[(i + 1) * kLanes + lane] = sums[i * kLanes + lane] + values[i * kLanes + lane];
    }
  }
}

/// values[i] <- box mean around i, for i in [pad, pad + count). `before` keeps the old value that is still needed.
SEAMOUNT_VECTORISED void box_means(double* values, const double* sums, int pad, int count, Box box) {
  for (int i = 0; i < count * kLanes; ++i) {
    const int at = pad * kLanes + i;
    const double* low = sums + at - box.radius * kLanes;
    const double* high = sums + at + (box.radius + 1) * kLanes;
    const double edges = (low[0] - low[-kLanes]) + (high[kLanes] - high[0]);
    values[at] = ((high[0] - low[0]) + box.edge * edges) * box.scale;
  }
}

/// Blurs kLanes lines: cell i of line k is data[i step + k across].
void blur_lines(Lines& lines, Box box, float* data, int64_t step, int64_t across, int lanes) {
  for (int i = 0; i < lines.count; ++i) {
    for (int k = 0; k < kLanes; ++k) {
      lines.values[static_cast<size_t>((i + lines.pad) * kLanes + k)] =
          data[i * step + std::min(k, lanes - 1) * across];
    }
  }
  for (int pass = 0; pass < kPasses; ++pass) {
    reflect(lines);
    running_sums(lines.values.data(), lines.sums.data(), lines.count + 2 * lines.pad);
    box_means(lines.values.data(), lines.sums.data(), lines.pad, lines.count, box);
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
  const int64_t step = rows ? 1 : width;
  const int64_t across = rows ? width : 1;
  parallel_blocks(run, lines_in_all, 8 * kLanes, [&](int64_t begin, int64_t end) {
    Lines lines(count, box.radius + 2);
    for (int64_t line = begin; line < end; line += kLanes) {
      const int lanes = static_cast<int>(std::min<int64_t>(kLanes, end - line));
      blur_lines(lines, box, field.data() + line * across, step, across, lanes);
    }
  });
}

}  // namespace

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
