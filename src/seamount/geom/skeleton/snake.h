// Curves that are fitted to a field (P3 sec. 1.5.2, eq. 1.27-1.31): rivers, reef crests, canyons.
//
// A snake of length l minimises, over its arc length a with unit tangent T,
//   E = alpha_i * (tension + rigidity)                       see elastic_line.h
//     - alpha_e / u * integral of Gamma / g da               high Gamma attracts (eq. 1.29)
//     + alpha_s * ((L - l) / (0.05 L))^2                     only with a target length L
//     - alpha_g / u * integral of q(<T, u/8 grad Gamma / g>) da  along the slope for alpha_g > 0, the contour for < 0
// with u = L, or the length that a curve comes with where it has no target; g = field_unit, the difference of Gamma
// that counts 1; q(s) = s^2 / (1 + s^2 / 16), which is s^2 but for cliffs. With a target the integrals are means along
// the curve (1 / l instead of 1 / u), so that what is the same everywhere does not lengthen it. All terms are numbers
// near 1 that depend neither on the size of the world (places and lengths scaled alike) nor on the unit of Gamma nor,
// in the limit, on the number of vertices: weights near 1 suit a reef of 10 m as well as a river of 10 km. A target is
// stiff and met within 5 %.
//
// Descent: Gauss-Newton steps with damping (Levenberg 1944), which is raised until a step lowers the energy. All
// snakes step side by side, so that the field is called once for all.
#pragma once

#include <span>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/skeleton/field.h"
#include "seamount/model/skeleton.h"

namespace seamount::geom {

struct SnakeOptions {
  double internal = 1.0;   ///< alpha_i, >= 0
  double external = 1.0;   ///< alpha_e, any sign
  double shape = 1.0;      ///< alpha_s, >= 0
  double gradient = 0.0;   ///< alpha_g, any sign
  double bend_m = 0.0;     ///< radius below which bends are dear, >= 0; 0: u / 40
  double spacing_m = 0.0;  ///< distance of vertices, >= 0, taken between u / 10 000 and u / 4; 0: u / 64
  /// g, >= 0; 0: twice Gamma's deviation in a square of side u around each snake, of 80 places. Give it where curves
  /// are fitted again and again: what is measured changes with what lies around.
  double field_unit = 0.0;
  int steps = 200;           ///< at most, of a grown or given snake; growing takes some more, >= 0
  double least_gain = 1e-4;  ///< a snake rests when three steps on end lower its energy by less than this each, >= 0
};

/// Where a curve starts to grow.
struct SnakeSeed {
  Vec2 at;
  double length_m = 0.0;        ///< L, > 0
  Vec2 direction = {1.0, 0.0};  ///< unit; taken where Gamma prefers none
};

/// A curve to be fitted, of two vertices or more.
struct SnakeCurve {
  Skeleton skeleton;
  double length_m = 0.0;  ///< L, >= 0; 0: no target, E_shape is left off and the vertices stay as many as they are
};

struct SnakeFit {
  Skeleton skeleton;  ///< a curve that does not cross itself; without points where a seed or all places one spacing
                      ///< from it are unfit
  double length_m = 0.0;
  std::vector<double> energies;  ///< at the start and after every step, falling strictly
  double mean_field = 0.0;       ///< mean of Gamma at the vertices
  bool rests = false;            ///< false: more steps would lower the energy further
};

/// Grows a curve from each seed to its length: a first edge each way along the contour or the slope of Gamma as
/// alpha_g prefers, then edge by edge at whichever end lowers the energy most, all relaxed again whenever it has grown
/// by a quarter. It stops short of its length where both ends are shut in by unfit places or by itself.
/// With alpha_g > 0 Gamma is higher at its last vertex than at its first.
///
/// Throws InvalidArgument for options out of range. Field: about 400 places a vertex, in 300 calls for a few curves and
/// 800 for 500 of 64 vertices. Time linear in the vertices but for a clearance check (about 1 ns a pair of a curve's
/// vertices). Parallel over snakes.
std::vector<SnakeFit> grow_snakes(std::span<const SnakeSeed> seeds, const SnakeOptions& options,
                                  const FieldAtPlaces& field, const RunContext& run);

/// Fits given curves: vertices are spread evenly (those that are held stay what they are), edges are added or taken
/// away at free ends until the target length is near, all vertices move. A vertex with hold 1 never moves, one with
/// hold h takes 1 - h of every step. A curve that crosses itself comes back as it is; vertices on unfit places may
/// leave them, none goes there.
/// Throws InvalidArgument, also for a curve of fewer than two points or with places that are not finite. Cost as above.
std::vector<SnakeFit> fit_snakes(std::span<const SnakeCurve> curves, const SnakeOptions& options,
                                 const FieldAtPlaces& field, const RunContext& run);

}  // namespace seamount::geom
