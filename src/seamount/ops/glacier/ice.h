// Ice that gathers, flows and melts over a bed: the shallow ice approximation with sliding.
//
//   dH/dt + div q = M(s),   s = b + H,   q = -(G_d H^5 + G_s H^3) |grad s|^2 grad s
//
// (Mahaffy 1976; G_d, G_s from the deformation and sliding of Oerlemans 1984, f_d = 1.9e-24 Pa^-3 s^-1 and f_s
// = 5.7e-20 Pa^-3 m^2 s^-1) with M(s) = min(gradient (s - ELA), most) metres of ice a year. Implicit steps by nonlinear
// Gauss-Seidel: each cell in turn finds the height at which what comes, falls, melts and goes is even, with the flux of
// the higher cell of each pair, so that what leaves a cell grows with its own height alone and nothing flows from bare
// rock (cf. Jarosch, Schoof and Anslow 2013). That is stable for steps of any length. Ice on the border has left the
// map.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::glacier {

/// Mass balance.
struct Climate {
  double ela_m = 1800;
  double gradient_1_yr = 0.007;
  double most_m_yr = 1.5;

  /// Metres of ice a year at a height of the surface.
  float balance(float height) const;
};

/// What a year adds to ice and takes from it, in m3. Margins melt what comes to them.
struct Budget {
  double gained = 0, lost = 0;
};

/// Share of what ice of the constants above slides.
constexpr double kSliding = 1.0;

/// Ice on one grid.
class Ice {
 public:
  /// REQUIRES: surface >= bed, which outlives this; both of the same frame.
  Ice(const HeightField& bed, HeightField& surface, const Climate& climate, double sliding = kSliding);

  /// One step of `years`; so many sweeps, each over the red and then the black cells. Parallel, about 80 ns per cell of
  /// ice and sweep.
  void step(double years, int sweeps, const RunContext& run);

  /// Metres per year that ice slides over each cell's bed.
  void slide(ScalarField& speed, const RunContext& run) const;

  /// A year's budget as the last step left it; even where the ice is steady.
  Budget budget() const;

 private:
  struct Side;
  float flow_of(float thick) const;
  Side side(int x, int y, int dx, int dy) const;
  float settled(int x, int y, float dt) const;

  const HeightField& bed_;
  HeightField& surface_;
  Climate climate_;
  float deformation_, sliding_;
  ScalarField before_;
};

}  // namespace seamount::glacier
