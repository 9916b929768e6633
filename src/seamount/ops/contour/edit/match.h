// The piece of ground that fits an outline best: retrieval for `fill` (P2 sec. 6.6: "the system would retrieve and
// adapt a matching terrain patch").
//
// Candidates are the outline itself laid anywhere over the sources, turned and mirrored; each is judged by how well the
// heights below it and a little beyond it agree with those around the outline, but for a common shift. Heights along
// two rings are heights and slopes; within it the mean height and the spread count too: the distribution is kept.
// The best of a lattice of places (shifted by the seed) and 16 attitudes is refined.
#pragma once

#include <optional>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"
#include "seamount/model/grid.h"

namespace seamount::contour {

/// Where ground of one place comes to lie at another.
struct Placement {
  Vec2 from;              ///< the place that is laid
  Vec2 at;                ///< where it comes to lie
  Vec2 turn = {1, 0};     ///< unit vector of the source's east
  double scale = 1.0;     ///< of lengths
  bool mirrored = false;  ///< about the source's north, before it is turned

  Vec2 to_world(Vec2 p) const {
    const Vec2 d = scale * Vec2{mirrored ? from.x - p.x : p.x - from.x, p.y - from.y};
    return at + Vec2{turn.x * d.x - turn.y * d.y, turn.y * d.x + turn.x * d.y};
  }
  Vec2 to_source(Vec2 p) const {
    const Vec2 d = (1.0 / scale) * (p - at);
    const Vec2 q = {turn.x * d.x + turn.y * d.y, turn.x * d.y - turn.y * d.x};
    return from + Vec2{mirrored ? -q.x : q.x, q.y};
  }
};

/// Ground to take from.
struct PatchSource {
  ScalarField ground;
  ScalarField room;    ///< on the same frame: above 0 where it may be taken
  double scale = 1.0;  ///< of lengths and heights, at which it is laid
};

struct Match {
  size_t source;
  Placement placement;
  double misfit_m;  ///< root of the mean square that heights are off
};

/// Nothing where no source has room for the outline. `ground` holds heights around it,
/// `expected` those within it of which the mean should come out. Parallel; about 50 ms for a
/// thousand places.
std::optional<Match> find_match(const ScalarField& ground, const ScalarField& expected, const Polygon& outline,
                                const std::vector<PatchSource>& sources, Seed seed, const RunContext& run);

}  // namespace seamount::contour
