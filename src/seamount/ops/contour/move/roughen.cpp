#include "seamount/ops/contour/move/roughen.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/geom/scalar/noise.h"

namespace seamount::contour {
namespace {

constexpr double kDeviation = 0.35;     ///< of geom::perlin
constexpr double kSteepestNoise = 4.5;  ///< norm of the derivative of two of them, per wavelength: above all measured
constexpr double kSteepestPart = 0.5;
constexpr Vec2 kTurn = {0.8, 0.6};  ///< octaves are turned against each other by 37 degrees: no lattice shows
constexpr int64_t kBlock = 512;

/// Bilinear between cell centres; the outermost cells are 0 in every weight that is made here.
double weight_at(const ScalarField& weight, Vec2 p) {
  const GridFrame& frame = weight.frame();
  const double column = frame.column(p.x);
  const double row = frame.row(p.y);
  if (!(column > 0.0 && row > 0.0 && column < frame.width - 1 && row < frame.height - 1)) return 0.0;
  const int x = static_cast<int>(column);
  const int y = static_cast<int>(row);
  const double s = column - x;
  const double t = row - y;
  const double upper = (1.0 - s) * static_cast<double>(weight(x, y)) + s * static_cast<double>(weight(x + 1, y));
  const double lower =
      (1.0 - s) * static_cast<double>(weight(x, y + 1)) + s * static_cast<double>(weight(x + 1, y + 1));
  return (1.0 - t) * upper + t * lower;
}

/// What noise of amplitude 1 is multiplied by for a root of the mean square displacement.
double displacement_of(double amplitude_m) { return amplitude_m / (kDeviation * std::sqrt(2.0)); }

/// Equal parts of an octave that are one to one each.
int parts_of(double displacement_m, double wavelength_m, double weight_slope) {
  const double steepest = displacement_m * (kSteepestNoise / wavelength_m + std::sqrt(2.0) * weight_slope);
  return std::max(1, static_cast<int>(std::ceil(steepest / kSteepestPart)));
}

}  // namespace

double most_amplitude_m(const Roughness& shape) {
  constexpr double kOfWavelength = 1.0 / 3.0;
  const double last = std::max(1.0, std::pow(2.0 * shape.gain, shape.octaves - 1));
  return kOfWavelength * shape.wavelength_m / last;
}

int roughen_parts(const Roughness& shape, double weight_slope) {
  int parts = 0;
  double wavelength = shape.wavelength_m;
  double amplitude = displacement_of(shape.amplitude_m);
  for (int i = 0; i < shape.octaves; ++i) {
    parts += parts_of(amplitude, wavelength, weight_slope);
    wavelength *= 0.5;
    amplitude *= shape.gain;
  }
  return parts;
}

Roughen::Roughen(const Roughness& shape, const ScalarField& weight, double weight_slope, Seed seed) : weight_(weight) {
  Vec2 turn = kTurn;
  double wavelength = shape.wavelength_m;
  double amplitude = displacement_of(shape.amplitude_m);
  for (int i = 0; i < shape.octaves; ++i) {
    const int parts = parts_of(amplitude, wavelength, weight_slope);
    octaves_.push_back({wavelength, amplitude, parts, turn, seed.derive("east", static_cast<uint64_t>(i)),
                        seed.derive("north", static_cast<uint64_t>(i))});
    turn = {turn.x * kTurn.x - turn.y * kTurn.y, turn.x * kTurn.y + turn.y * kTurn.x};
    wavelength *= 0.5;
    amplitude *= shape.gain;
  }
}

Vec2 Roughen::moved(double strength, Vec2 place) const {
  for (const Octave& octave : octaves_) {
    for (int part = 0; part < octave.parts; ++part) {
      const double weight = weight_at(weight_, place);
      if (weight == 0.0) return place;
      const double x = (octave.turn.x * place.x - octave.turn.y * place.y) / octave.wavelength_m;
      const double y = (octave.turn.y * place.x + octave.turn.x * place.y) / octave.wavelength_m;
      const double by = strength * weight * octave.amplitude_m / octave.parts;
      place = place + by * Vec2{geom::perlin(octave.east, x, y), geom::perlin(octave.north, x + 0.5, y + 0.5)};
    }
  }
  return place;
}

void Roughen::move(double strength, std::span<Vec2> places, const RunContext& run) const {
  parallel_blocks(run, static_cast<int64_t>(places.size()), kBlock, [&](int64_t begin, int64_t end) {
    for (int64_t i = begin; i < end; ++i) {
      Vec2& place = places[static_cast<size_t>(i)];
      place = moved(strength, place);
    }
  });
}

double Roughen::shortest_wavelength_m() const { return octaves_.back().wavelength_m; }

}  // namespace seamount::contour
