// How one octave works. Around a place p lie nine pivots x of a jittered, turned lattice. With n the unit vector across
// the slope at p, each pivot contributes the wave exp(2 pi i n.(p - x) / wavelength), weighted by a bump; the sum's
// phase is constant down the slope and turns once per wavelength across it, and where neighbouring pivots disagree its
// amplitude vanishes and two valleys become one. Crests are where the phase is 0. Every pivot has a depth of its own,
// and valley floors are spared most of the finer gullies, as if filled.
//
// An octave is evaluated on a grid of 6 to 12 cells per wavelength (a level of a pyramid of halved grids), and what has
// been added so far is interpolated to the next level, so long waves cost next to nothing.
#include "seamount/geom/water/gullies.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/base/text.h"
#include "seamount/geom/grid/pyramid.h"
#include "seamount/geom/scalar/blend.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/model/same_size.h"

namespace seamount::geom {
namespace {

constexpr int kChunk = 64;
constexpr uint32_t kPrimeX = 0x9e3779b1U;
constexpr uint32_t kPrimeY = 0x85ebca77U;
constexpr float kPitch = 1.2F;       ///< lattice step over wavelength
constexpr float kReach = 1.08F;      ///< radius of a bump in lattice steps: no pivot beyond the nine reaches p
constexpr float kJitter = 0.42F;     ///< largest shift of a pivot from the middle of its square
constexpr float kVariety = 0.55F;    ///< how much pivots differ in depth
constexpr float kMeanDepth = 0.52F;  ///< mean of valley_share, so that an octave moves no height on average
constexpr float kFirstCrest = 0.3F;  ///< the same for the first octave, whose valleys cut deeper than crests rise
constexpr float kDepth = 0.36F;      ///< depth of a valley over slope times wavelength at strength 1
constexpr float kCalm = 0.65F;       ///< share of finer gullies that valley floors are spared
constexpr double kSamples = 6.0;     ///< cells per wavelength on the level that evaluates it, at least

SEAMOUNT_INLINE uint32_t pivot_hash(uint32_t h) {
  h ^= h >> 15;
  return h * 0x2c1b3c6dU;
}

struct Turn {
  float cosine, sine;
};

/// Cosine and sine of 2 pi t for t within a thousand turns, both continuous, error below 1e-4.
SEAMOUNT_INLINE Turn turn(float t) {
  constexpr float kRounder = 12582912.0F;  // adding 1.5 2^23 rounds to whole numbers
  const float r = t - ((t + kRounder) - kRounder);
  const uint32_t bits = std::bit_cast<uint32_t>(r);
  const float q = std::bit_cast<float>(bits & 0x7fffffffU) - 0.25F;
  const float e = q * q;
  const float odd = q * (-6.2831853F + e * (41.3371F + e * -76.9F));
  const float even = 1.0F + e * (-19.738F + e * (64.737F + e * -78.5F));
  return {odd, std::bit_cast<float>(std::bit_cast<uint32_t>(even) ^ (bits & 0x80000000U))};
}

/// An octave as a chunk of a row sees it. u, v are lattice coordinates: u = cosine x - sine y.
struct Chunk {
  uint32_t hx, hy;     ///< hashed lattice square of the chunk's first cell
  float u, v, du, dv;  ///< remainder of the first cell, and steps per cell
  float cosine, sine;  ///< of the lattice's turn
  float to_slope;      ///< 1 / (2 cell)
  float depth;         ///< of a valley at slope 1
  float sharpness;
  float crest;  ///< share of the depth that crests stand above the surface before
};

/// 0 on crests, 1 in valleys, for the cosine of the phase.
SEAMOUNT_INLINE float valley_share(float cosine, float sharpness) {
  const float half = 0.5F - 0.5F * cosine;
  const float root = std::sqrt(half > 0.0F ? half : 0.0F);
  const float sharp = root * (0.7F + 0.3F * half * half);
  return half + sharpness * (sharp - half);
}

/// A wave summed over pivots.
struct Wave {
  float cosine = 0.0F;
  float sine = 0.0F;
  float weights = 1e-3F;
  float depths = 1e-3F;  ///< weights times each pivot's own depth
};

/// Adds the pivot of the square (column, row) away from the one at hashed (hx, hy), in which p lies at (u, v).
SEAMOUNT_INLINE void add_pivot(Wave& wave, uint32_t hx, uint32_t hy, float u, float v, float across_u, float across_v,
                               int column, int row) {
  const uint32_t hash =
      pivot_hash((hx + static_cast<uint32_t>(column) * kPrimeX) ^ (hy + static_cast<uint32_t>(row) * kPrimeY));
  const float jitter_u = static_cast<float>(static_cast<int32_t>(hash)) * (kJitter * 0x1p-31F);
  const float jitter_v = static_cast<float>(static_cast<int32_t>(hash << 12)) * (kJitter * 0x1p-31F);
  const float off_u = u - (static_cast<float>(column) + 0.5F + jitter_u);
  const float off_v = v - (static_cast<float>(row) + 0.5F + jitter_v);
  const float share = 1.0F - (off_u * off_u + off_v * off_v) * (1.0F / (kReach * kReach));
  const float near = 0.5F * (share + std::bit_cast<float>(std::bit_cast<uint32_t>(share) & 0x7fffffffU));
  const float weight = near * near * near;
  const float turns = across_u * off_u + across_v * off_v;
  const Turn angle = turn(turns);
  wave.cosine += weight * angle.cosine;
  wave.sine += weight * angle.sine;
  wave.weights += weight;
  wave.depths += weight * (1.0F + kVariety * 0x1p-31F * static_cast<float>(static_cast<int32_t>(hash << 6)));
}

struct Carved {
  float height;
  float exposed;  ///< 1 on crests, less on valley floors
};

/// What an octave adds i cells into a chunk where the slope is (gu, gv), in lattice axes.
SEAMOUNT_INLINE Carved carve(const Chunk& chunk, int i, float gu, float gv) {
  const float u = chunk.u + static_cast<float>(i) * chunk.du;
  const float v = chunk.v + static_cast<float>(i) * chunk.dv;
  int32_t iu = static_cast<int32_t>(u);
  int32_t iv = static_cast<int32_t>(v);
  iu -= u < static_cast<float>(iu) ? 1 : 0;
  iv -= v < static_cast<float>(iv) ? 1 : 0;
  const float fu = u - static_cast<float>(iu);
  const float fv = v - static_cast<float>(iv);
  const uint32_t hx = chunk.hx + static_cast<uint32_t>(iu) * kPrimeX;
  const uint32_t hy = chunk.hy + static_cast<uint32_t>(iv) * kPrimeY;
  const float slope2 = gu * gu + gv * gv;
  const float slope = std::sqrt(slope2 + 1e-12F);
  const float inverse = kPitch / slope;
  const float across_u = -gv * inverse;
  const float across_v = gu * inverse;
  Wave wave;
  add_pivot(wave, hx, hy, fu, fv, across_u, across_v, -1, -1);
  add_pivot(wave, hx, hy, fu, fv, across_u, across_v, 0, -1);
  add_pivot(wave, hx, hy, fu, fv, across_u, across_v, 1, -1);
  add_pivot(wave, hx, hy, fu, fv, across_u, across_v, -1, 0);
  add_pivot(wave, hx, hy, fu, fv, across_u, across_v, 0, 0);
  add_pivot(wave, hx, hy, fu, fv, across_u, across_v, 1, 0);
  add_pivot(wave, hx, hy, fu, fv, across_u, across_v, -1, 1);
  add_pivot(wave, hx, hy, fu, fv, across_u, across_v, 0, 1);
  add_pivot(wave, hx, hy, fu, fv, across_u, across_v, 1, 1);
  const float amplitude = std::sqrt(wave.cosine * wave.cosine + wave.sine * wave.sine) + 1e-6F;
  const float valley = valley_share(wave.cosine / amplitude, chunk.sharpness);
  const float coherence = amplitude / wave.weights * 1.5F;
  const float full = coherence < 1.0F ? coherence : 1.0F;
  const float steep = slope / std::sqrt(1.0F + slope2);
  const float floor = valley * valley * valley * full;
  const float depth = chunk.depth * wave.depths / wave.weights;
  return {depth * steep * full * (chunk.crest - valley), 1.0F - kCalm * floor * floor};
}

/// added[i] += strength[i] times what the octave adds, slopes from the rows above, at and below.
SEAMOUNT_VECTORISED void carve_chunk(const Chunk& given, const float* above, const float* at, const float* below,
                                     const float* strength, float* exposed, float* added) {
  const Chunk chunk = given;
  for (int i = 0; i < kChunk; ++i) {
    const float east = (at[i + 1] - at[i - 1]) * chunk.to_slope;
    const float north = (above[i] - below[i]) * chunk.to_slope;
    const float gu = chunk.cosine * east - chunk.sine * north;
    const float gv = chunk.sine * east + chunk.cosine * north;
    const Carved carved = carve(chunk, i, gu, gv);
    added[i] += strength[i] * exposed[i] * carved.height;
    exposed[i] *= carved.exposed;
  }
}

struct Octave {
  double wavelength, cosine, sine, shift_u, shift_v;
  float depth;
  float crest;
  uint32_t seed;
};

/// One row of an octave, in chunks from padded copies of the row's neighbourhood.
class RowCarver {
 public:
  /// `lead`: cells between the beginning of a chunk and the row's first cell. Chunks begin at the whole raster's edge.
  RowCarver(int width, int lead) : width_(width), lead_(lead) {
    const size_t padded = static_cast<size_t>((lead + width + kChunk - 1) / kChunk * kChunk + 2);
    for (std::vector<float>* row : {&above_, &at_, &below_, &strength_, &exposed_, &added_}) row->assign(padded, 0.0F);
  }

  void carve(const Octave& octave, float sharpness, const Grid<float>& surface, const Grid<float>& strength, int y,
             Grid<float>& exposed, Grid<float>& added) {
    load(surface, y - 1, above_);
    load(surface, y, at_);
    load(surface, y + 1, below_);
    load(strength, y, strength_);
    load(exposed, y, exposed_);
    load(added, y, added_);
    const GridFrame& frame = surface.frame();
    const double pitch = octave.wavelength * static_cast<double>(kPitch);
    for (int x = 0; x < lead_ + width_; x += kChunk) {
      if (idle(x)) continue;
      const double east = frame.x(x - lead_) / pitch;
      const double north = frame.y(y) / pitch;
      const double u = octave.cosine * east - octave.sine * north + octave.shift_u;
      const double v = octave.sine * east + octave.cosine * north + octave.shift_v;
      const double iu = std::floor(u);
      const double iv = std::floor(v);
      const Chunk chunk = {static_cast<uint32_t>(static_cast<int64_t>(iu)) * kPrimeX + octave.seed,
                           static_cast<uint32_t>(static_cast<int64_t>(iv)) * kPrimeY,
                           static_cast<float>(u - iu),
                           static_cast<float>(v - iv),
                           static_cast<float>(octave.cosine * frame.cell_m / pitch),
                           static_cast<float>(octave.sine * frame.cell_m / pitch),
                           static_cast<float>(octave.cosine),
                           static_cast<float>(octave.sine),
                           static_cast<float>(0.5 / frame.cell_m),
                           octave.depth,
                           sharpness,
                           octave.crest};
      const size_t i = static_cast<size_t>(x) + 1;
      carve_chunk(chunk, &above_[i], &at_[i], &below_[i], &strength_[i], &exposed_[i], &added_[i]);
    }
    std::copy_n(added_.begin() + lead_ + 1, width_, added.row(y).begin());
    std::copy_n(exposed_.begin() + lead_ + 1, width_, exposed.row(y).begin());
  }

 private:
  /// Is the strength of the whole chunk 0?
  bool idle(int x) const {
    const auto first = strength_.begin() + x + 1;
    return std::all_of(first, first + std::min(kChunk, lead_ + width_ - x), [](float s) { return s == 0.0F; });
  }

  /// Row y with one cell more on both sides, extrapolated linearly beyond the grid's edge.
  void load(const Grid<float>& grid, int y, std::vector<float>& padded) const {
    const int edge = std::clamp(y, 0, grid.height() - 1);
    const std::span<const float> cells = grid.row(edge);
    float* row = padded.data() + lead_;
    std::copy(cells.begin(), cells.end(), row + 1);
    if (edge != y && grid.height() > 1) {
      const std::span<const float> inner = grid.row(2 * edge - y);
      for (size_t x = 0; x < inner.size(); ++x) row[x + 1] = 2.0F * cells[x] - inner[x];
    }
    const size_t last = cells.size();
    row[0] = last > 1 ? 2.0F * row[1] - row[2] : row[1];
    row[last + 1] = last > 1 ? 2.0F * row[last] - row[last - 1] : row[last];
  }

  int width_, lead_;
  std::vector<float> above_, at_, below_, strength_, exposed_, added_;
};

void carve_octave(const Octave& octave, float sharpness, const Grid<float>& surface, const Grid<float>& strength,
                  Grid<float>& exposed, Grid<float>& added, const RunContext& run) {
  parallel_rows(run, added.width(), added.height(), [&](int begin, int end) {
    RowCarver carver(added.width(), added.frame().first_column() % kChunk);
    for (int y = begin; y < end; ++y) carver.carve(octave, sharpness, surface, strength, y, exposed, added);
  });
}

/// The two terms that stand for cell i in [-2, size + 2): itself, or twice the edge less its mirror image, so that the
/// blur of a plane is the plane up to its edge.
struct Source {
  int first, second;
  float first_weight, second_weight;
};

Source source_of(int i, int size) {
  const int edge = std::clamp(i, 0, size - 1);
  const int mirror = std::clamp(2 * edge - i, 0, size - 1);
  if (i == edge) return {i, i, 1.0F, 0.0F};
  return {edge, mirror, 2.0F, -1.0F};
}

SEAMOUNT_VECTORISED void add_weighted_sum(const float* a, const float* b, float share, float weight, float* sum,
                                          int count) {
  for (int x = 0; x < count; ++x) sum[x] += weight * (a[x] + share * b[x]);
}

SEAMOUNT_VECTORISED void binomial_row(const float* m, float* out, int count) {
  for (int x = 0; x < count; ++x) {
    out[x] = 0.0625F * (m[x - 2] + m[x + 2]) + 0.25F * (m[x - 1] + m[x + 1]) + 0.375F * m[x];
  }
}

/// surface = base + share * added, blurred by the binomial filter 1 4 6 4 1 along both axes.
void blur_surface(const Grid<float>& base, const Grid<float>& added, float share, Grid<float>& surface,
                  const RunContext& run) {
  if (!(surface.frame() == base.frame())) surface = Grid<float>(base.frame());
  const int width = base.width();
  parallel_rows(run, width, base.height(), [&](int begin, int end) {
    constexpr float kBinomial[5] = {0.0625F, 0.25F, 0.375F, 0.25F, 0.0625F};
    std::vector<float> mixed(static_cast<size_t>(width) + 4);
    float* m = mixed.data() + 2;
    for (int y = begin; y < end; ++y) {
      std::fill(mixed.begin(), mixed.end(), 0.0F);
      for (int k = 0; k < 5; ++k) {
        const Source from = source_of(y + k - 2, base.height());
        const auto add = [&](int row, float weight) {
          if (weight != 0.0F) add_weighted_sum(base.row(row).data(), added.row(row).data(), share, weight, m, width);
        };
        add(from.first, kBinomial[k] * from.first_weight);
        add(from.second, kBinomial[k] * from.second_weight);
      }
      for (const int x : {-2, -1, width, width + 1}) {
        const Source from = source_of(x, width);
        m[x] = from.first_weight * m[from.first] + from.second_weight * m[from.second];
      }
      binomial_row(m, surface.row(y).data(), width);
    }
  });
}

void check(const HeightField& height, const Gullies& gullies, const ScalarField& strength) {
  check_same_size("strength", strength.frame(), height.frame());
  if (!(gullies.wavelength_m > 0.0)) {
    throw InvalidArgument("wavelength_m", format_number(gullies.wavelength_m) + " is not above 0");
  }
  if (!(gullies.gain > 0.0 && gullies.gain < 1.0)) {
    throw InvalidArgument("gain", format_number(gullies.gain) + " is outside (0, 1)");
  }
  if (gullies.octaves < 1 || gullies.octaves > 12) {
    throw InvalidArgument("octaves", std::to_string(gullies.octaves) + " is outside [1, 12]");
  }
}

Octave make_octave(Seed seed, const Gullies& gullies, int k, double cell_m) {
  constexpr double kGoldenAngle = 2.399963229728653;
  Rng rng(seed.derive("gullies", static_cast<uint64_t>(k)));
  const double angle = Rng(seed.derive("turn")).uniform(0.0, 2.0 * std::numbers::pi) + k * kGoldenAngle;
  const double wavelength = gullies.wavelength_m * std::pow(0.5, k);
  const double fading = octave_weight(wavelength, cell_m) * smoothstep(0.5 * wavelength / cell_m - 1.0);
  const double depth =
      static_cast<double>(kDepth) * gullies.wavelength_m * std::pow(gullies.gain, k) * gullies.strength * fading;
  const double shift_u = rng.uniform(0.0, 64.0);
  const double shift_v = rng.uniform(0.0, 64.0);
  return {wavelength,
          std::cos(angle),
          std::sin(angle),
          shift_u,
          shift_v,
          static_cast<float>(depth),
          k == 0 ? kFirstCrest : kMeanDepth,
          static_cast<uint32_t>(rng.bits() >> 32)};
}

/// Halvings of a grid that leave kSamples cells per wavelength.
size_t level_of(double wavelength, double cell_m, size_t levels) {
  size_t level = 0;
  while (level + 1 < levels && cell_m * std::pow(2.0, static_cast<double>(level) + 1.0) * kSamples <= wavelength)
    ++level;
  return level;
}

}  // namespace

Reach gullies_reach(double wavelength_m, double cell_m) {
  constexpr size_t kLevels = 20;  // a larger one looks further than any raster
  const int step = 1 << level_of(wavelength_m, cell_m, kLevels);
  // An octave looks 3 cells of its level far, interpolating to the next level 2; half of that a level finer, and so on;
  // three octaves share the finest. What does not begin with a whole coarse cell takes one more.
  return Reach::neighbourhood(12 * step + 16, step);
}

void add_gullies(HeightField& height, Seed seed, const Gullies& gullies, const ScalarField& strength_per_cell,
                 const RunContext& run) {
  check(height, gullies, strength_per_cell);
  if (height.empty() || gullies.strength == 0.0) return;
  RunContext quiet = run;
  quiet.progress = nullptr;
  Pyramid bases(height);
  Pyramid strengths(strength_per_cell);
  const size_t wanted = level_of(gullies.wavelength_m, height.cell_m(), 24);
  while (bases.top() < wanted && std::min(bases[bases.top()].width(), bases[bases.top()].height()) > 4) {
    bases.grow(quiet);
    strengths.grow(quiet);
  }
  size_t level = bases.top();
  Grid<float> added(bases[level].frame(), 0.0F);
  Grid<float> exposed(bases[level].frame(), 1.0F);
  Grid<float> surface;
  for (int k = 0; k < gullies.octaves; ++k) {
    const Octave octave = make_octave(seed, gullies, k, height.cell_m());
    if (octave.depth == 0.0F) break;
    const size_t target = level_of(octave.wavelength, height.cell_m(), bases.top() + 1);
    for (; level > target; --level) {
      added = doubled(added, bases[level - 1].frame(), quiet);
      exposed = doubled(exposed, bases[level - 1].frame(), quiet);
    }
    blur_surface(bases[level], added, static_cast<float>(gullies.branching), surface, quiet);
    carve_octave(octave, static_cast<float>(gullies.sharpness), surface, strengths[level], exposed, added, quiet);
    run.report((k + 1.0) / (gullies.octaves + 1.0));
  }
  for (; level > 0; --level) added = doubled(added, bases[level - 1].frame(), quiet);
  parallel_rows(quiet, height.width(), height.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const std::span<const float> add = added.row(y);
      const std::span<float> out = height.row(y);
      for (size_t x = 0; x < out.size(); ++x) out[x] += add[x];
    }
  });
}

}  // namespace seamount::geom
