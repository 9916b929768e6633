// The kernels of P4 and their sums over an aggregate.
//
// Source: P4 sec. 3.2-3.3, eq. 1 and 2. Distances are divided by the kernel radius R. Eq. 2 as printed is no
// log-normal; it is read as exp(-|ln(k1 (1 - d / R))|^k2): 0 at the centre, 1 at d / R = 1 - 1 / k1, 0 at the rim. The
// magnitude keeps odd and fractional exponents bounded. w_d is 0 where the colony's neighbour in the direction of the
// place is a colony itself, so that only the outer edge of an aggregate is lifted.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/geom/scalar/curve.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"
#include "seamount/ops/reef/aggregate.h"

namespace seamount::reef {

/// One settled particle in the plane.
struct Colony {
  Vec2 centre;             ///< metres
  double radius_m = 1.0;   ///< of its kernels
  double k1 = 5.0;         ///< of its edge kernel
  uint8_t neighbours = 0;  ///< bit i: the lattice cell in direction i holds a colony too
};

/// Eighth of the compass in which a vector lies: 0 north, 1 north-east, ... clockwise. Sectors are centred on their
/// directions; {0, 0} is in the east.
int direction_of(Vec2 v);

/// exp(-t^k), t = d / R >= 0.
double normal_kernel(double t, double k);

/// exp(-|ln(k1 (1 - t))|^k2), 0 for t >= 1.
double edge_kernel(double t, double k1, double k2);

/// Where a normal kernel has fallen to 1e-6: its reach in radii.
double normal_reach(double k);

/// How colonies depart from their lattice cells: shares of a cell and of the radius.
struct Scatter {
  double radius_m = 100.0;
  double centre = 0.0;
  double radius = 0.0;
  double k1 = 5.0;
  double k1_jitter = 0.0;
};

/// The colonies of an aggregate in a lattice's coordinates. Linear time.
std::vector<Colony> place_colonies(const std::vector<LatticeCell>& cells, const GridFrame& lattice,
                                   const Scatter& scatter, Seed seed);

/// Sums over colonies along rows: sum of exp(-t^k) of eq. 1 and sum of w_d exp(-|ln(k1 (1 - t))|^k2) of eq. 2, from
/// tables of 4096 samples (error below 1e-4 a kernel for exponents up to 12). Colonies are added in a fixed order.
class KernelSums {
 public:
  KernelSums(std::vector<Colony> colonies, double k, double k2);

  /// normal[i], edge[i] = the sums at (x0 + i dx, y). Cost: cells of the row within reach of colonies.
  void row(double x0, double dx, double y, std::span<float> normal, std::span<float> edge) const;

 private:
  std::vector<Colony> colonies_;  ///< from north to south
  geom::CurveTable normal_;       ///< over t^2
  geom::CurveTable edge_;         ///< over k1 (1 - t)
  double reach_;                  ///< of a normal kernel, in radii
  double widest_m_ = 0.0;         ///< reach of the largest colony
};

/// f as a table of `samples` over [first, last].
template <class Function>
geom::CurveTable make_table(Function&& f, double first, double last, int samples) {
  Curve curve;
  for (int i = 0; i < samples; ++i) {
    const double x = first + (last - first) * i / (samples - 1);
    curve.knots.push_back({x, f(x)});
  }
  return geom::CurveTable(geom::CurveFunction(curve, geom::CurveKind::linear), first, last, samples);
}

}  // namespace seamount::reef
