// One common field of displacement that makes all contours in its reach rougher together: the "fractalize" that P2
// sec. 6.6 asks for.
//
// Octave by octave, coarse to fine, places are displaced by two-dimensional gradient noise, in as many equal parts as
// keep the derivative of each part's displacement below 1/2. Each part is therefore one to one, so is what they do one
// after the other, and contours keep their order however close they lie: where contours have little room, they move
// side by side.
#pragma once

#include <span>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"

namespace seamount::contour {

struct Roughness {
  double amplitude_m = 0.0;   ///< of the first octave: root of the mean square of its displacement
  double wavelength_m = 0.0;  ///< of the first octave, > 0
  int octaves = 1;
  double gain = 0.5;
};

/// The largest amplitude of a shape by which no octave displaces places by more than a third of its wavelength: beyond
/// that contours are stirred and not roughened.
double most_amplitude_m(const Roughness& shape);

/// The parts that all octaves are done in: what a place costs.
int roughen_parts(const Roughness& shape, double weight_slope);

class Roughen {
 public:
  /// `weight` in [0, 1] scales the displacement from place to place, 0 beyond its frame; its gradient is at most
  /// weight_slope per metre. REQUIRES: it outlives the object.
  Roughen(const Roughness& shape, const ScalarField& weight, double weight_slope, Seed seed);

  /// Displaces places by `strength` in [0, 1] of the whole. Parallel; about 200 ns a place and part.
  void move(double strength, std::span<Vec2> places, const RunContext& run) const;

  double shortest_wavelength_m() const;

 private:
  struct Octave {
    double wavelength_m, amplitude_m;
    int parts;
    Vec2 turn;  ///< of the noise's lattice, a unit vector
    Seed east, north;
  };
  Vec2 moved(double strength, Vec2 place) const;

  const ScalarField& weight_;
  std::vector<Octave> octaves_;
};

}  // namespace seamount::contour
