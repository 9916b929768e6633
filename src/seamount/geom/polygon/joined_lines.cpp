#include "seamount/geom/polygon/joined_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace seamount::geom {
namespace {

constexpr size_t kNone = SIZE_MAX;

/// One end of an open line: number 2 i for the first point of line i, 2 i + 1 for the last.
struct End {
  Vec2 at;
  size_t number;
};

bool is_closed(const ValuedLine& line) {
  return line.closed || (line.points.size() > 3 && line.points.front() == line.points.back());
}

/// For each end the one that it is joined to, or kNone. Shortest gaps first.
std::vector<size_t> match_ends(const std::vector<ValuedLine>& lines, bool same_value, double tolerance_m) {
  std::vector<End> ends;
  for (size_t i = 0; i < lines.size(); ++i) {
    if (is_closed(lines[i]) || lines[i].points.size() < 2) continue;
    ends.push_back({lines[i].points.front(), 2 * i});
    ends.push_back({lines[i].points.back(), 2 * i + 1});
  }
  std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) {
    return a.at.x != b.at.x ? a.at.x < b.at.x : a.at.y != b.at.y ? a.at.y < b.at.y : a.number < b.number;
  });
  struct Gap {
    double length;
    size_t first, second;
  };
  std::vector<Gap> gaps;
  constexpr size_t kMostNeighbours = 64;
  for (size_t i = 0; i < ends.size(); ++i) {
    size_t found = 0;
    for (size_t j = i + 1; j < ends.size() && ends[j].at.x - ends[i].at.x <= tolerance_m; ++j) {
      const Vec2 way = ends[j].at - ends[i].at;
      const double length = std::hypot(way.x, way.y);
      const size_t a = ends[i].number, b = ends[j].number;
      const bool short_loop = a / 2 == b / 2 && lines[a / 2].points.size() < 4;
      if (length > tolerance_m || short_loop) continue;
      if (same_value && lines[a / 2].value != lines[b / 2].value) continue;
      gaps.push_back({length, std::min(a, b), std::max(a, b)});
      if (++found == kMostNeighbours) break;
    }
  }
  std::sort(gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) {
    return a.length != b.length ? a.length < b.length : a.first != b.first ? a.first < b.first : a.second < b.second;
  });
  std::vector<size_t> partner(2 * lines.size(), kNone);
  for (const Gap& gap : gaps) {
    if (partner[gap.first] != kNone || partner[gap.second] != kNone) continue;
    partner[gap.first] = gap.second;
    partner[gap.second] = gap.first;
  }
  return partner;
}

void append(Polyline& chain, const Polyline& piece, bool forwards) {
  Polyline points = piece;
  if (!forwards) std::reverse(points.begin(), points.end());
  for (const Vec2 p : points)
    if (chain.empty() || !(chain.back() == p)) chain.push_back(p);
}

}  // namespace

std::vector<ValuedLine> join_lines(const std::vector<ValuedLine>& lines, bool same_value, double tolerance_m) {
  const std::vector<size_t> partner = match_ends(lines, same_value, tolerance_m);
  std::vector<char> used(lines.size(), 0);
  std::vector<ValuedLine> joined;
  for (size_t i = 0; i < lines.size(); ++i) {
    if (used[i] != 0) continue;
    if (is_closed(lines[i]) || lines[i].points.size() < 2) {
      joined.push_back(lines[i]);
      ValuedLine& line = joined.back();
      if (line.closed || line.points.size() < 2) continue;
      line.points.pop_back();
      line.closed = true;
      continue;
    }
    // Back to where the chain begins, or all around.
    size_t start = 2 * i;
    while (partner[start] != kNone && partner[start] / 2 != i) start = partner[start] ^ 1;
    ValuedLine line{{}, lines[i].value, partner[start] != kNone, lines[i].attributes};
    if (line.closed) start = 2 * i;
    for (size_t end = start; used[end / 2] == 0;) {
      used[end / 2] = 1;
      append(line.points, lines[end / 2].points, end % 2 == 0);
      if (partner[end ^ 1] == kNone) break;
      end = partner[end ^ 1];
    }
    if (line.closed && line.points.size() > 1 && line.points.front() == line.points.back()) line.points.pop_back();
    joined.push_back(std::move(line));
  }
  return joined;
}

LineAreas areas_from_lines(const std::vector<ValuedLine>& lines) {
  constexpr double kShare = 1e-9;  // of the coordinates: what rounding leaves of ends that were one place
  double largest = 0.0;
  for (const ValuedLine& line : lines)
    for (const Vec2 p : line.points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  LineAreas result;
  for (ValuedLine& line : join_lines(lines, false, kShare * largest)) {
    if (line.closed && line.points.size() >= 3)
      result.areas.push_back({"", {{std::move(line.points), {}}}, std::move(line.attributes)});
    else
      result.open.push_back(std::move(line));
  }
  return result;
}

}  // namespace seamount::geom
