// Scan conversion (polygon.h): per row of cell centres the sorted crossings with the edges, filled two by two.
#include <algorithm>
#include <cmath>
#include <vector>

#include "seamount/geom/polygon/polygon.h"

namespace seamount::geom {
namespace {

/// Crossings of the rows of cell centres with one polygon's edges, row by row. Places are counted from the corner of
/// the whole raster, so that a window has those of the whole.
class Crossings {
 public:
  explicit Crossings(const GridFrame& frame)
      : whole_(frame.in_whole()), top_(frame.first_row()), starts_(static_cast<size_t>(frame.height) + 1, 0) {}

  /// Even-odd crossings of all rings, as fractional columns of the whole sorted within each row.
  void collect(const Polygon& polygon) {
    std::fill(starts_.begin(), starts_.end(), 0);
    for_each_crossing(polygon, [&](size_t row, double) { ++starts_[row + 1]; });
    for (size_t row = 1; row < starts_.size(); ++row) starts_[row] += starts_[row - 1];
    columns_.resize(starts_.back());
    std::vector<size_t> next(starts_.begin(), starts_.end() - 1);
    for_each_crossing(polygon, [&](size_t row, double column) { columns_[next[row]++] = column; });
    for (size_t row = 0; row + 1 < starts_.size(); ++row) std::sort(begin(row), begin(row + 1));
  }

  std::vector<double>::iterator begin(size_t row) {
    return columns_.begin() + static_cast<std::ptrdiff_t>(starts_[row]);
  }

 private:
  template <class Visit>
  void for_each_crossing(const Polygon& polygon, Visit&& visit) const {
    ring_crossings(polygon.outer, visit);
    for (const Ring& hole : polygon.holes) ring_crossings(hole, visit);
  }

  /// An edge crosses row r if one end lies at or above the row and the other strictly below.
  template <class Visit>
  void ring_crossings(const Ring& ring, Visit&& visit) const {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Vec2 a = ring[i];
      const Vec2 b = ring[i + 1 < ring.size() ? i + 1 : 0];
      double ya = whole_.row(a.y), yb = whole_.row(b.y);
      double xa = whole_.column(a.x), xb = whole_.column(b.x);
      if (ya > yb) {
        std::swap(ya, yb);
        std::swap(xa, xb);
      }
      const double first = std::max(top_, std::ceil(ya));
      const double last = std::min(top_ + whole_.height, std::ceil(yb));
      for (double row = first; row < last; row += 1.0) {
        visit(static_cast<size_t>(row - top_), xa + (xb - xa) * ((row - ya) / (yb - ya)));
      }
    }
  }

  GridFrame whole_;
  double top_;
  std::vector<size_t> starts_;
  std::vector<double> columns_;
};

}  // namespace

Grid<uint8_t> rasterise(const std::vector<Polygon>& polygons, const GridFrame& frame) {
  Grid<uint8_t> inside(frame, uint8_t{0});
  Crossings crossings(frame);
  const double left = frame.first_column();
  for (const Polygon& polygon : polygons) {
    crossings.collect(polygon);
    for (int y = 0; y < frame.height; ++y) {
      const auto end = crossings.begin(static_cast<size_t>(y) + 1);
      for (auto at = crossings.begin(static_cast<size_t>(y)); at != end; at += 2) {
        const double width = frame.width;
        const int from = static_cast<int>(std::clamp(std::ceil(at[0]) - left, 0.0, width));
        const int to = static_cast<int>(std::clamp(std::ceil(at[1]) - left, 0.0, width));
        std::fill(inside.row(y).begin() + from, inside.row(y).begin() + std::max(from, to), uint8_t{1});
      }
    }
  }
  return inside;
}

}  // namespace seamount::geom
