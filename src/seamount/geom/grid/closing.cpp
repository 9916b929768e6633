#include "seamount/geom/grid/closing.h"

#include <algorithm>

#include "seamount/base/parallel.h"

namespace seamount::geom {
namespace {

/// better(a, b) over windows of 2 reach + 1 cells along rows, and the result turned on its side.
template <class Better>
ScalarField along_rows(const ScalarField& field, int reach, const RunContext& run, Better better) {
  const int width = field.width(), height = field.height();
  ScalarField turned(GridFrame::centred(height, width, 1.0));
  parallel_rows(run, width, height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < width; ++x) {
        float best = field(x, y);
        for (int i = std::max(0, x - reach); i <= std::min(width - 1, x + reach); ++i) best = better(best, field(i, y));
        turned(y, x) = best;
      }
    }
  });
  return turned;
}

template <class Better>
ScalarField within(const ScalarField& field, int reach, const RunContext& run, Better better) {
  return along_rows(along_rows(field, reach, run, better), reach, run, better);
}

}  // namespace

ScalarField closing(const ScalarField& field, int reach, const RunContext& run) {
  const ScalarField high = within(field, reach, run, [](float a, float b) { return std::max(a, b); });
  ScalarField closed = within(high, reach, run, [](float a, float b) { return std::min(a, b); });
  ScalarField out(field.frame());
  std::copy(closed.cells().begin(), closed.cells().end(), out.cells().begin());
  return out;
}

}  // namespace seamount::geom
