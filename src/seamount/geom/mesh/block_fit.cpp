#include "seamount/geom/mesh/block_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace seamount::geom {
namespace {

constexpr double kLeastError_m = 1e-6;  // what rounding may make of a plane

/// The side of a triangle between two rows, as the column at a row. Columns and rows of a block are below 2^14, so a
/// crossing is an integer or at least 2^-14 off one.
class Side {
 public:
  Side(LatticePoint top, LatticePoint bottom)
      : x_(top.x),
        y_(top.y),
        slope_(bottom.y > top.y ? static_cast<double>(bottom.x - top.x) / (bottom.y - top.y) : 0.0) {}
  double at(int y) const { return x_ + slope_ * (y - y_); }

 private:
  int x_, y_;
  double slope_;
};

}  // namespace

void SurfaceError::add(const SurfaceError& other) {
  largest_m = std::max(largest_m, other.largest_m);
  square_sum += other.square_sum;
  cells += other.cells;
}

BlockFit::BlockFit(const HeightField& heights, const MeshDomain& domain, CellBox box)
    : heights_(heights), domain_(domain), box_(box) {}

LatticePoint BlockFit::cell(int32_t point) const {
  const LatticePoint p = builder_.points()[static_cast<size_t>(point)];
  return {p.x + box_.first.x, p.y + box_.first.y};
}

/// Calls visit(x, y, error) for each cell of a triangle, its sides included, row by row. Cells of the terrain.
template <class Visit>
void BlockFit::for_each_cell(LatticePoint a, LatticePoint b, LatticePoint c, const CellBox& within,
                             Visit&& visit) const {
  const double z = heights_(a.x, a.y), zb = heights_(b.x, b.y) - z, zc = heights_(c.x, c.y) - z;
  const auto area = static_cast<double>(orientation(a, b, c));
  const double slope_x = (zb * (c.y - a.y) - zc * (b.y - a.y)) / area;
  const double slope_y = (zc * (b.x - a.x) - zb * (c.x - a.x)) / area;
  const LatticePoint origin = a;
  if (b.y < a.y) std::swap(a, b);
  if (c.y < b.y) std::swap(b, c);
  if (b.y < a.y) std::swap(a, b);
  const Side whole(a, c), upper(a, b), lower(b, c);
  constexpr double kHair = 1e-6;
  for (int y = std::max(a.y, within.first.y); y <= std::min(c.y, within.last.y); ++y) {
    const double one = whole.at(y), other = y == b.y ? b.x : (y < b.y ? upper : lower).at(y);
    const int first = std::max(static_cast<int>(std::ceil(std::min(one, other) - kHair)), within.first.x);
    const int last = std::min(static_cast<int>(std::floor(std::max(one, other) + kHair)), within.last.x);
    const double row = z + slope_y * (y - origin.y);
    const float* cells = heights_.row(y).data();
    for (int x = first; x <= last; ++x) visit(x, y, std::abs(row + slope_x * (x - origin.x) - double{cells[x]}));
  }
}

void BlockFit::measure_face(int32_t t) {
  Face& face = faces_[static_cast<size_t>(t)];
  ++face.stamp;
  face.error = 0.0;
  face.inside = false;
  if (builder_.is_ghost(t)) return;
  const Triangle abc = builder_.corners(t);
  const LatticePoint a = cell(abc[0]), b = cell(abc[1]), c = cell(abc[2]);
  if (!domain_.holds_triangle(a, b, c)) return;
  face.inside = true;
  ++count_;
  const CellBox inner = {{box_.first.x + 1, box_.first.y + 1}, {box_.last.x - 1, box_.last.y - 1}};
  double worst = kLeastError_m;
  int at_x = -1, at_y = -1;
  for_each_cell(a, b, c, inner, [&](int x, int y, double error) {
    if (error > worst) worst = error, at_x = x, at_y = y;
  });
  if (at_x < 0) return;
  face.error = worst;
  face.x = static_cast<int16_t>(at_x - box_.first.x);
  face.y = static_cast<int16_t>(at_y - box_.first.y);
  heap_.push_back({face.error, t, face.stamp});
  std::push_heap(heap_.begin(), heap_.end());
}

void BlockFit::changed(std::span<const int32_t> faces) {
  for (const int32_t t : faces) {
    if (static_cast<size_t>(t) < faces_.size()) count_ -= faces_[static_cast<size_t>(t)].inside;
  }
  faces_.resize(static_cast<size_t>(builder_.triangle_count()));
  for (const int32_t t : faces) measure_face(t);
  drop_stale();
}

void BlockFit::drop_stale() {
  const auto is_stale = [&](const Waiting& w) { return faces_[static_cast<size_t>(w.face)].stamp != w.stamp; };
  while (!heap_.empty() && is_stale(heap_.front())) {
    std::pop_heap(heap_.begin(), heap_.end());
    heap_.pop_back();
  }
}

void BlockFit::start(std::vector<LatticePoint> cells) {
  for (LatticePoint& p : cells) p = {p.x - box_.first.x, p.y - box_.first.y};
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  builder_ = DelaunayBuilder<kBits>(std::move(cells));
  const std::vector<int32_t> order = spatial_order(builder_.points());
  if (!builder_.start(order)) return;
  for (const int32_t p : order) builder_.insert(p);
  std::vector<int32_t> all(static_cast<size_t>(builder_.triangle_count()));
  std::iota(all.begin(), all.end(), 0);
  changed(all);
}

void BlockFit::insert(std::span<const LatticePoint> cells) {
  if (faces_.empty()) return;  // all in a hole
  for (const LatticePoint& p : cells) changed(builder_.insert(builder_.add({p.x - box_.first.x, p.y - box_.first.y})));
}

double BlockFit::error_m() const { return heap_.empty() ? 0.0 : heap_.front().error; }

void BlockFit::refine(double error_m, int64_t most) {
  while (!heap_.empty() && this->error_m() > error_m && count_ + 2 <= most) {
    const int32_t t = heap_.front().face;
    const Face& worst = faces_[static_cast<size_t>(t)];
    changed(builder_.insert(builder_.add({worst.x, worst.y}), t));
  }
}

SurfaceError BlockFit::measure(const CellBox& counted) const {
  const int across = box_.last.x - box_.first.x + 1;
  std::vector<bool> seen(static_cast<size_t>(across) * static_cast<size_t>(box_.last.y - box_.first.y + 1));
  // Of the squares around a cell in `counted`, the last in reading order that holds it says whose it is.
  const auto is_mine = [&](int x, int y) {
    if (x != box_.first.x && x != box_.last.x && y != box_.first.y && y != box_.last.y) return true;
    for (const auto& [i, j] : {std::pair{x, y}, {x - 1, y}, {x, y - 1}, {x - 1, y - 1}}) {
      if (i < counted.first.x || j < counted.first.y || i >= counted.last.x || j >= counted.last.y) continue;
      if (domain_.square_holds(i, j, {x, y}))
        return i >= box_.first.x && j >= box_.first.y && i < box_.last.x && j < box_.last.y;
    }
    return false;
  };
  SurfaceError sum;
  for_each_triangle([&](LatticePoint a, LatticePoint b, LatticePoint c) {
    for_each_cell(a, b, c, box_, [&](int x, int y, double error) {
      const size_t i =
          static_cast<size_t>(y - box_.first.y) * static_cast<size_t>(across) + static_cast<size_t>(x - box_.first.x);
      if (seen[i] || !is_mine(x, y)) return;
      seen[i] = true;
      sum.add({error, error * error, 1});
    });
  });
  return sum;
}

}  // namespace seamount::geom
