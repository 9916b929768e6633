#include "seamount/train/erode_pairs.h"

#include <cmath>
#include <optional>
#include <utility>

#include "seamount/ops/erosion/run.h"
#include "seamount/ops/learned/erode_planes.h"
#include "seamount/ops/terrain/noise.h"
#include "seamount/train/sketch_crop.h"

namespace seamount::train {
namespace {

double logarithmic(Rng& rng, double low, double high) { return low * std::pow(high / low, rng.uniform()); }

HeightField noise_ground(Rng& rng, Seed seed, const RunContext& run) {
  const double cell = logarithmic(rng, 10, 120);
  terrain::NoiseParams params;
  params.kind = static_cast<terrain::NoiseKind>(rng.integer(0, 2));
  params.wavelength_m = cell * logarithmic(rng, 24, 200);
  params.height_m = params.wavelength_m * logarithmic(rng, 0.03, 0.25);
  params.gain = rng.uniform(0.4, 0.55);
  params.base_m = rng.chance(0.3) ? -rng.uniform(0, 0.4) * *params.height_m : 2 * *params.height_m;
  return terrain::noise(params, GridFrame::centred(kErodeCells, kErodeCells, cell), seed, run);
}

constexpr double kKnown = 0.97;  ///< share of a crop that must be known

std::optional<HeightField> real_ground(const std::vector<GroundTile>& tiles, Rng& rng) {
  for (int attempt = 0; attempt < 50; ++attempt) {
    const GroundTile& tile = tiles[static_cast<size_t>(rng.integer(0, static_cast<int>(tiles.size()) - 1))];
    if (std::min(tile.heights.width(), tile.heights.height()) < kErodeCells) continue;
    if (std::optional<Crop> crop = find_crop(tile.heights, kErodeCells, kKnown, rng)) return std::move(crop->heights);
  }
  return std::nullopt;
}

}  // namespace

HeightField eroded(const HeightField& terrain, double years, Seed seed, const RunContext& run) {
  erosion::RunParams params;
  params.years = years;
  params.hardness_variation = 0;
  return erosion::run({terrain, {}, {}}, {}, params, seed, run).terrain;
}

ErodePair make_erode_pair(const std::vector<GroundTile>& tiles, uint64_t n, Seed seed, const RunContext& run) {
  const Seed own = seed.derive("pair", n);
  Rng rng(own);
  ErodePair pair;
  std::optional<HeightField> real;
  if (!tiles.empty() && rng.chance(0.6)) real = real_ground(tiles, rng);
  pair.before = real ? std::move(*real) : noise_ground(rng, own.derive("noise"), run);
  const auto years = [&rng] { return logarithmic(rng, learned::kFewestYears, learned::kMostYears); };
  if (rng.chance(0.25)) pair.before = eroded(pair.before, years(), own.derive("earlier"), run);
  pair.years = years();
  pair.after = eroded(pair.before, pair.years, own.derive("erosion"), run);
  return pair;
}

}  // namespace seamount::train
