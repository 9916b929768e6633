#include "seamount/ops/contour/edit/match.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/polygon/polygon.h"

namespace seamount::contour {
namespace {

constexpr int kAlong = 48;                                 ///< places along a ring
constexpr std::array<double, 3> kRings = {0.9, 1.0, 1.1};  ///< the outline, and smaller and larger ones
constexpr double kMeanCounts = 0.5;
constexpr int kTurns = 8;
constexpr double kStep = 1.0 / 9.0;  ///< of the outline's extent, between places that are tried
constexpr int kMostSteps = 96;       ///< along a side of a source

constexpr std::array<double, 2> kInner = {0.35, 0.65};  ///< rings whose mean height alone counts

struct Sample {
  Vec2 at;
  double height;
};
struct Samples {
  std::vector<Sample> rim, inner;
};

double extent_of(const geom::Box& box) { return std::max(box.high.x - box.low.x, box.high.y - box.low.y); }

double height_at(const ScalarField& ground, Vec2 p) {
  return static_cast<double>(geom::sample_bilinear(ground, ground.frame().column(p.x), ground.frame().row(p.y)));
}

bool has(const PatchSource& source, Vec2 p) {
  const GridFrame& frame = source.room.frame();
  const double x = std::round(frame.column(p.x));
  const double y = std::round(frame.row(p.y));
  return x >= 0.0 && y >= 0.0 && x < frame.width && y < frame.height &&
         source.room(static_cast<int>(x), static_cast<int>(y)) > 0.0F;
}

/// Places along a ring like the outline, with the heights there.
void add_ring(const ScalarField& ground, const Ring& ring, Vec2 middle, double share, std::vector<Sample>& samples) {
  const double spacing = geom::ring_length(ring) / kAlong;
  double left = 0.0;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 d = ring[(i + 1) % ring.size()] - ring[i];
    const double length = std::hypot(d.x, d.y);
    for (; left < length; left += spacing) {
      const Vec2 p = middle + share * (ring[i] + (left / length) * d - middle);
      samples.push_back({p, height_at(ground, p)});
    }
    left -= length;
  }
}

struct Spread {
  double count = 0.0, sum = 0.0, squares = 0.0;
  void add(double height) {
    count += 1.0;
    sum += height;
    squares += height * height;
  }
  double deviation() const { return std::sqrt(std::max(0.0, squares - sum * sum / count) / count); }
};

class Search {
 public:
  Search(const Samples& samples, const std::vector<PatchSource>& sources) : samples_(samples), sources_(sources) {}

  /// Infinite where the source has no ground for all samples, or once it is above `most`.
  double misfit(size_t source, const Placement& placement, double most) const {
    const PatchSource& from = sources_[source];
    if (!has(from, placement.from)) return kNone;
    double sum = 0.0;
    double squares = 0.0;
    double count = 0.0;
    const double limit = most * most * static_cast<double>(samples_.rim.size());
    for (const Sample& sample : samples_.rim) {
      const Vec2 p = placement.to_source(sample.at);
      if (!has(from, p)) return kNone;
      const double off = sample.height - placement.scale * height_at(from.ground, p);
      sum += off;
      squares += off * off;
      count += 1.0;
      if (squares - sum * sum / count > limit) return kNone;
    }
    double inner = 0.0;
    Spread spread;
    for (const Sample& sample : samples_.inner) {
      const Vec2 p = placement.to_source(sample.at);
      if (!has(from, p)) return kNone;
      const double height = height_at(from.ground, p);
      inner += sample.height - placement.scale * height;
      spread.add(height);
    }
    const double off = inner / static_cast<double>(samples_.inner.size()) - sum / count;
    // A plain is never far off, but it is not like mountains.
    const double flat = std::max(0.0, spread_ - placement.scale * spread.deviation());
    return std::sqrt(std::max(0.0, squares - sum * sum / count) / count + kMeanCounts * (off * off + flat * flat));
  }

  /// The best of each row of the seed's lattice of places, the best first.
  std::vector<Match> coarse(Vec2 middle, double extent, Seed seed, const RunContext& run) const {
    std::vector<Match> all;
    for (size_t s = 0; s < sources_.size(); ++s) {
      const GridFrame& frame = sources_[s].ground.frame();
      const double wanted = kStep * extent / sources_[s].scale;
      const auto steps = [&](double side) { return std::clamp(static_cast<int>(side / wanted), 1, kMostSteps); };
      const int columns = steps(frame.width_m());
      const int rows = steps(frame.height_m());
      Rng rng(seed.derive("shift", s));
      const Vec2 shift = {rng.uniform(0.0, 1.0), rng.uniform(0.0, 1.0)};
      std::vector<std::optional<Match>> found(static_cast<size_t>(rows));
      parallel_blocks(run, rows, 1, [&](int64_t begin, int64_t) {
        std::optional<Match>& own = found[static_cast<size_t>(begin)];
        for (int column = 0; column < columns; ++column) {
          for (int k = 0; k < 2 * kTurns; ++k) {
            Placement placement;
            placement.at = middle;
            placement.from = {frame.west_m + (column + shift.x) / columns * frame.width_m(),
                              frame.south_m() + (static_cast<double>(begin) + shift.y) / rows * frame.height_m()};
            placement.turn = direction(2.0 * std::numbers::pi * std::floor(0.5 * k) / kTurns);
            placement.mirrored = k % 2 == 1;
            placement.scale = sources_[s].scale;
            const double off = misfit(s, placement, own ? own->misfit_m : kNone);
            if (off < (own ? own->misfit_m : kNone)) own = Match{s, placement, off};
          }
        }
      });
      for (const std::optional<Match>& own : found)
        if (own) all.push_back(*own);
    }
    std::stable_sort(all.begin(), all.end(), [](const Match& a, const Match& b) { return a.misfit_m < b.misfit_m; });
    return all;
  }

  /// Moves and turns it as long as that helps.
  Match refined(Match match, double extent) const {
    double step = 0.5 * kStep * extent / match.placement.scale;
    double angle = std::numbers::pi / kTurns;
    for (int round = 0; round < 6; ++round) {
      for (const auto& [dx, dy, turn] : {std::array{1.0, 0.0, 0.0},
                                         {-1.0, 0.0, 0.0},
                                         {0.0, 1.0, 0.0},
                                         {0.0, -1.0, 0.0},
                                         {0.0, 0.0, 1.0},
                                         {0.0, 0.0, -1.0}}) {
        Placement moved = match.placement;
        moved.from = moved.from + step * Vec2{dx, dy};
        const Vec2 by = direction(turn * angle);
        moved.turn = {by.x * moved.turn.x - by.y * moved.turn.y, by.y * moved.turn.x + by.x * moved.turn.y};
        const double off = misfit(match.source, moved, match.misfit_m);
        if (off < match.misfit_m) match = {match.source, moved, off};
      }
      step *= 0.6;
      angle *= 0.6;
    }
    return match;
  }

 private:
  static constexpr double kNone = std::numeric_limits<double>::infinity();
  static Vec2 direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

  const Samples& samples_;
  const std::vector<PatchSource>& sources_;
  double spread_ = 0.0;  ///< of heights along the rim
};

}  // namespace

std::optional<Match> find_match(const ScalarField& ground, const ScalarField& expected, const Polygon& outline,
                                const std::vector<PatchSource>& sources, Seed seed, const RunContext& run) {
  const geom::Box box = geom::bounding_box(outline.outer);
  const Vec2 middle = 0.5 * (box.low + box.high);
  Samples samples;
  for (const double share : kRings) add_ring(ground, outline.outer, middle, share, samples.rim);
  for (const double share : kInner) add_ring(expected, outline.outer, middle, share, samples.inner);
  const Search search(samples, sources);
  constexpr size_t kRefined = 8;
  std::optional<Match> best;
  const std::vector<Match> found = search.coarse(middle, extent_of(box), seed, run);
  for (size_t i = 0; i < std::min(kRefined, found.size()); ++i) {
    const Match match = search.refined(found[i], extent_of(box));
    if (!best || match.misfit_m < best->misfit_m) best = match;
  }
  return best;
}

}  // namespace seamount::contour
