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

constexpr double kCoarseCells[] = {2.5, 5.0, 9.0};       ///< degrees of detail: cells on which water runs
constexpr double kLeastArea[] = {160.0, 700.0, 2600.0};  ///< and that make a line

DrawnTile drawn_at(const GroundTile& tile, size_t degree, Seed seed, const RunContext& run) {
  const double cell = tile.heights.cell_m();
  sketch::ExtractParams params;
  params.coarse_m = kCoarseCells[degree] * cell;
  params.min_area_m2 = kLeastArea[degree] * cell * cell;
  params.cue_area_m2 = 2 * kLeastArea[degree] * cell * cell;
  params.sea = false;
  const sketch::Sketch sketch = sketch::extract(tile.heights, params, seed, run);
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

SketchTask::SketchTask(const std::string& dem_folder, int size, Seed seed, const RunContext& run)
    : size_(size),
      seed_(seed),
      training_(sketched(read_ground(dem_folder, false, run), seed, run.part(0, 0.8))),
      held_out_(sketched(read_ground(dem_folder, true, run), seed, run.part(0.8, 1))) {}

std::vector<SketchTask::Ground> SketchTask::sketched(std::vector<GroundTile> tiles, Seed seed, const RunContext& run) {
  std::vector<Ground> grounds(tiles.size());
  parallel_blocks(run, static_cast<int64_t>(tiles.size()), 1, [&](int64_t begin, int64_t) {
    RunContext quiet;
    quiet.threads = 1;
    quiet.cancelled = run.cancelled;
    Ground& ground = grounds[static_cast<size_t>(begin)];
    ground.tile = std::move(tiles[static_cast<size_t>(begin)]);
    for (size_t degree = 0; degree < std::size(kCoarseCells); ++degree)
      ground.drawn.push_back(drawn_at(ground.tile, degree, seed.derive(ground.tile.name, degree), quiet));
  });
  std::erase_if(grounds, [&](const Ground& ground) {
    return std::min(ground.tile.heights.width(), ground.tile.heights.height()) < 300;
  });
  return grounds;
}

learned::Architecture SketchTask::architecture() const { return {.planes = learned::kSketchPlanes}; }

std::vector<int> SketchTask::drawn_planes() const {
  return {std::begin(learned::kSketchDrawnPlanes), std::end(learned::kSketchDrawnPlanes)};
}

Sample SketchTask::sample(const std::vector<Ground>& grounds, Seed seed) const {
  Rng rng(seed);
  double area = 0;
  for (const Ground& ground : grounds) area += std::sqrt(static_cast<double>(ground.tile.heights.size()));
  while (true) {
    double place = rng.uniform(0, area);
    size_t chosen = 0;
    while (chosen + 1 < grounds.size() &&
           (place -= std::sqrt(static_cast<double>(grounds[chosen].tile.heights.size()))) > 0)
      ++chosen;
    const Ground& ground = grounds[chosen];
    const std::optional<Crop> crop = find_crop(ground.tile.heights, size_, rng);
    if (!crop) continue;
    const DrawnTile& drawn = ground.drawn[static_cast<size_t>(rng.integer(0, 2))];
    return sketch_sample(*crop, drawn, seed.derive("drawn"));
  }
}

}  // namespace seamount::train
