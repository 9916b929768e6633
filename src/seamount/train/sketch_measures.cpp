#include "seamount/train/sketch_measures.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/water/flow.h"
#include "seamount/ops/hydrology/describe.h"
#include "seamount/ops/learned/sketch.h"
#include "seamount/ops/learned/sketch_map.h"
#include "seamount/ops/sketch/extract.h"
#include "seamount/train/detail_measures.h"
#include "seamount/train/ground_tiles.h"
#include "seamount/train/sketch_crop.h"

namespace seamount::train {
namespace {

constexpr double kCoarseCells = 5.0, kLineCells = 700.0;  ///< detail of the drawing
constexpr double kNetworkCells = 175.0;                   ///< catchment from which the result has a river, or a ridge
constexpr double kKnown = 0.97;                           ///< share of a piece that must be known
constexpr float kNearCells = 3.0F;
constexpr int kStrides = 5;  ///< 2 to 32 cells

/// Energy at each stride's frequency along rows and columns, and in the mean of the frequencies beside it.
struct Comb {
  std::array<double, kStrides> at{}, beside{};
};

void add_comb(const HeightField& heights, Comb& comb, const RunContext& run) {
  const geom::ComplexPlane plane = spectrum_of(heights, run);
  const int n = plane.n;
  const auto energy = [&](int u, int v) {
    const size_t i = plane.at(u % n, v % n);
    return static_cast<double>(plane.re[i]) * plane.re[i] + static_cast<double>(plane.im[i]) * plane.im[i];
  };
  for (int stride = 0; stride < kStrides; ++stride) {
    const int k = n >> (stride + 1);
    comb.at[static_cast<size_t>(stride)] += energy(k, 0) + energy(0, k);
    for (const int aside : {-3, -2, 2, 3})
      comb.beside[static_cast<size_t>(stride)] += (energy(k + aside, 0) + energy(0, k + aside)) / 4;
  }
}

double worst_of(const Comb& made, const Comb& real) {
  double worst = 0;
  for (size_t i = 0; i < kStrides; ++i)
    worst = std::max(worst, (made.at[i] / made.beside[i]) / (real.at[i] / real.beside[i]));
  return worst;
}

/// Share of `drawn` cells that lie near a cell in which the water of kNetworkCells gathers.
void add_met(const Grid<uint8_t>& drawn, const HeightField& heights, double& met, double& all, const RunContext& run) {
  const HeightField filled = geom::fill_depressions(heights, geom::kNoSea, run);
  const Grid<uint32_t> gathered = geom::flow_accumulation(geom::flow_directions(filled, geom::kNoSea, run), run);
  Grid<uint8_t> network(heights.frame(), 0);
  for (size_t i = 0; i < network.size(); ++i) network.data()[i] = gathered.data()[i] >= kNetworkCells;
  const ScalarField distance = geom::distance_to(network, run);
  const auto near = static_cast<float>(kNearCells * heights.cell_m()) + 1e-3F;
  for (size_t i = 0; i < drawn.size(); ++i) {
    all += drawn.data()[i];
    met += drawn.data()[i] != 0 && distance.data()[i] <= near;
  }
}

HeightField upside_down(HeightField heights) {
  for (float& z : heights.cells()) z = -z;
  return heights;
}

/// Sums over pieces, of one way to make ground.
struct Sums {
  double river = 0, rivers = 0, ridge = 0, ridges = 0, off = 0, cues = 0, pits = 0;
  std::map<std::string, std::pair<double, int>> distances;
  Comb comb;

  void add(const HeightField& heights, const HeightField& real, const learned::SketchMap& map, const RunContext& run) {
    if (!map.river.empty()) add_met(map.river, heights, river, rivers, run);
    if (!map.ridge.empty()) add_met(map.ridge, upside_down(heights), ridge, ridges, run);
    for (size_t i = 0; i < map.cue.size(); ++i) {
      if (map.cue.data()[i] == 0) continue;
      ++cues;
      off += std::abs(heights.data()[i] - map.cue_m.data()[i]) / map.relief_m;
    }
    pits += pits_per_km2(heights);
    add_comb(heights, comb, run);
    const Report report = hydrology::describe(heights, &real, {.sea = false}, run).report;
    for (const Descriptor& descriptor : report.descriptors) {
      if (!descriptor.distance) continue;
      distances[descriptor.name].first += *descriptor.distance;
      ++distances[descriptor.name].second;
    }
  }

  SketchMeasures mean(int pieces, const Comb& real) const {
    SketchMeasures out;
    out.pieces = pieces;
    out.rivers = rivers > 0 ? river / rivers : 1;
    out.ridges = ridges > 0 ? ridge / ridges : 1;
    out.cues = cues > 0 ? off / cues : 0;
    for (const auto& [name, sum] : distances) out.distances[name] = sum.first / sum.second;
    out.pits_km2 = pits / pieces;
    out.grid = worst_of(comb, real);
    return out;
  }
};

}  // namespace

ComparedMeasures measure_sketches(const learned::Network& network, const std::vector<GroundTile>& ground,
                                  const learned::Redraw& redraw, int count, int size, Seed seed,
                                  const RunContext& run) {
  if (size < 128 || !std::has_single_bit(static_cast<unsigned>(size)))
    throw InvalidArgument("size", "must be a power of two from 128 up");
  std::vector<const HeightField*> tiles;
  for (const GroundTile& tile : ground) {
    if (std::min(tile.heights.width(), tile.heights.height()) >= size) tiles.push_back(&tile.heights);
  }
  if (tiles.empty()) throw InvalidArgument("--dem", "no held-out ground is as large as a piece");
  Sums made, diffused, real;
  int pieces = 0;
  for (int i = 0; i < count; ++i) {
    run.check_cancelled();
    run.report(static_cast<double>(i) / count);
    Rng rng(seed.derive("piece", static_cast<uint64_t>(i)));
    const std::optional<Crop> crop = find_crop(*tiles[static_cast<size_t>(i) % tiles.size()], size, kKnown, rng);
    if (!crop) continue;
    const HeightField& real_ground = crop->heights;
    const double cell = real_ground.cell_m();
    const sketch::Sketch drawn = sketch::extract(real_ground,
                                                 {.coarse_m = kCoarseCells * cell,
                                                  .min_area_m2 = kLineCells * cell * cell,
                                                  .cue_area_m2 = 2 * kLineCells * cell * cell,
                                                  .sea = false},
                                                 seed.derive("sketch", static_cast<uint64_t>(i)), run);
    const auto [low, high] = std::minmax_element(real_ground.cells().begin(), real_ground.cells().end());
    learned::SketchParams params;
    params.low_m = *low;
    params.relief_m = std::max(1.0F, *high - *low);
    const learned::SketchInputs inputs{.lines = &drawn.lines, .redraw = redraw};
    const learned::SketchMap map = learned::map_of(inputs, params, real_ground.frame(), run);
    made.add(learned::sketch(inputs, params, network, real_ground.frame(), seed, run), real_ground, map, run);
    const learned::SketchPlanes planes(map, seed, run);
    HeightField spread(real_ground.frame());
    for (size_t c = 0; c < spread.size(); ++c)
      spread.data()[c] = static_cast<float>(*params.low_m + *params.relief_m * planes.base().data()[c]);
    diffused.add(spread, real_ground, map, run);
    real.add(real_ground, real_ground, map, run);
    ++pieces;
  }
  if (pieces == 0) throw InvalidArgument("--dem", "the held-out ground is flat, water or unknown");
  return {made.mean(pieces, real.comb), diffused.mean(pieces, real.comb), real.mean(pieces, real.comb)};
}

}  // namespace seamount::train
