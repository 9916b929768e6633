// Marching squares on the lattice of cell centres, widened by one line of samples on the frame's edge and, for areas,
// by another of "nothing" at the same place, which closes them. A contour crosses lattice edges; each crossing is the
// end of one segment and the start of the next, so segments keyed by their first edge are a linked list.
#include "seamount/geom/contour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "seamount/geom/polygon.h"

namespace seamount::geom {
namespace {

constexpr float kNothing = -std::numeric_limits<float>::infinity();

struct Segment {
  int64_t from, to;  ///< keys of lattice edges
  int64_t order;     ///< position in the scan
};

/// Edges of a square: 0 top, 1 right, 2 bottom, 3 left. Segments of the 16 cases (bits: NW 1, NE 2, SE 4, SW 8 are
/// high), high ground on the left; kSaddleLow for 5 and 10 where the middle is low, this table where it is high.
struct Case {
  int count;
  std::array<std::array<int, 2>, 2> segments;
};
constexpr std::array<Case, 16> kCases = {{{0, {}},
                                          {1, {{{3, 0}}}},
                                          {1, {{{0, 1}}}},
                                          {1, {{{3, 1}}}},
                                          {1, {{{1, 2}}}},
                                          {2, {{{1, 0}, {3, 2}}}},
                                          {1, {{{0, 2}}}},
                                          {1, {{{3, 2}}}},
                                          {1, {{{2, 3}}}},
                                          {1, {{{2, 0}}}},
                                          {2, {{{0, 3}, {2, 1}}}},
                                          {1, {{{2, 1}}}},
                                          {1, {{{1, 3}}}},
                                          {1, {{{1, 0}}}},
                                          {1, {{{0, 3}}}},
                                          {0, {}}}};
constexpr Case kSaddleLow5 = {2, {{{3, 0}, {1, 2}}}};
constexpr Case kSaddleLow10 = {2, {{{0, 1}, {2, 3}}}};

/// The widened lattice: columns [-margin, width + margin), margin 1 for lines and 2 for areas.
class Lattice {
 public:
  Lattice(const ScalarField& field, double level, int margin)
      : field_(field), level_(static_cast<float>(level)), margin_(margin), stride_(field.width() + 2 * margin) {}

  int columns() const { return stride_; }
  int rows() const { return field_.height() + 2 * margin_; }

  float value(int column, int row) const {
    const int x = column - margin_;
    const int y = row - margin_;
    if (margin_ == 2 && (x < -1 || y < -1 || x > field_.width() || y > field_.height())) return kNothing;
    const float v = field_.clamped(x, y);
    return std::isnan(v) ? kNothing : v;
  }

  Vec2 place(int column, int row) const {
    const GridFrame& frame = field_.frame();
    const double x = std::clamp(column - margin_ + 0.0, -0.5, frame.width - 0.5);
    const double y = std::clamp(row - margin_ + 0.0, -0.5, frame.height - 0.5);
    return {frame.x(x), frame.y(y)};
  }

  int64_t key(int column, int row, int edge) const {
    const int64_t at = static_cast<int64_t>(row + (edge == 2 ? 1 : 0)) * stride_ + column + (edge == 1 ? 1 : 0);
    return 2 * at + (edge % 2);
  }

  /// Where the level crosses an edge; never closer to a lattice point than a ten thousandth of the edge, so that
  /// contours do not touch at samples that equal the level.
  Vec2 crossing(int64_t edge) const {
    const int column = static_cast<int>((edge / 2) % stride_);
    const int row = static_cast<int>((edge / 2) / stride_);
    const int next_column = column + (edge % 2 == 0 ? 1 : 0);
    const int next_row = row + (edge % 2 == 0 ? 0 : 1);
    const double a = value(column, row);
    const double b = value(next_column, next_row);
    double t = 0.5;
    if (std::isfinite(a) && std::isfinite(b)) t = std::clamp((level_ - a) / (b - a), 1e-4, 1.0 - 1e-4);
    const Vec2 from = place(column, row);
    return from + t * (place(next_column, next_row) - from);
  }

  /// All segments, row by row.
  std::vector<Segment> segments() const {
    std::vector<Segment> found;
    std::vector<uint8_t> above(static_cast<size_t>(stride_));
    std::vector<uint8_t> below(above.size());
    flag_row(0, below);
    for (int row = 0; row + 1 < rows(); ++row) {
      std::swap(above, below);
      flag_row(row + 1, below);
      for (size_t c = 0; c + 1 < above.size(); ++c) {
        const int code = above[c] | above[c + 1] << 1 | below[c + 1] << 2 | below[c] << 3;
        if (code != 0 && code != 15) add_case(code, static_cast<int>(c), row, found);
      }
    }
    return found;
  }

 private:
  void flag_row(int row, std::vector<uint8_t>& flags) const {
    const int y = row - margin_;
    const bool outside = margin_ == 2 && (y < -1 || y > field_.height());
    const std::span<const float> values = field_.row(std::clamp(y, 0, field_.height() - 1));
    const size_t first = static_cast<size_t>(margin_);
    for (size_t x = 0; x < values.size(); ++x) flags[first + x] = !outside && values[x] >= level_ ? 1 : 0;
    flags[first - 1] = flags[first];
    flags[first + values.size()] = flags[first + values.size() - 1];
    if (margin_ == 2) flags.front() = flags.back() = 0;
  }

  void add_case(int code, int column, int row, std::vector<Segment>& found) const {
    const Case* entry = &kCases[static_cast<size_t>(code)];
    if (code == 5 || code == 10) {
      const float mean =
          0.25F * (value(column, row) + value(column + 1, row) + value(column, row + 1) + value(column + 1, row + 1));
      if (!(mean >= level_)) entry = code == 5 ? &kSaddleLow5 : &kSaddleLow10;
    }
    for (int s = 0; s < entry->count; ++s) {
      const std::array<int, 2>& ends = entry->segments[static_cast<size_t>(s)];
      found.push_back({key(column, row, ends[0]), key(column, row, ends[1]), static_cast<int64_t>(found.size())});
    }
  }

  const ScalarField& field_;
  float level_;
  int margin_;
  int stride_;
};

struct Chain {
  Polyline points;
  bool closed = false;
};

/// Joins segments into chains, in the order of their first segments; open chains begin where nothing leads.
class Linker {
 public:
  Linker(const Lattice& lattice, std::vector<Segment> segments)
      : lattice_(lattice), segments_(std::move(segments)), used_(segments_.size(), 0) {
    scan_.resize(segments_.size());
    std::sort(segments_.begin(), segments_.end(), [](const Segment& a, const Segment& b) { return a.from < b.from; });
    for (size_t i = 0; i < segments_.size(); ++i) scan_[static_cast<size_t>(segments_[i].order)] = i;
  }

  std::vector<Chain> chains() {
    std::vector<Chain> result;
    std::vector<char> entered(segments_.size(), 0);
    for (const Segment& segment : segments_) {
      if (const size_t next = find(segment.to); next < segments_.size()) entered[next] = 1;
    }
    for (const size_t i : scan_) {
      if (entered[i] == 0) result.push_back(follow(i));
    }
    for (const size_t i : scan_) {
      if (used_[i] == 0) result.push_back(follow(i));
    }
    return result;
  }

 private:
  size_t find(int64_t edge) const {
    const auto at = std::lower_bound(segments_.begin(), segments_.end(), edge,
                                     [](const Segment& s, int64_t e) { return s.from < e; });
    return at != segments_.end() && at->from == edge ? static_cast<size_t>(at - segments_.begin()) : segments_.size();
  }

  Chain follow(size_t first) {
    Chain chain;
    size_t at = first;
    while (at < segments_.size() && used_[at] == 0) {
      used_[at] = 1;
      chain.points.push_back(lattice_.crossing(segments_[at].from));
      const int64_t to = segments_[at].to;
      at = find(to);
      if (at == segments_.size()) chain.points.push_back(lattice_.crossing(to));
    }
    chain.closed = at == first;
    return chain;
  }

  const Lattice& lattice_;
  std::vector<Segment> segments_;
  std::vector<char> used_;
  std::vector<size_t> scan_;
};

std::vector<Chain> trace(const ScalarField& field, double level, int margin) {
  if (field.empty()) return {};
  const Lattice lattice(field, level, margin);
  return Linker(lattice, lattice.segments()).chains();
}

/// Drops repeated points and points in the middle of a straight run along an axis (the frame's edge).
Ring tidy(const Polyline& points) {
  Ring ring;
  const auto between = [](Vec2 a, Vec2 b, Vec2 c) { return (a.x == b.x && b.x == c.x) || (a.y == b.y && b.y == c.y); };
  for (const Vec2 p : points) {
    if (!ring.empty() && ring.back() == p) continue;
    if (ring.size() > 1 && between(ring[ring.size() - 2], ring.back(), p)) ring.pop_back();
    ring.push_back(p);
  }
  while (ring.size() > 2 &&
         (ring.back() == ring.front() || between(ring[ring.size() - 2], ring.back(), ring.front()))) {
    ring.pop_back();
  }
  if (ring.size() > 2 && between(ring.back(), ring[0], ring[1])) ring.erase(ring.begin());
  return ring;
}

/// Sorts closed rings into polygons: a clockwise ring is a hole of the smallest ring around it.
std::vector<Polygon> nest(std::vector<Ring> rings) {
  std::vector<Polygon> polygons;
  std::vector<double> areas;
  std::vector<Box> boxes;
  for (Ring& ring : rings) {
    const double size = signed_area(ring);
    if (size <= 0.0) continue;
    areas.push_back(size);
    boxes.push_back(bounding_box(ring));
    polygons.push_back({std::move(ring), {}});
    ring.clear();
  }
  for (Ring& ring : rings) {
    if (ring.size() < 3) continue;
    const Vec2 p = ring.front();
    size_t best = polygons.size();
    for (size_t i = 0; i < polygons.size(); ++i) {
      const Box& box = boxes[i];
      const bool boxed = p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y;
      if (!boxed || (best < polygons.size() && areas[i] >= areas[best])) continue;
      if (contains(polygons[i].outer, p)) best = i;
    }
    if (best < polygons.size()) polygons[best].holes.push_back(std::move(ring));
  }
  return polygons;
}

/// Taubin's smoothing (1995: shrink, then swell, so the size stays) with every point kept within `reach` of where it
/// was, and points on the frame's edge left there.
Ring smooth_steps(const Ring& ring, double reach, const GridFrame& frame) {
  constexpr int kRounds = 12;
  const size_t n = ring.size();
  if (n < 4) return ring;
  Ring now = ring;
  Ring next(n);
  for (int half = 0; half < 2 * kRounds; ++half) {
    const double share = half % 2 == 0 ? 0.5 : -0.53;
    for (size_t i = 0; i < n; ++i) {
      const Vec2 middle = 0.5 * (now[(i + n - 1) % n] + now[(i + 1) % n]);
      next[i] = now[i] + share * (middle - now[i]);
      const Vec2 moved = next[i] - ring[i];
      const double distance = std::hypot(moved.x, moved.y);
      if (distance > reach) next[i] = ring[i] + (reach / distance) * moved;
      const bool pinned = ring[i].x <= frame.west_m || ring[i].x >= frame.east_m() || ring[i].y >= frame.north_m ||
                          ring[i].y <= frame.south_m();
      if (pinned) next[i] = ring[i];
    }
    std::swap(now, next);
  }
  return now;
}

}  // namespace

std::vector<Polygon> trace_areas(const ScalarField& field, double level) {
  std::vector<Ring> rings;
  for (const Chain& chain : trace(field, level, 2)) {
    Ring ring = tidy(chain.points);
    if (ring.size() >= 3) rings.push_back(std::move(ring));
  }
  return nest(std::move(rings));
}

std::vector<Polyline> trace_lines(const ScalarField& field, double level) {
  std::vector<Polyline> lines;
  for (Chain& chain : trace(field, level, 1)) {
    if (chain.closed) chain.points.push_back(chain.points.front());
    lines.push_back(std::move(chain.points));
  }
  return lines;
}

std::vector<Polygon> trace_mask(const Grid<uint8_t>& inside) {
  ScalarField field(inside.frame());
  std::transform(inside.cells().begin(), inside.cells().end(), field.cells().begin(),
                 [](uint8_t in) { return in != 0 ? 1.0F : 0.0F; });
  std::vector<Polygon> polygons = trace_areas(field, 0.5);
  const double reach = 0.45 * inside.cell_m();
  for (Polygon& polygon : polygons) {
    polygon.outer = smooth_steps(polygon.outer, reach, inside.frame());
    for (Ring& hole : polygon.holes) hole = smooth_steps(hole, reach, inside.frame());
  }
  return polygons;
}

}  // namespace seamount::geom
