#include "seamount/recipe/laid_over.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "seamount/base/parallel.h"

namespace seamount::recipe {
namespace {

/// Pixels along one axis that a cell sees, and how much of each.
struct Seen {
  int first = 0;
  std::vector<float> weights;
};

/// A tent as wide as a pixel or a cell, whichever is larger.
std::vector<Seen> seen_by_cells(int cells, int pixels) {
  const double scale = static_cast<double>(pixels) / cells, reach = std::max(1.0, scale);
  std::vector<Seen> all(static_cast<size_t>(cells));
  for (int i = 0; i < cells; ++i) {
    Seen& seen = all[static_cast<size_t>(i)];
    const double middle = std::clamp((i + 0.5) * scale - 0.5, 0.0, pixels - 1.0);
    seen.first = std::max(0, static_cast<int>(std::ceil(middle - reach)));
    const int last = std::min(pixels - 1, static_cast<int>(std::floor(middle + reach)));
    for (int p = seen.first; p <= last; ++p)
      seen.weights.push_back(static_cast<float>(std::max(0.0, 1.0 - std::abs(p - middle) / reach)));
  }
  return all;
}

}  // namespace

ScalarField laid_over(const ScalarField& picture, const GridFrame& frame, const RunContext& run) {
  const std::vector<Seen> columns = seen_by_cells(frame.width, picture.width());
  const std::vector<Seen> rows = seen_by_cells(frame.height, picture.height());
  ScalarField out(frame);
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const Seen& down = rows[static_cast<size_t>(y)];
      for (int x = 0; x < frame.width; ++x) {
        const Seen& across = columns[static_cast<size_t>(x)];
        double sum = 0, weight = 0;
        for (size_t j = 0; j < down.weights.size(); ++j) {
          for (size_t i = 0; i < across.weights.size(); ++i) {
            const float value = picture(across.first + static_cast<int>(i), down.first + static_cast<int>(j));
            if (std::isnan(value)) continue;
            const double own = static_cast<double>(down.weights[j]) * across.weights[i];
            sum += own * value;
            weight += own;
          }
        }
        out(x, y) = weight > 0 ? static_cast<float>(sum / weight) : std::numeric_limits<float>::quiet_NaN();
      }
    }
  });
  return out;
}

}  // namespace seamount::recipe
