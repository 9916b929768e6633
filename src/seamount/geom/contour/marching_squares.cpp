// The lattice of cell centres is widened by one line of samples that repeat the outermost and, where contours are to be
// closed, by another that lies below every level. Squares are taken row by row; the crossings on a square's upper edge
// are known from the row above, those on the other three are numbered when they are first met.
#include "seamount/geom/contour/marching_squares.h"

#include <array>
#include <cmath>
#include <limits>

#include "seamount/base/error.h"

namespace seamount::geom {
namespace {

constexpr float kNothing = -std::numeric_limits<float>::infinity();

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

/// A sample with its rank among the levels.
struct Sample {
  float value;
  uint32_t rank;
};

/// The crossings of an edge: levels [low, high) from number `first` on.
struct EdgeCrossings {
  uint32_t first = 0, low = 0;
  uint32_t at(uint32_t level) const { return first + (level - low); }
};

class SquareMarch {
 public:
  SquareMarch(const ScalarField& field, std::span<const double> levels, FieldEdge edge)
      : field_(field), levels_(levels), edge_(edge), margin_(edge == FieldEdge::open ? 1 : 2) {
    const auto columns = static_cast<size_t>(field.width() + 2 * margin_);
    for (std::vector<Sample>* row : {&above_, &below_}) row->resize(columns);
    for (std::vector<EdgeCrossings>* row : {&top_, &bottom_, &side_}) row->resize(columns);
    if (edge == FieldEdge::apron) outside_ = height_below(levels);
  }

  std::vector<ContourChain> trace(const RunContext& run) {
    read_row(0);
    cross_row(0, top_);
    for (int row = 0; row + 1 < field_.height() + 2 * margin_; ++row) {
      run.check_cancelled();
      std::swap(above_, below_);
      read_row(row + 1);
      cross_row(row + 1, bottom_);
      cross_sides(row);
      for (size_t c = 0; c + 1 < above_.size(); ++c) add_square(c);
      std::swap(top_, bottom_);
    }
    return join_segments(crossings_, segments_, run);
  }

 private:
  /// Fills below_ with a row of the lattice.
  void read_row(int row) {
    const int y = row - margin_;
    const bool outside = margin_ == 2 && (y < -1 || y > field_.height());
    const std::span<const float> values = field_.row(std::clamp(y, 0, field_.height() - 1));
    const auto first = static_cast<size_t>(margin_);
    for (size_t x = 0; x < values.size(); ++x) {
      const float v = outside || std::isnan(values[x]) ? kNothing : values[x];
      below_[first + x] = {v, level_rank(levels_, v)};
    }
    below_[first - 1] = below_[first];
    below_[first + values.size()] = below_[first + values.size() - 1];
    if (margin_ == 2) below_.front() = below_.back() = {kNothing, 0};
  }

  Vec2 place(size_t column, int row) const {
    const GridFrame& frame = field_.frame();
    const double reach = edge_ == FieldEdge::apron ? 1.5 : 0.5;
    // The line of repeated samples lies on the frame's edge.
    const auto stretch = [&](int i, int size) {
      const double inner = std::clamp(i + 0.0, -0.5, size - 0.5);
      return i < -1 ? -reach : (i > size ? size - 1 + reach : inner);
    };
    const double x = stretch(static_cast<int>(column) - margin_, frame.width);
    const double y = stretch(row - margin_, frame.height);
    return {frame.x(x), frame.y(y)};
  }

  /// Numbers the crossings between two neighbouring samples.
  EdgeCrossings cross(const Sample& a, const Sample& b, size_t column, int row, size_t next_column, int next_row) {
    EdgeCrossings edge{static_cast<uint32_t>(crossings_.size()), std::min(a.rank, b.rank)};
    const uint32_t count = std::max(a.rank, b.rank) - edge.low;
    if (count == 0) return edge;
    if (crossings_.size() + count >= std::numeric_limits<uint32_t>::max()) throw Error("contours: too many points");
    const double from_value = value_of(a);
    const double to_value = value_of(b);
    const Vec2 from = place(column, row);
    const Vec2 along = place(next_column, next_row) - from;
    for (uint32_t i = 0; i < count; ++i) {
      const double level = levels_[edge.low + i];
      const bool finite = std::isfinite(from_value) && std::isfinite(to_value);
      const double exact = finite ? (level - from_value) / (to_value - from_value) : 0.5;
      const double t = spread_share(exact, a.rank < b.rank ? i : count - 1 - i, count);
      crossings_.push_back({from + t * along, edge.low + i});
    }
    return edge;
  }

  double value_of(const Sample& sample) const { return sample.value == kNothing ? outside_ : sample.value; }

  void cross_row(int row, std::vector<EdgeCrossings>& edges) {
    for (size_t c = 0; c + 1 < below_.size(); ++c) edges[c] = cross(below_[c], below_[c + 1], c, row, c + 1, row);
  }

  void cross_sides(int row) {
    for (size_t c = 0; c < below_.size(); ++c) side_[c] = cross(above_[c], below_[c], c, row, c, row + 1);
  }

  void add_square(size_t c) {
    const std::array<Sample, 4> corners = {above_[c], above_[c + 1], below_[c + 1], below_[c]};
    const auto [low, high] = std::minmax({corners[0].rank, corners[1].rank, corners[2].rank, corners[3].rank});
    for (uint32_t level = low; level < high; ++level) add_case(c, level, corners);
  }

  void add_case(size_t c, uint32_t level, const std::array<Sample, 4>& corners) {
    unsigned code = 0;
    for (size_t i = 0; i < 4; ++i) code |= (corners[i].rank > level ? 1U : 0U) << i;
    const Case* entry = &kCases[code];
    if (code == 5 || code == 10) {
      const float mean = 0.25F * (corners[0].value + corners[1].value + corners[3].value + corners[2].value);
      if (!(mean >= levels_[level])) entry = code == 5 ? &kSaddleLow5 : &kSaddleLow10;
    }
    const std::array<EdgeCrossings, 4> edges = {top_[c], side_[c + 1], bottom_[c], side_[c]};
    for (size_t s = 0; s < static_cast<size_t>(entry->count); ++s) {
      const std::array<int, 2>& ends = entry->segments[s];
      segments_.push_back(
          {edges[static_cast<size_t>(ends[0])].at(level), edges[static_cast<size_t>(ends[1])].at(level)});
    }
  }

  const ScalarField& field_;
  std::span<const double> levels_;
  FieldEdge edge_;
  int margin_;
  double outside_ = kNothing;
  std::vector<Sample> above_, below_;
  std::vector<EdgeCrossings> top_, bottom_, side_;
  std::vector<Crossing> crossings_;
  std::vector<ContourSegment> segments_;
};

}  // namespace

std::vector<ContourChain> march_squares(const ScalarField& field, std::span<const double> levels, FieldEdge edge,
                                        const RunContext& run) {
  if (field.empty() || levels.empty()) return {};
  return SquareMarch(field, levels, edge).trace(run);
}

}  // namespace seamount::geom
