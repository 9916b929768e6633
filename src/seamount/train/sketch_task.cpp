#include "seamount/train/sketch_task.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "seamount/base/parallel.h"
#include "seamount/ops/learned/sketch_planes.h"
#include "seamount/ops/sketch/extract.h"
#include "seamount/train/sketch_crop.h"

namespace seamount::train {
namespace {

DrawnTile drawn_at(const GroundTile& tile, int detail, Seed seed, const RunContext& run) {
  const sketch::Sketch sketch = sketch::extract(tile.heights, extract_params(detail, tile.heights.cell_m()), seed, run);
  DrawnTile drawn;
  const GridFrame& frame = tile.heights.frame();
  for (const ValuedLine& line : sketch.lines.lines) {
    std::vector<std::pair<float, float>> points;
    for (const Vec2& p : line.points)
      points.emplace_back(static_cast<float>(frame.column(p.x)), static_cast<float>(frame.row(p.y)));
    (line.value == 0 ? drawn.rivers : drawn.ridges).push_back(std::move(points));
  }
  for (const ValuedPoint& point : sketch.lines.points) {
    drawn.cues.push_back({static_cast<float>(frame.column(point.place.x)), static_cast<float>(frame.row(point.place.y)),
                          static_cast<float>(point.value)});
  }
  return drawn;
}

}  // namespace

sketch::ExtractParams extract_params(int detail, double cell_m) {
  constexpr double kCoarseCells[kSketchDetails] = {2.5, 5.0, 9.0};       // cells on which water runs
  constexpr double kLeastArea[kSketchDetails] = {160.0, 700.0, 2600.0};  // and that make a line
  sketch::ExtractParams params;
  params.coarse_m = kCoarseCells[detail] * cell_m;
  params.min_area_m2 = kLeastArea[detail] * cell_m * cell_m;
  params.cue_area_m2 = 2 * kLeastArea[detail] * cell_m * cell_m;
  params.sea = false;
  return params;
}

size_t choose_tile(const std::vector<GroundTile>& tiles, Rng& rng) {
  const auto share = [&](size_t i) { return std::sqrt(static_cast<double>(tiles[i].heights.size())); };
  double all = 0;
  for (size_t i = 0; i < tiles.size(); ++i) all += share(i);
  double place = rng.uniform(0, all);
  size_t chosen = 0;
  while (chosen + 1 < tiles.size() && (place -= share(chosen)) > 0) ++chosen;
  return chosen;
}

SketchTask::SketchTask(const std::string& dem_folder, int size, Seed seed, const RunContext& run)
    : size_(size),
      seed_(seed),
      training_(sketched(read_ground(dem_folder, false, run), seed, run.part(0, 0.8))),
      held_out_(sketched(read_ground(dem_folder, true, run), seed, run.part(0.8, 1))) {}

SketchTask::Ground SketchTask::sketched(std::vector<GroundTile> tiles, Seed seed, const RunContext& run) {
  constexpr int kLeastSide = 300;
  std::erase_if(tiles, [&](const GroundTile& tile) {
    return std::min(tile.heights.width(), tile.heights.height()) < kLeastSide;
  });
  Ground ground{std::move(tiles), {}};
  ground.drawn.resize(ground.tiles.size());
  parallel_blocks(run, static_cast<int64_t>(ground.tiles.size()), 1, [&](int64_t begin, int64_t) {
    RunContext quiet;
    quiet.threads = 1;
    quiet.cancelled = run.cancelled;
    const auto i = static_cast<size_t>(begin);
    for (int detail = 0; detail < kSketchDetails; ++detail) {
      const Seed own = seed.derive(ground.tiles[i].name, static_cast<uint64_t>(detail));
      ground.drawn[i][static_cast<size_t>(detail)] = drawn_at(ground.tiles[i], detail, own, quiet);
    }
  });
  return ground;
}

learned::Architecture SketchTask::architecture() const { return {.planes = learned::kSketchPlanes}; }

std::vector<int> SketchTask::drawn_planes() const {
  return {std::begin(learned::kSketchDrawnPlanes), std::end(learned::kSketchDrawnPlanes)};
}

Sample SketchTask::sample(const Ground& ground, Seed seed) const {
  constexpr double kKnown = 0.92;
  Rng rng(seed);
  while (true) {
    const size_t chosen = choose_tile(ground.tiles, rng);
    const std::optional<Crop> crop = find_crop(ground.tiles[chosen].heights, size_, kKnown, rng);
    if (!crop) continue;
    const DrawnTile& drawn = ground.drawn[chosen][static_cast<size_t>(rng.integer(0, kSketchDetails - 1))];
    return sketch_sample(*crop, drawn, seed.derive("drawn"));
  }
}

}  // namespace seamount::train
