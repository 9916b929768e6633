#include "seamount/geom/contour/faces.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/geom/contour/nesting.h"

namespace seamount::geom {

ContourFaces::ContourFaces(const std::vector<Contour>& contours)
    : inner_(contours.size()),
      outer_(contours.size()),
      rises_(contours.size() + 1, 0),
      holds_water_(contours.size() + 1, 0) {
  bounds_.reserve(2 * contours.size());
  for (size_t i = 0; i < contours.size(); ++i) {
    const bool hill = is_hill(contours[i]);
    bounds_.push_back({static_cast<int32_t>(i) + 1, contours[i].height_m});
    bounds_.push_back({contours[i].parent + 1, contours[i].height_m});
    rises_[i + 1] = hill ? 1 : 0;
    holds_water_[i + 1] = hill ? 0 : 1;
  }
  // A basin directly in a basin is where the outer one's water goes; one on a hill in it lies higher.
  for (const Contour& contour : contours) {
    if (is_hill(contour) || contour.parent < 0) continue;
    holds_water_[static_cast<size_t>(contour.parent) + 1] = 0;
  }
  const auto before = [](const Bound& a, const Bound& b) {
    return a.face != b.face ? a.face < b.face : a.height_m < b.height_m;
  };
  std::sort(bounds_.begin(), bounds_.end(), before);
  const auto same = [](const Bound& a, const Bound& b) { return a.face == b.face && a.height_m == b.height_m; };
  bounds_.erase(std::unique(bounds_.begin(), bounds_.end(), same), bounds_.end());
  const auto place = [&](const Bound& bound) {
    return static_cast<size_t>(std::lower_bound(bounds_.begin(), bounds_.end(), bound, before) - bounds_.begin());
  };
  for (size_t i = 0; i < contours.size(); ++i) {
    inner_[i] = place({static_cast<int32_t>(i) + 1, contours[i].height_m});
    outer_[i] = place({contours[i].parent + 1, contours[i].height_m});
  }
  first_.reserve(contours.size() + 2);
  for (int32_t face = 0; face <= static_cast<int32_t>(contours.size()) + 1; ++face)
    first_.push_back(place({face, -std::numeric_limits<double>::infinity()}));
}

namespace {

/// Where a contour crosses the line through a row's centres.
struct RowCrossing {
  int32_t row;
  int32_t column;  ///< the first whose centre lies beyond
  double x;        ///< in cells
  int32_t contour;
};

/// By row, then from west to east.
std::vector<RowCrossing> row_crossings(const std::vector<Contour>& contours, const GridFrame& frame,
                                       const RunContext& run) {
  std::vector<RowCrossing> crossings;
  for (size_t c = 0; c < contours.size(); ++c) {
    const Ring& ring = contours[c].ring;
    for (size_t i = 0; i < ring.size(); ++i) {
      run.check_cancelled();
      const Vec2 from = ring[i];
      const Vec2 to = ring[i + 1 < ring.size() ? i + 1 : 0];
      const double a = frame.row(from.y);
      const double b = frame.row(to.y);
      const double first = std::max(0.0, std::ceil(std::min(a, b)));
      const double end = std::min(frame.height - 1.0, std::ceil(std::max(a, b)) - 1.0);
      for (double row = first; row <= end; ++row) {
        const double x = frame.column(from.x + (to.x - from.x) * ((row - a) / (b - a)));
        const double column = std::clamp(std::ceil(x), 0.0, static_cast<double>(frame.width));
        crossings.push_back({static_cast<int32_t>(row), static_cast<int32_t>(column), x, static_cast<int32_t>(c)});
      }
    }
  }
  std::sort(crossings.begin(), crossings.end(), [&](const RowCrossing& a, const RowCrossing& b) {
    run.check_cancelled();
    if (a.row != b.row) return a.row < b.row;
    return a.x != b.x ? a.x < b.x : a.contour < b.contour;
  });
  return crossings;
}

/// Walks along a row from outside all contours, into them and out of them.
class RowWalk {
 public:
  explicit RowWalk(const std::vector<Contour>& contours) : contours_(contours), open_(contours.size(), 0) {}

  void fill(std::span<const RowCrossing> crossings, std::span<int32_t> cells) {
    size_t begin = 0;
    int32_t innermost = -1;
    for (const RowCrossing& crossing : crossings) {
      const auto column = static_cast<size_t>(crossing.column);
      std::fill(cells.begin() + static_cast<std::ptrdiff_t>(begin), cells.begin() + static_cast<std::ptrdiff_t>(column),
                innermost + 1);
      begin = column;
      innermost = step(innermost, crossing.contour);
    }
    std::fill(cells.begin() + static_cast<std::ptrdiff_t>(begin), cells.end(), innermost + 1);
    for (const RowCrossing& crossing : crossings) open_[static_cast<size_t>(crossing.contour)] = 0;
  }

 private:
  int32_t step(int32_t innermost, int32_t contour) {
    char& open = open_[static_cast<size_t>(contour)];
    open = open != 0 ? 0 : 1;
    // Children have greater numbers than their parents, and what is open at a place is one line of descent.
    if (open != 0) return std::max(innermost, contour);
    if (innermost != contour) return innermost;
    int32_t up = contour;
    do up = contours_[static_cast<size_t>(up)].parent;
    while (up >= 0 && open_[static_cast<size_t>(up)] == 0);
    return up;
  }

  const std::vector<Contour>& contours_;
  std::vector<char> open_;
};

}  // namespace

Grid<int32_t> rasterise_faces(const std::vector<Contour>& contours, const GridFrame& frame, const RunContext& run) {
  Grid<int32_t> faces(frame);
  const std::vector<RowCrossing> crossings = row_crossings(contours, frame, run);
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    RowWalk walk(contours);
    auto at = std::lower_bound(crossings.begin(), crossings.end(), begin,
                               [](const RowCrossing& crossing, int row) { return crossing.row < row; });
    for (int row = begin; row < end; ++row) {
      auto last = at;
      while (last != crossings.end() && last->row == row) ++last;
      walk.fill({at, last}, faces.row(row));
      at = last;
    }
  });
  return faces;
}

}  // namespace seamount::geom
