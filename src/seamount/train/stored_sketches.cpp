#include "seamount/train/stored_sketches.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "seamount/base/hash.h"
#include "seamount/ops/learned/sketch_planes.h"
#include "seamount/train/sample_set.h"
#include "seamount/train/sketch_crop.h"
#include "seamount/train/stored_view.h"

namespace seamount::train {
namespace {

constexpr int kStrong = 128;
constexpr int kFaintest = 24;  ///< green of the lowest cue is 32

/// Lines and heights of a painted sketch, those of the kinds that are wanted.
void take_drawing(const Image& image, const SketchDraw& draw, const StoredView& view, Rng& rng,
                  learned::SketchMap& map) {
  const bool river = rng.chance(0.8), ridge = rng.chance(0.8), cue = rng.chance(0.6);
  if (river) map.river = Grid<uint8_t>(map.frame, 0);
  if (ridge) map.ridge = Grid<uint8_t>(map.frame, 0);
  if (cue) {
    map.cue = Grid<uint8_t>(map.frame, 0);
    map.cue_m = ScalarField(map.frame, 0.0F);
  }
  for (int y = 0; y < view.size; ++y) {
    for (int x = 0; x < view.size; ++x) {
      const auto [u, v] = view.from(x, y);
      const uint8_t* pixel = image.pixel(u, v);
      if (ridge) map.ridge(x, y) = pixel[0] >= kStrong && pixel[0] > pixel[2];
      if (river) map.river(x, y) = pixel[2] >= kStrong && pixel[2] > pixel[0];
      if (!cue || pixel[1] < kFaintest || pixel[1] < pixel[0] || pixel[1] < pixel[2]) continue;
      map.cue(x, y) = 1;
      const double share = std::clamp((pixel[1] - 32.0) / 223.0, 0.0, 1.0);
      map.cue_m(x, y) = static_cast<float>(draw.lowest_cue_m + share * (draw.highest_cue_m - draw.lowest_cue_m));
    }
  }
}

void take_levelset(const Image& image, const StoredView& view, learned::SketchMap& map) {
  map.level = Grid<int8_t>(map.frame, 0);
  for (int y = 0; y < view.size; ++y) {
    for (int x = 0; x < view.size; ++x) {
      const auto [u, v] = view.from(x, y);
      map.level(x, y) = image.pixel(u, v)[0] >= kStrong ? 1 : -1;
    }
  }
}

}  // namespace

StoredSketchTask::StoredSketchTask(std::string folder, int size, std::vector<StoredSketch> examples, Seed seed)
    : folder_(std::move(folder)),
      stored_size_(size),
      size_(learned_size(size)),
      examples_(std::move(examples)),
      seed_(seed) {
  // Examples of one region may show the same ground: a region is learned from, or it is not.
  const auto region = [this](size_t i) { return examples_[i].tile.substr(0, examples_[i].tile.find('_')); };
  bool several = false;
  for (size_t i = 1; i < examples_.size(); ++i) several |= region(i) != region(0);
  split_ = split_samples(examples_.size(), seed, [&](size_t i) {
    return several ? Hasher().text(region(i)).digest().low : static_cast<uint64_t>(i);
  });
}

learned::Architecture StoredSketchTask::architecture() const { return {.planes = learned::kSketchPlanes}; }

std::vector<int> StoredSketchTask::drawn_planes() const {
  return {std::begin(learned::kSketchDrawnPlanes), std::end(learned::kSketchDrawnPlanes)};
}

Sample StoredSketchTask::sample(const std::vector<size_t>& among, Seed seed) const {
  Rng rng(seed);
  const StoredSketch& stored =
      examples_[among[static_cast<size_t>(rng.integer(0, static_cast<int>(among.size()) - 1))]];
  const StoredView view = StoredView::any(size_, stored_size_, rng);
  const auto file = [&](const char* kind) { return sample_file(folder_, stored.index, kind); };
  const HeightField heights =
      read_stored_heights(file("height"), stored_size_, stored.draw.cell_m, {stored.draw.low_m, stored.draw.high_m});
  Crop crop;
  crop.heights = seen(heights, view);
  crop.filled = Grid<uint8_t>(crop.heights.frame(), 0);
  learned::SketchMap map = scaled_map(crop, rng);
  take_drawing(read_stored_picture(file("sketch"), stored_size_), stored.draw, view, rng, map);
  if (rng.chance(0.3)) take_levelset(read_stored_picture(file("levelset"), stored_size_), view, map);
  return sample_of(map, crop, seed.derive("noise"));
}

}  // namespace seamount::train
