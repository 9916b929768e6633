#include "seamount/io/warp_window.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "seamount/model/sample_known.h"

namespace seamount::io {
namespace {

constexpr int kBand = 64;  ///< rows of the result that are made of one part of the source
constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

/// Cells of the source.
struct Part {
  int left = std::numeric_limits<int>::max(), top = std::numeric_limits<int>::max(), right = -1, bottom = -1;

  void include(double column, double row, const WarpSource& source) {
    const int x = static_cast<int>(column), y = static_cast<int>(row);
    left = std::min(left, x);
    top = std::min(top, y);
    right = std::max(right, std::min(x + 1, source.width - 1));
    bottom = std::max(bottom, std::min(y + 1, source.height - 1));
  }
};

/// A place beyond the source becomes none, one at its rim the nearest in it, as sample_known() takes them.
void bring_inside(double& position, int size) {
  constexpr double kEdge = 0.5 + 1e-6;
  position = position >= -kEdge && position <= size - 1 + kEdge ? std::clamp(position, 0.0, size - 1.0) : kNowhere;
}

/// Rows [begin, end) of the result.
class Band {
 public:
  Band(const GridFrame& window, const WarpSource& source)
      : window_(window), source_(source), columns_(static_cast<size_t>(window.width) * kBand), rows_(columns_.size()) {}

  void make(CellFinder& finder, int begin, int end, Grid<float>& out) {
    Part part;
    for (int y = begin; y < end; ++y) {
      const std::span<double> columns = of(columns_, y - begin), rows = of(rows_, y - begin);
      finder.locate(window_.first_row() + y, columns, rows);
      for (size_t x = 0; x < columns.size(); ++x) {
        bring_inside(columns[x], source_.width);
        bring_inside(rows[x], source_.height);
        if (!std::isnan(columns[x]) && !std::isnan(rows[x])) part.include(columns[x], rows[x], source_);
      }
    }
    Grid<float> cells;
    if (part.right >= 0)
      cells = source_.read(part.left, part.top, part.right - part.left + 1, part.bottom - part.top + 1);
    for (int y = begin; y < end; ++y) {
      const std::span<double> columns = of(columns_, y - begin), rows = of(rows_, y - begin);
      const std::span<float> row = out.row(y);
      for (size_t x = 0; x < row.size(); ++x) {
        const bool somewhere = !std::isnan(columns[x]) && !std::isnan(rows[x]);
        row[x] = somewhere ? sample_known(cells, columns[x] - part.left, rows[x] - part.top)
                           : std::numeric_limits<float>::quiet_NaN();
      }
    }
  }

 private:
  std::span<double> of(std::vector<double>& all, int row) const {
    const auto width = static_cast<size_t>(window_.width);
    return std::span(all).subspan(static_cast<size_t>(row) * width, width);
  }

  const GridFrame& window_;
  const WarpSource& source_;
  std::vector<double> columns_, rows_;
};

}  // namespace

Grid<float> warp_window(const GridFrame& window, const WarpSource& source, const GdalCall& call,
                        const RunContext& run) {
  const Placement target = placement_of(window.in_whole());
  CellFinder finder(target, window.width, source.placement, source.width, call, window.first_column());
  Grid<float> out(window);
  Band band(window, source);
  for (int begin = 0; begin < window.height; begin += kBand) {
    run.check_cancelled();
    band.make(finder, begin, std::min(begin + kBand, window.height), out);
  }
  return out;
}

}  // namespace seamount::io
