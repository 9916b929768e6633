#include "seamount/geom/contour/sheet_faces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "seamount/geom/contour/nesting.h"
#include "seamount/geom/polygon/edge_grid.h"

namespace seamount::geom {
namespace {

constexpr size_t kNone = std::numeric_limits<size_t>::max();

/// Stretches of the border that belong to one face.
class Joined {
 public:
  explicit Joined(size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), size_t{0}); }
  size_t find(size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(size_t a, size_t b) { parent_[find(a)] = find(b); }

 private:
  std::vector<size_t> parent_;
};

enum class High { unknown, left, right };

/// A line or ring between two faces.
struct Divide {
  double height = 0.0;
  size_t left = 0, right = 0;
  High high = High::unknown;
  bool open = false;
};

struct Face {
  double low = INFINITY, high = -INFINITY;  ///< heights of the lines around it
  std::vector<size_t> divides;
};

struct Faces {
  std::vector<Divide> divides;
  std::vector<Face> faces;
  std::vector<size_t> queue;

  void set_high(size_t divide, size_t face) {
    Divide& d = divides[divide];
    if (d.high != High::unknown) return;
    d.high = d.left == face ? High::left : High::right;
    queue.push_back(divide);
  }
  void set_low(size_t divide, size_t face) {
    set_high(divide, divides[divide].left == face ? divides[divide].right : divides[divide].left);
  }

  /// What is known of one line says the same of the others of its height around a face that has one height only.
  void spread() {
    while (!queue.empty()) {
      const size_t divide = queue.back();
      queue.pop_back();
      const Divide d = divides[divide];
      for (const size_t f : {d.left, d.right}) {
        if (faces[f].low != faces[f].high) continue;
        const bool above = (d.high == High::left) == (f == d.left);
        for (const size_t other : faces[f].divides) above ? set_high(other, f) : set_low(other, f);
      }
    }
  }
};

Faces gather(const std::vector<Divide>& divides, size_t count) {
  Faces all{divides, std::vector<Face>(count), {}};
  for (size_t i = 0; i < divides.size(); ++i)
    for (const size_t f : {divides[i].left, divides[i].right}) {
      Face& face = all.faces[f];
      face.low = std::min(face.low, divides[i].height);
      face.high = std::max(face.high, divides[i].height);
      face.divides.push_back(i);
    }
  for (size_t f = 0; f < count; ++f) {
    const Face& face = all.faces[f];
    if (face.low == face.high) continue;
    for (const size_t i : face.divides) {
      if (all.divides[i].height == face.low) all.set_high(i, f);
      if (all.divides[i].height == face.high) all.set_low(i, f);
    }
  }
  return all;
}

Joined join_stretches(const std::vector<SheetLine>& lines, size_t ends) {
  Joined joined(ends);
  for (const SheetLine& line : lines) {
    const size_t before_from = (line.from + ends - 1) % ends, before_to = (line.to + ends - 1) % ends;
    joined.join(before_from, line.to);
    joined.join(line.from, before_to);
  }
  return joined;
}

/// The face at the border or beside an open line that a ring which no other encloses lies in.
class Locator {
 public:
  Locator(const std::vector<SheetLine>& lines, const std::vector<Divide>& divides) : divides_(divides) {
    for (size_t i = 0; i < lines.size(); ++i) {
      const Polyline& points = lines[i].line->points;
      for (size_t k = 0; k + 1 < points.size(); ++k)
        if (!(points[k] == points[k + 1])) edges_.push_back({points[k], points[k + 1], i, k, edges_.size()});
    }
    grid_.emplace(edges_);
  }

  /// kNone if nothing lies to the west.
  size_t face_at(Vec2 p) const {
    const auto edge = grid_->first_to_the_west(p, [](const RingEdge&) { return true; });
    if (!edge) return kNone;
    const Divide& divide = divides_[edges_[*edge].ring];
    return edges_[*edge].a.y < edges_[*edge].b.y ? divide.right : divide.left;
  }

 private:
  const std::vector<Divide>& divides_;
  std::vector<RingEdge> edges_;
  std::optional<EdgeGrid> grid_;
};

/// Rings between the face around them and the one inside; those in a face that is not known are left out.
void add_rings(const std::vector<SheetLine>& lines, const std::vector<ValuedLine>& rings, std::vector<Divide>& divides,
               size_t& faces) {
  std::vector<Contour> contours;
  for (const ValuedLine& ring : rings) contours.push_back({ring.value, ring.points, -1});
  if (contours.empty() || find_contour_crossing(contours)) return;
  const std::vector<int> parents = find_contour_parents(contours);
  const std::vector<Divide> open = divides;
  const Locator locator(lines, open);
  const size_t first = faces;
  faces += rings.size();
  for (size_t i = 0; i < rings.size(); ++i) {
    const size_t around =
        parents[i] >= 0 ? first + static_cast<size_t>(parents[i]) : locator.face_at(rings[i].points[0]);
    if (around != kNone) divides.push_back({rings[i].value, first + i, around, High::unknown, false});
  }
}

/// Whether known lines have their high ground on the left, by most of them.
bool most_run_left(const std::vector<Divide>& divides, bool otherwise) {
  size_t left = 0, right = 0;
  for (const Divide& d : divides) {
    if (!d.open) continue;
    left += d.high == High::left;
    right += d.high == High::right;
  }
  return left == right ? otherwise : left > right;
}

}  // namespace

SideGuess find_sides(std::vector<SheetLine>& lines, size_t ends, const std::vector<ValuedLine>& rings,
                     bool left_is_high) {
  Joined joined = join_stretches(lines, ends);
  std::vector<Divide> divides;
  for (const SheetLine& line : lines)
    divides.push_back(
        {line.line->value, joined.find((line.from + ends - 1) % ends), joined.find(line.from), High::unknown, true});
  size_t faces = ends;
  add_rings(lines, rings, divides, faces);
  Faces all = gather(divides, faces);
  all.spread();
  const bool left = most_run_left(all.divides, left_is_high);
  SideGuess guess;
  for (size_t i = 0; i < lines.size(); ++i) {
    if (all.divides[i].high == High::unknown) {
      ++guess.guessed;
      all.set_high(i, left ? all.divides[i].left : all.divides[i].right);
      all.spread();
    }
    lines[i].left_is_high = all.divides[i].high == High::left;
  }
  return guess;
}

}  // namespace seamount::geom
