#include "seamount/ops/terrain/sculpt.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/geom/brush/brush_replay.h"
#include "seamount/geom/grid/surface.h"
#include "seamount/geom/grid/voids.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/solve/fill_voids.h"
#include "seamount/model/same_size.h"

namespace seamount::terrain {
namespace {

constexpr double kSmoothedOfRadius = 1.0 / 3.0;  // deviation of the Gaussian; three of them lie within the radius
constexpr double kPrepared = 0.2;                // of the work, roughly
constexpr double kNoiseReach = 2.0;              // noise of deviation 0.35 becomes about [-1, 1]

/// What was measured where a stroke is, when its turn came.
struct Seen {
  double start_m = 0.0, end_m = 0.0;
  HeightField smoothed;     ///< of the cells around, for `smooth`
  geom::CellWindow window;  ///< where `smoothed` lies
};

/// Does a stroke have to see the ground as it is when its turn comes?
bool looks(const SculptStroke& stroke) {
  if (std::holds_alternative<SmoothTool>(stroke)) return true;
  if (const auto* flatten = std::get_if<FlattenTool>(&stroke)) return !flatten->height_m;
  if (const auto* ramp = std::get_if<RampTool>(&stroke)) return !ramp->start_m || !ramp->end_m;
  return false;
}

/// Mean ground under a brush at a place; the nearest cell's where there is none under it.
double ground_at(const HeightField& ground, Vec2 place, const geom::BrushProfile& brush) {
  const GridFrame& frame = ground.frame();
  const geom::CellWindow window = geom::cells_of({place, place}, frame, brush.radius_m());
  double sum = 0.0, weights = 0.0;
  for (int y = window.top; y < window.bottom; ++y) {
    for (int x = window.left; x < window.right; ++x) {
      const double w = brush.weight(std::hypot(frame.x(x) - place.x, frame.y(y) - place.y));
      sum += w * ground(x, y);
      weights += w;
    }
  }
  if (weights > 0.0) return sum / weights;
  const auto nearest = [](double v, int count) {
    return static_cast<int>(std::clamp(std::round(v), 0.0, count - 1.0));
  };
  return ground(nearest(frame.column(place.x), frame.width), nearest(frame.row(place.y), frame.height));
}

/// A row of cells under a stroke.
struct Row {
  int x, y;
  std::span<const float> weights;
  float* ground;
};

class Session {
 public:
  Session(const HeightField& before, const Mask* mask, const SculptParams& params, Seed seed, const RunContext& run,
          const GridFrame& whole)
      : before_(before),
        ground_(before),
        mask_(mask),
        strokes_(params.strokes),
        seed_(seed),
        run_(run),
        whole_(whole) {}

  HeightField replay() {
    prepare();
    size_t done = 0;
    for (size_t next = 0; next < strokes_.size(); ++next) {
      if (!looks(strokes_[next])) continue;
      apply(done, next);
      look(next);
      done = next;
    }
    apply(done, strokes_.size());
    return std::move(ground_);
  }

 private:
  const GridFrame& frame() const { return before_.frame(); }

  void prepare() {
    std::vector<const Brush*> brushes;
    brushes.reserve(strokes_.size());
    for (const SculptStroke& stroke : strokes_)
      brushes.push_back(std::visit([](const Brush& brush) { return &brush; }, stroke));
    paths_ = geom::brush_paths(brushes, whole_, "strokes", run_.part(0.0, kPrepared));
    seen_.resize(strokes_.size());
  }

  /// Measures what stroke `i` needs of the ground, on which all before it are done.
  void look(size_t i) {
    if (paths_[i].samples.empty()) return;
    std::visit([&](const auto& tool) { look(tool, paths_[i], seen_[i]); }, strokes_[i]);
  }

  template <class Tool>
  void look(const Tool&, const geom::BrushPath&, Seen&) const {}

  void look(const SmoothTool& tool, const geom::BrushPath& path, Seen& seen) const {
    seen.window = geom::cells_of(path.box, frame(), tool.radius_m);
    if (seen.window.empty()) return;
    HeightField part(geom::cells_frame(path.box, frame(), tool.radius_m));
    for (int y = 0; y < part.height(); ++y) {
      const float* from = &ground_(seen.window.left, seen.window.top + y);
      std::copy(from, from + part.width(), part.row(y).data());
    }
    const RunContext quiet{run_.threads, {}, run_.cancelled, {}};
    seen.smoothed = geom::at_scale(part, 2.0 * kSmoothedOfRadius * tool.radius_m, quiet);
  }

  void look(const FlattenTool&, const geom::BrushPath& path, Seen& seen) const {
    seen.start_m = ground_at(ground_, path.samples.front().at, path.profile);
  }

  void look(const RampTool&, const geom::BrushPath& path, Seen& seen) const {
    seen.start_m = ground_at(ground_, path.samples.front().at, path.profile);
    seen.end_m = ground_at(ground_, path.samples.back().at, path.profile);
  }

  void apply(size_t begin, size_t end) {
    const RunContext run = run_.part(progress(begin), progress(end));
    geom::replay(paths_, begin, end, frame(), run, [&](size_t i, int y, int x, std::span<const float> touched) {
      std::vector<float> room;
      const Row row{x, y, masked(touched, x, y, room), &ground_(x, y)};
      std::visit([&](const auto& tool) { draw(tool, paths_[i], seen_[i], row); }, strokes_[i]);
    });
    for (size_t i = begin; i < end; ++i) seen_[i] = {};
  }

  double progress(size_t stroke) const {
    return kPrepared +
           (1.0 - kPrepared) * static_cast<double>(stroke) / static_cast<double>(std::max<size_t>(1, strokes_.size()));
  }

  std::span<const float> masked(std::span<const float> weights, int x, int y, std::vector<float>& room) const {
    if (mask_ == nullptr) return weights;
    room.resize(weights.size());
    const float* mask = &(*mask_)(x, y);
    for (size_t i = 0; i < room.size(); ++i)
      room[i] = mask[i] > 0.0F ? weights[i] * std::min(mask[i], 1.0F) : 0.0F;  // what is not a number is nothing
    return room;
  }

  static void add(double amount, const Row& row) {
    const auto by = static_cast<float>(amount);
    for (size_t i = 0; i < row.weights.size(); ++i) row.ground[i] += by * row.weights[i];
  }

  /// Towards heights that level(i) gives.
  template <class Level>
  static void approach(double strength, const Row& row, Level&& level) {
    const auto share = static_cast<float>(strength);
    for (size_t i = 0; i < row.weights.size(); ++i)
      row.ground[i] += share * std::min(row.weights[i], 1.0F) * (level(i) - row.ground[i]);
  }

  void draw(const RaiseTool& tool, const geom::BrushPath& path, const Seen&, const Row& row) const {
    add(path.thinned * tool.height_m, row);
  }
  void draw(const LowerTool& tool, const geom::BrushPath& path, const Seen&, const Row& row) const {
    add(-path.thinned * tool.depth_m, row);
  }

  void draw(const SmoothTool& tool, const geom::BrushPath& path, const Seen& seen, const Row& row) const {
    const float* smoothed = &seen.smoothed(row.x - seen.window.left, row.y - seen.window.top);
    approach(path.thinned * tool.strength, row, [=](size_t i) { return smoothed[i]; });
  }

  void draw(const FlattenTool& tool, const geom::BrushPath& path, const Seen& seen, const Row& row) const {
    const auto level = static_cast<float>(tool.height_m.value_or(seen.start_m));
    approach(path.thinned * tool.strength, row, [=](size_t) { return level; });
  }

  void draw(const RampTool& tool, const geom::BrushPath& path, const Seen& seen, const Row& row) const {
    const Vec2 from = path.samples.front().at, way = path.samples.back().at - from;
    const double length2 = dot(way, way);
    const Vec2 per_m = length2 > 0.0 ? (1.0 / length2) * way : Vec2{};
    const double start = tool.start_m.value_or(seen.start_m), rise = tool.end_m.value_or(seen.end_m) - start;
    const double along = per_m.y * (frame().y(row.y) - from.y);
    approach(path.thinned * tool.strength, row, [&, x = row.x](size_t i) {
      const double across = per_m.x * (frame().x(x + static_cast<double>(i)) - from.x);
      return static_cast<float>(start + rise * std::clamp(across + along, 0.0, 1.0));
    });
  }

  void draw(const RoughenTool& tool, const geom::BrushPath& path, const Seen&, const Row& row) const {
    const geom::Fbm shape{.wavelength_m = tool.wavelength_m, .octaves = 12, .cell_m = frame().cell_m};
    std::vector<float> noise(row.weights.size());
    const GridFrame cells = frame().window(row.x, row.y, static_cast<int>(noise.size()), 1);
    geom::fbm_row(seed_, shape, cells, 0, noise);
    const auto by = static_cast<float>(kNoiseReach * path.thinned * tool.amplitude_m);
    for (size_t i = 0; i < noise.size(); ++i) row.ground[i] += by * row.weights[i] * noise[i];
  }

  void draw(const EraseTool& tool, const geom::BrushPath& path, const Seen&, const Row& row) const {
    const float* before = &before_(row.x, row.y);
    approach(path.thinned * tool.strength, row, [=](size_t i) { return before[i]; });
  }

  const HeightField& before_;
  HeightField ground_;
  const Mask* mask_;
  const std::vector<SculptStroke>& strokes_;
  Seed seed_;
  const RunContext& run_;
  const GridFrame& whole_;
  std::vector<geom::BrushPath> paths_;
  std::vector<Seen> seen_;
};

}  // namespace

Reach sculpt_reach(const SculptParams& params) {
  for (const SculptStroke& stroke : params.strokes) {
    if (std::holds_alternative<SmoothTool>(stroke))
      return Reach::everything(
          "the pen's smooth looks at all ground under its stroke; terrain.smooth with a mask does not");
    if (looks(stroke))
      return Reach::everything("flatten and ramp look for the ground where a stroke begins; stated heights do not");
  }
  Reach reach = Reach::place();
  reach.known = true;
  return reach;
}

HeightField sculpt(const HeightField& terrain, const Mask* mask, const SculptParams& params, Seed seed,
                   const RunContext& run, const GridFrame* whole) {
  check_params(params);
  if (mask != nullptr) check_same_size("mask", mask->frame(), terrain.frame());
  run.check_cancelled();
  if (params.strokes.empty()) return terrain;
  const Seed noise = seed.derive("sculpt");
  const GridFrame& all = whole != nullptr ? *whole : terrain.frame();
  if (geom::count_voids(terrain, run) == 0) return Session(terrain, mask, params, noise, run, all).replay();
  HeightField filled = terrain;  // strokes at the rim of a hole need something beyond it
  geom::fill_voids(filled, run.part(0.0, 0.2));
  HeightField out = Session(filled, mask, params, noise, run.part(0.2, 1.0), all).replay();
  for (size_t i = 0; i < out.size(); ++i)
    if (std::isnan(terrain.cells()[i])) out.cells()[i] = std::numeric_limits<float>::quiet_NaN();
  return out;
}

}  // namespace seamount::terrain
