#include "seamount/ops/render/contour_labels.h"

#include <algorithm>
#include <cmath>

namespace seamount::render {
namespace {

struct Candidate {
  double bend = 0.0;  ///< farthest point from the chord, pixels
  size_t line = 0;
  size_t first = 0, last = 0;  ///< points of the stretch, the last one possibly beyond the ring's end
};

double distance(Vec2 a, Vec2 b) { return std::hypot(b.x - a.x, b.y - a.y); }

/// Stretches as long as the label, one beginning at every step along the line.
void add_candidates(const LabelLine& line, size_t number, double size_px, std::vector<Candidate>& candidates) {
  constexpr double kMinTurns = 2.5;  // a label may take so much of its ring
  const Ring& ring = *line.ring;
  const size_t n = ring.size();
  double length = 0.0;
  for (size_t i = 0; i < n; ++i) length += distance(ring[i], ring[(i + 1) % n]);
  if (length < kMinTurns * line.width) return;
  double since = size_px;
  for (size_t i = 0; i < n; ++i) {
    since += distance(ring[(i + n - 1) % n], ring[i]);
    if (since < 0.5 * size_px) continue;
    since = 0.0;
    size_t last = i;
    while (last < i + n && distance(ring[i], ring[last % n]) < line.width) ++last;
    if (last == i + n) continue;
    const Vec2 chord = ring[last % n] - ring[i];
    const double span = std::sqrt(dot(chord, chord));
    if (span > 2.0 * line.width && last > i + 1) continue;
    double bend = 0.0;
    for (size_t k = i + 1; k < last; ++k) bend = std::max(bend, std::abs(cross(chord, ring[k % n] - ring[i])) / span);
    candidates.push_back({bend, number, i, last});
  }
}

}  // namespace

std::vector<ContourLabel> place_labels(const std::vector<LabelLine>& lines, double size_px, int width, int height,
                                       const RunContext& run) {
  constexpr double kMostBend = 0.33;  // of the size
  constexpr double kApart = 4.0;      // sizes between labels
  constexpr double kSameApart = 16.0;
  std::vector<Candidate> candidates;
  for (size_t i = 0; i < lines.size(); ++i) {
    run.check_cancelled();
    add_candidates(lines[i], i, size_px, candidates);
  }
  std::erase_if(candidates, [&](const Candidate& c) { return c.bend > kMostBend * size_px; });
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.bend < b.bend; });
  std::vector<ContourLabel> labels;
  for (const Candidate& candidate : candidates) {
    run.check_cancelled();
    const LabelLine& line = lines[candidate.line];
    const Vec2 a = (*line.ring)[candidate.first];
    const Vec2 b = (*line.ring)[candidate.last % line.ring->size()];
    const double span = distance(a, b);
    ContourLabel label{0.5 * (a + b), (1.0 / span) * (b - a), line.height_m, line.width};
    if (label.along.x < 0.0) label.along = -1.0 * label.along;
    const double margin = 0.6 * line.width;
    if (!(label.at.x > margin && label.at.x < width - margin && label.at.y > margin && label.at.y < height - margin))
      continue;
    const bool free = std::none_of(labels.begin(), labels.end(), [&](const ContourLabel& other) {
      const double apart = other.height_m == label.height_m ? kSameApart : kApart;
      return distance(label.at, other.at) < apart * size_px;
    });
    if (free) labels.push_back(label);
  }
  return labels;
}

}  // namespace seamount::render
