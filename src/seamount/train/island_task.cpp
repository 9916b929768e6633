#include "seamount/train/island_task.h"

#include <algorithm>
#include <cmath>

#include "seamount/geom/grid/painted_labels.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/ops/learned/island.h"

namespace seamount::train {
namespace {

constexpr int kGroup = 6;              ///< samples of one made island
constexpr float kAbyssWeight = 0.15F;  ///< of the deep sea floor where its depth is not told

RunContext alone() {
  RunContext run;
  run.threads = 1;
  return run;
}

/// A random cell whose square of `size` shows more than abyss, where there is one.
std::pair<int, int> corner_of(const LabelMap& labels, int size, Rng& rng) {
  std::pair<int, int> corner;
  for (int attempt = 0; attempt < 12; ++attempt) {
    corner = {rng.integer(0, labels.width() - size), rng.integer(0, labels.height() - size)};
    int seen = 0;
    for (int y = 0; y < size; y += 8) {
      for (int x = 0; x < size; x += 8) seen += labels(corner.first + x, corner.second + y) != Region::abyss;
    }
    if (seen > 60) break;
  }
  return corner;
}

/// Blur, noise of colour and wrong specks: what a painter, a scanner or a JPEG does to a map.
Image painted(const LabelMap& labels, double subsidence, Rng& rng) {
  Image image = geom::encode_labels(labels, subsidence);
  const double blur = rng.chance(0.6) ? rng.uniform(0.4, 2.2) : 0.0, noise = rng.chance(0.6) ? rng.uniform(2, 24) : 0.0;
  for (size_t channel = 0; channel < 3; ++channel) {
    ScalarField plane(labels.frame());
    for (size_t i = 0; i < plane.size(); ++i) plane.data()[i] = image.rgb[3 * i + channel];
    geom::gaussian_blur(plane, blur * labels.cell_m(), alone());
    for (size_t i = 0; i < plane.size(); ++i)
      image.rgb[3 * i + channel] =
          static_cast<uint8_t>(std::clamp(plane.data()[i] + noise * (rng.uniform() - 0.5) * 2, 0.0, 255.0));
  }
  for (int specks = rng.chance(0.4) ? rng.integer(1, 30) : 0; specks > 0; --specks) {
    const Colour colour = painted_colour(kRegions[static_cast<size_t>(rng.integer(0, kRegionCount - 1))], subsidence);
    const int x0 = rng.integer(0, labels.width() - 1), y0 = rng.integer(0, labels.height() - 1), r = rng.integer(0, 1);
    for (int y = std::max(0, y0 - r); y <= std::min(labels.height() - 1, y0 + r); ++y) {
      for (int x = std::max(0, x0 - r); x <= std::min(labels.width() - 1, x0 + r); ++x) {
        uint8_t* const p = image.pixel(x, y);
        p[0] = colour.r;
        p[1] = colour.g;
        p[2] = colour.b;
      }
    }
  }
  return image;
}

}  // namespace

Sample island_sample(const learned::IslandMap& map, const LabelMap& labels, const HeightField& heights, Seed noise) {
  const learned::IslandPlanes planes(map, noise, alone());
  Sample sample;
  sample.size = heights.width();
  sample.planes.resize(heights.size() * learned::kIslandPlanes);
  planes.planes().fill(0, sample.size, sample.planes);
  sample.base.assign(heights.size(), 0.0F);
  for (const Region region : labels.cells())
    sample.weight.push_back(region == Region::abyss && !map.floor_m ? kAbyssWeight : 1.0F);
  for (const float z : heights.cells()) sample.target.push_back(learned::island_code(z, 1));
  return sample;
}

learned::Architecture IslandTask::architecture() const { return {.planes = learned::kIslandPlanes}; }

std::shared_ptr<const IslandTask::Made> IslandTask::island(uint64_t group, Seed seed) const {
  {
    const std::lock_guard lock(mutex_);
    for (const auto& made : recent_) {
      if (made->group == group && made->seed == seed) return made;
    }
  }
  auto made = std::make_shared<Made>();
  made->group = group;
  made->seed = seed;
  Rng rng(seed.derive("group", group));
  IslandSetParams params;
  params.size = learned::kIslandCells * (rng.chance(0.4) ? 1 : rng.chance(0.7) ? 2 : 4);
  params.width_m = learned::kIslandWidth_m;
  // The levels of an island follow each other and all but the first are nearly drowned: half of the samples show land.
  const auto levels = static_cast<uint64_t>(params.levels);
  const uint64_t level = rng.chance(0.5) ? 0 : static_cast<uint64_t>(rng.integer(1, params.levels - 1));
  IslandSample drawn = draw_island_sample(params, group * levels + level, seed);
  if (level == 0 && rng.chance(0.5)) drawn.subsidence = 0;
  made->pair = make_island_pair(params, drawn, seed, alone());
  made->subsidence = drawn.subsidence;
  const std::lock_guard lock(mutex_);
  recent_.push_back(made);
  if (recent_.size() > 8) recent_.pop_front();
  return made;
}

Sample IslandTask::sample(uint64_t n, Seed seed) const {
  const std::shared_ptr<const Made> made = island(n / kGroup, seed);
  Rng rng(seed.derive("sample", n));
  const int size = learned::kIslandCells;
  const auto [left, top] = corner_of(made->pair.labels, size, rng);
  const bool flip_x = rng.chance(0.5), flip_y = rng.chance(0.5), transpose = rng.chance(0.5);
  learned::IslandMap map;
  map.frame = GridFrame::centred(size, size, made->pair.terrain.cell_m());
  LabelMap labels(map.frame);
  HeightField heights(map.frame);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      int u = flip_x ? size - 1 - x : x, v = flip_y ? size - 1 - y : y;
      if (transpose) std::swap(u, v);
      labels(x, y) = made->pair.labels(left + u, top + v);
      heights(x, y) = made->pair.terrain(left + u, top + v);
    }
  }
  double subsidence = made->subsidence;
  if (rng.chance(0.4)) {
    geom::PaintedLabels read = geom::decode_labels(painted(labels, subsidence, rng), map.frame, alone());
    map.shares = std::move(read.shares);
    map.subsidence = std::move(read.subsidence_per_cell);
  } else {
    map.shares = learned::shares_of(labels, alone());
    map.subsidence = ScalarField(map.frame, static_cast<float>(subsidence));
  }
  const auto [low, high] = std::minmax_element(made->pair.terrain.cells().begin(), made->pair.terrain.cells().end());
  if (rng.chance(0.7) && *high > 0) map.peak_m = *high;
  if (rng.chance(0.7)) map.floor_m = *low;
  return island_sample(map, labels, heights, seed.derive("noise", n));
}

}  // namespace seamount::train
