// One octave works in lattice coordinates (u, v), a rotation and a shift of metres / wavelength. Rows go in chunks of
// kChunk cells: a chunk's first coordinate is split in double into a lattice point and a remainder, and only what is
// added within the chunk is float, so rows are as exact far from the origin as near it.
#include "seamount/geom/scalar/noise.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/scalar/blend.h"
#include "seamount/geom/scalar/noise_places.h"

namespace seamount::geom {
namespace {

constexpr int kChunk = 128;
constexpr uint32_t kPrimeX = 0x9e3779b1U;
constexpr uint32_t kPrimeY = 0x85ebca77U;

/// Brings the lattice noise of gradients of length about 1 (extremes about 0.7) into [-1, 1].
constexpr double kScale = 1.42;

SEAMOUNT_INLINE uint32_t lattice_hash(uint32_t h) {
  h ^= h >> 15;
  return h * 0x2c1b3c6dU;
}

/// Scalar product of (x, y) with a gradient of hashed direction, x given as kSidewise 2^-31 x. The hash's upper bits as
/// a number s in [-1, 1) give (sine, cosine) of a quarter turn each way by a cubic and a parabola,
/// (kSidewise s (kCubic - kLong s^2), kLong (1 - s^2)), of length 0.95 to 1; another bit gives the half plane.
constexpr double kLong = 0.97;
constexpr double kSidewise = 0.495;
constexpr double kCubic = 2.95;

template <class Real>
SEAMOUNT_INLINE Real gradient_dot(uint32_t hash, Real sidewise_x, Real y) {
  const Real s = static_cast<Real>(static_cast<int32_t>(hash));
  const Real square = s * s * Real(kLong * 0x1p-62);
  const Real along_y = Real(kLong) - square;
  const Real along_x = s * (Real(kCubic) - square);
  return along_x * sidewise_x + ((hash & 0x8000U) != 0 ? -along_y : along_y) * y;
}

template <class Real>
SEAMOUNT_INLINE Real fade(Real t) {
  return t * t * t * (t * (t * Real(6) - Real(15)) + Real(10));
}

/// Noise at (x, y) in [0, 1]^2 of the lattice square whose lower corner has hashed coordinates hx, hy.
template <class Real>
SEAMOUNT_INLINE Real square_noise(uint32_t hx, uint32_t hy, Real x, Real y) {
  const Real sidewise_x = x * Real(kSidewise * 0x1p-31);
  const Real sidewise_x1 = sidewise_x - Real(kSidewise * 0x1p-31);
  const Real y1 = y - Real(1);
  const uint32_t hx1 = hx + kPrimeX;
  const uint32_t hy1 = hy + kPrimeY;
  const Real a = gradient_dot(lattice_hash(hx ^ hy), sidewise_x, y);
  const Real b = gradient_dot(lattice_hash(hx1 ^ hy), sidewise_x1, y);
  const Real c = gradient_dot(lattice_hash(hx ^ hy1), sidewise_x, y1);
  const Real d = gradient_dot(lattice_hash(hx1 ^ hy1), sidewise_x1, y1);
  const Real fx = fade(x);
  const Real low = a + fx * (b - a);
  const Real high = c + fx * (d - c);
  return (low + fade(y) * (high - low)) * Real(kScale);
}

uint32_t seed_bits(Seed seed) { return static_cast<uint32_t>(mix_bits(seed.value) >> 32); }

uint32_t wrapped(double whole) { return static_cast<uint32_t>(static_cast<int64_t>(whole)); }

double lattice_noise(uint32_t seed, double u, double v) {
  const double iu = std::floor(u);
  const double iv = std::floor(v);
  return square_noise<double>(wrapped(iu) * kPrimeX + seed, wrapped(iv) * kPrimeY, u - iu, v - iv);
}

/// One octave: u = cosine x - sine y + shift_u, v = sine x + cosine y + shift_v, in wavelengths.
struct Octave {
  double cosine, sine, shift_u, shift_v;
  double weight;     ///< amplitude of this octave times its fading
  double amplitude;  ///< without fading
  uint32_t seed;

  double u(double x, double y) const { return cosine * x - sine * y + shift_u; }
  double v(double x, double y) const { return sine * x + cosine * y + shift_v; }
  double operator()(double x, double y) const { return lattice_noise(seed, u(x, y), v(x, y)); }
};

/// All octaves of a sum that are left after fading.
struct Plan {
  std::vector<Octave> octaves;
  double root_sum = 0.0;  ///< root of the sum of squared amplitudes, faded octaves included
  double sum = 0.0;       ///< sum of amplitudes
};

Plan make_plan(Seed seed, const Fbm& shape) {
  Plan plan;
  double squares = 0.0;
  double amplitude = 1.0;
  double wavelength = shape.wavelength_m;
  const double turn = Rng(seed.derive("turn")).uniform(0.0, 2.0 * std::numbers::pi);
  constexpr double kGoldenAngle = 2.399963229728653;
  for (int k = 0; k < shape.octaves; ++k) {
    Rng rng(seed.derive("octave", static_cast<uint64_t>(k)));
    const double angle = turn + k * kGoldenAngle;
    const double weight = amplitude * octave_weight(wavelength, shape.cell_m);
    const double shift_u = rng.uniform(0.0, 64.0);
    const double shift_v = rng.uniform(0.0, 64.0);
    if (weight != 0.0) {
      plan.octaves.push_back({std::cos(angle) / wavelength, std::sin(angle) / wavelength, shift_u, shift_v, weight,
                              amplitude, seed_bits({rng.bits()})});
    }
    squares += amplitude * amplitude;
    plan.sum += amplitude;
    amplitude *= shape.gain;
    wavelength /= shape.lacunarity;
  }
  plan.root_sum = squares > 0.0 ? std::sqrt(squares) : 1.0;
  return plan;
}

/// An octave as a chunk of a row sees it.
struct ChunkOctave {
  uint32_t hx, hy;  ///< hashed lattice point of the chunk's first cell
  float u, v;       ///< remainder there, in [0, 1)
  float du, dv;     ///< per cell
  float weight;
  float fading;  ///< weight / amplitude (ridged only)
};

ChunkOctave chunk_octave(const Octave& octave, double x, double y, double dx, double scale) {
  const double u = octave.u(x, y);
  const double v = octave.v(x, y);
  const double iu = std::floor(u);
  const double iv = std::floor(v);
  return {wrapped(iu) * kPrimeX + octave.seed,
          wrapped(iv) * kPrimeY,
          static_cast<float>(u - iu),
          static_cast<float>(v - iv),
          static_cast<float>(octave.cosine * dx),
          static_cast<float>(octave.sine * dx),
          static_cast<float>(octave.weight * scale),
          static_cast<float>(octave.weight / octave.amplitude)};
}

SEAMOUNT_INLINE float chunk_noise(const ChunkOctave& octave, int i) {
  const float u = octave.u + static_cast<float>(i) * octave.du;
  const float v = octave.v + static_cast<float>(i) * octave.dv;
  int32_t iu = static_cast<int32_t>(u);
  int32_t iv = static_cast<int32_t>(v);
  iu -= u < static_cast<float>(iu) ? 1 : 0;
  iv -= v < static_cast<float>(iv) ? 1 : 0;
  return square_noise<float>(octave.hx + static_cast<uint32_t>(iu) * kPrimeX,
                             octave.hy + static_cast<uint32_t>(iv) * kPrimeY, u - static_cast<float>(iu),
                             v - static_cast<float>(iv));
}

SEAMOUNT_VECTORISED void add_chunk(const ChunkOctave& given, float* sum) {
  const ChunkOctave octave = given;
  for (int i = 0; i < kChunk; ++i) sum[i] += octave.weight * chunk_noise(octave, i);
}

/// crest: weight from the octaves before, in and out.
SEAMOUNT_VECTORISED void ridge_chunk(const ChunkOctave& given, float* sum, float* crest) {
  const ChunkOctave octave = given;
  for (int i = 0; i < kChunk; ++i) {
    const float noise = chunk_noise(octave, i);
    const float fold = 1.0F - (noise < 0.0F ? -noise : noise);
    const float signal = fold * fold * crest[i];
    sum[i] += octave.weight * signal;
    const float next = 2.0F * signal;
    crest[i] = octave.fading * (next < 1.0F ? next : 1.0F);
  }
}

using ChunkSum = std::array<float, kChunk>;

void fbm_chunk(const Plan& plan, double x, double y, double dx, double scale, ChunkSum& sum) {
  sum.fill(0.0F);
  for (const Octave& octave : plan.octaves) add_chunk(chunk_octave(octave, x, y, dx, scale), sum.data());
}

void ridged_chunk(const Plan& plan, double x, double y, double dx, double scale, ChunkSum& sum) {
  ChunkSum crest;
  sum.fill(0.0F);
  crest.fill(1.0F);
  for (const Octave& octave : plan.octaves) {
    ridge_chunk(chunk_octave(octave, x, y, dx, scale), sum.data(), crest.data());
  }
}

/// Places of a row: cell i at x0 + i dx. Chunks begin at its cell 0, of which what is wanted may be the part from
/// `first` on.
struct RowPlaces {
  double x0, dx, y;
  int first = 0;
};

RowPlaces places_of(const GridFrame& frame, int y) {
  const int first = frame.first_column();
  return {frame.x(-first), frame.cell_m, frame.y(y), first};
}

/// Calls chunk(...) along a row and hands each value to store(destination, value).
template <class Chunk, class Store>
void fill_row(const Plan& plan, const RowPlaces& row, std::span<float> out, double scale, Chunk&& chunk,
              Store&& store) {
  ChunkSum sum;
  const auto first = static_cast<size_t>(row.first), last = first + out.size();
  for (size_t begin = first / kChunk * kChunk; begin < last; begin += kChunk) {
    chunk(plan, row.x0 + static_cast<double>(begin) * row.dx, row.y, row.dx, scale, sum);
    const size_t end = std::min<size_t>(begin + kChunk, last);
    for (size_t i = std::max(begin, first); i < end; ++i) store(out[i - first], sum[i - begin]);
  }
}

constexpr auto kSet = [](float& to, float value) { to = value; };
constexpr auto kAdd = [](float& to, float value) { to += value; };

template <class Chunk>
ScalarField noise_grid(const GridFrame& frame, const Plan& plan, double scale, const RunContext& run, Chunk&& chunk) {
  ScalarField field(frame);
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      fill_row(plan, places_of(frame, y), field.row(y), scale, chunk, kSet);
    }
  });
  return field;
}

double noise1(uint32_t seed, double x) {
  const double whole = std::floor(x);
  const double t = x - whole;
  const uint32_t i = wrapped(whole) * kPrimeX + seed;
  const auto gradient = [](uint32_t h) { return static_cast<double>(static_cast<int32_t>(lattice_hash(h))) * 0x1p-31; };
  const double a = gradient(i) * t;
  const double b = gradient(i + kPrimeX) * (t - 1.0);
  return 2.0 * (a + fade(t) * (b - a));
}

}  // namespace

double octave_weight(double wavelength_m, double cell_m) {
  if (!(cell_m > 0.0)) return 1.0;
  const double q = cell_m / wavelength_m;
  return std::exp(-1.64 * q * q) * (1.0 - smoothstep(2.0 * q - 1.0));
}

double perlin(Seed seed, double x, double y) { return lattice_noise(seed_bits(seed), x, y); }

double fbm(Seed seed, const Fbm& shape, double x, double y) {
  const Plan plan = make_plan(seed, shape);
  double sum = 0.0;
  for (const Octave& octave : plan.octaves) sum += octave.weight * octave(x, y);
  return sum / plan.root_sum;
}

void fbm_places(Seed seed, const Fbm& shape, std::span<const Vec2> places, std::span<double> out) {
  const Plan plan = make_plan(seed, shape);
  for (size_t i = 0; i < places.size(); ++i) {
    double sum = 0.0;
    for (const Octave& octave : plan.octaves) sum += octave.weight * octave(places[i].x, places[i].y);
    out[i] = sum / plan.root_sum;
  }
}

double ridged(Seed seed, const Fbm& shape, double x, double y) {
  const Plan plan = make_plan(seed, shape);
  double sum = 0.0;
  double crest = 1.0;
  for (const Octave& octave : plan.octaves) {
    const double fold = 1.0 - std::abs(octave(x, y));
    const double signal = fold * fold * crest;
    sum += octave.weight * signal;
    crest = octave.weight / octave.amplitude * std::min(1.0, 2.0 * signal);
  }
  return sum / plan.sum;
}

void fbm_row(Seed seed, const Fbm& shape, double x0, double dx, double y, std::span<float> out) {
  const Plan plan = make_plan(seed, shape);
  fill_row(plan, {x0, dx, y}, out, 1.0 / plan.root_sum, fbm_chunk, kSet);
}

void fbm_row(Seed seed, const Fbm& shape, const GridFrame& frame, int y, std::span<float> out) {
  const Plan plan = make_plan(seed, shape);
  fill_row(plan, places_of(frame, y), out, 1.0 / plan.root_sum, fbm_chunk, kSet);
}

void ridged_row(Seed seed, const Fbm& shape, const GridFrame& frame, int y, std::span<float> out) {
  const Plan plan = make_plan(seed, shape);
  fill_row(plan, places_of(frame, y), out, 1.0 / plan.sum, ridged_chunk, kSet);
}

void fbm_add_row(Seed seed, const Fbm& shape, double x0, double dx, double y, std::span<float> out, float amplitude) {
  const Plan plan = make_plan(seed, shape);
  fill_row(plan, {x0, dx, y}, out, static_cast<double>(amplitude) / plan.root_sum, fbm_chunk, kAdd);
}

void ridged_row(Seed seed, const Fbm& shape, double x0, double dx, double y, std::span<float> out) {
  const Plan plan = make_plan(seed, shape);
  fill_row(plan, {x0, dx, y}, out, 1.0 / plan.sum, ridged_chunk, kSet);
}

ScalarField fbm_grid(const GridFrame& frame, Seed seed, const Fbm& shape, const RunContext& run) {
  const Plan plan = make_plan(seed, shape);
  return noise_grid(frame, plan, 1.0 / plan.root_sum, run, fbm_chunk);
}

ScalarField ridged_grid(const GridFrame& frame, Seed seed, const Fbm& shape, const RunContext& run) {
  const Plan plan = make_plan(seed, shape);
  return noise_grid(frame, plan, 1.0 / plan.sum, run, ridged_chunk);
}

double fbm1(Seed seed, double x, int octaves) {
  double sum = 0.0;
  double squares = 0.0;
  double amplitude = 1.0;
  double frequency = 1.0;
  for (int k = 0; k < octaves; ++k) {
    Rng rng(seed.derive("fbm1", static_cast<uint64_t>(k)));
    const double shift = rng.uniform(0.0, 64.0);
    sum += amplitude * noise1(seed_bits({rng.bits()}), x * frequency + shift);
    squares += amplitude * amplitude;
    amplitude *= 0.5;
    frequency *= 2.0;
  }
  return squares > 0.0 ? sum / std::sqrt(squares) : 0.0;
}

double fbm_circle(Seed seed, double angle, double frequency, int octaves) {
  const double radius = frequency / (2.0 * std::numbers::pi);
  return fbm(seed, {.wavelength_m = 1.0, .octaves = octaves}, radius * std::cos(angle), radius * std::sin(angle));
}

}  // namespace seamount::geom
