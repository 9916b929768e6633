#include "seamount/train/erode_task.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/ops/learned/erode_planes.h"

namespace seamount::train {
namespace {

constexpr float kMostChange = 12.0F;  ///< in units: ground that fails where the estimate sees none must not rule

}  // namespace

ErodeTask::ErodeTask(const std::string& dem_folder, int size, int pairs, Seed seed, const RunContext& run)
    : size_(size), seed_(seed) {
  if (pairs < 1) throw InvalidArgument("--pairs", "must be at least 1");
  if (size < 32 || size > kErodeCells || size % 32 != 0) throw InvalidArgument("--size", "must be 32, 64 ... 256");
  for (const bool held_out : {false, true}) {
    const RunContext part = held_out ? run.part(0.9, 1) : run.part(0, 0.9);
    const std::vector<GroundTile> tiles =
        dem_folder.empty() ? std::vector<GroundTile>() : read_ground(dem_folder, held_out, part);
    (held_out ? held_out_ : training_) = seen_pairs(tiles, held_out ? std::max(1, pairs / 8) : pairs,
                                                    seed.derive(held_out ? "held out pairs" : "pairs"), part);
  }
}

std::vector<ErodeTask::Seen> ErodeTask::seen_pairs(const std::vector<GroundTile>& tiles, int count, Seed seed,
                                                   const RunContext& run) {
  std::vector<Seen> pairs(static_cast<size_t>(count));
  parallel_blocks(run, count, 1, [&](int64_t n, int64_t) {
    RunContext quiet;
    quiet.threads = 1;
    quiet.cancelled = run.cancelled;
    const ErodePair pair = make_erode_pair(tiles, static_cast<uint64_t>(n), seed, quiet);
    const learned::ErodePlanes erode(pair.before, pair.years, 0, quiet);
    if (erode.unit_m() == 0) return;
    Seen& seen = pairs[static_cast<size_t>(n)];
    seen.width = pair.before.width();
    seen.height = pair.before.height();
    seen.planes.resize(pair.before.size() * learned::kErodePlanes);
    erode.planes().fill(0, seen.height, seen.planes);
    seen.base.assign(erode.base().cells().begin(), erode.base().cells().end());
    for (size_t i = 0; i < pair.before.size(); ++i) {
      const double change = (pair.after.data()[i] - pair.before.data()[i]) / erode.unit_m();
      seen.target.push_back(std::clamp(static_cast<float>(change), -kMostChange, kMostChange));
    }
  });
  std::erase_if(pairs, [](const Seen& seen) { return seen.planes.empty(); });
  if (pairs.empty()) throw InvalidArgument("--pairs", "none of so few changes: more are needed");
  return pairs;
}

learned::Architecture ErodeTask::architecture() const {
  return {.planes = learned::kErodePlanes, .widths = {16, 32, 64, 96}};
}

Sample ErodeTask::sample(const std::vector<Seen>& pairs, Seed seed) const {
  Rng rng(seed);
  const Seen& seen = pairs[static_cast<size_t>(rng.integer(0, static_cast<int>(pairs.size()) - 1))];
  Sample sample;
  sample.size = size_;
  const int left = rng.integer(0, seen.width - size_), top = rng.integer(0, seen.height - size_);
  const bool flip_x = rng.chance(0.5), flip_y = rng.chance(0.5), transpose = rng.chance(0.5);
  double change = 0;
  for (int y = 0; y < size_; ++y) {
    for (int x = 0; x < size_; ++x) {
      int u = flip_x ? size_ - 1 - x : x, v = flip_y ? size_ - 1 - y : y;
      if (transpose) std::swap(u, v);
      const size_t i = static_cast<size_t>(top + v) * static_cast<size_t>(seen.width) + static_cast<size_t>(left + u);
      const float* const p = seen.planes.data() + i * learned::kErodePlanes;
      sample.planes.insert(sample.planes.end(), p, p + learned::kErodePlanes);
      sample.base.push_back(seen.base[i]);
      sample.target.push_back(seen.target[i]);
      change += std::abs(seen.target[i]);
    }
  }
  // Each sample's error counts against the change that was made.
  const double mean = change / static_cast<double>(sample.target.size());
  sample.weight.assign(sample.target.size(), static_cast<float>(1 / std::max(1.0, mean)));
  return sample;
}

}  // namespace seamount::train
