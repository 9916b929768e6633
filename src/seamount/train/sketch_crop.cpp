#include "seamount/train/sketch_crop.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/geom/grid/pyramid_fill.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/ops/learned/sketch_planes.h"

namespace seamount::train {
namespace {

constexpr double kRimCells = 3.0;  ///< of known ground that a network has to join

using Line = std::vector<std::pair<float, float>>;

RunContext alone() {
  RunContext run;
  run.threads = 1;
  return run;
}

/// What is drawn in a sample, drawn at random.
struct Mix {
  bool river = false, ridge = false, cue = false, level = false;
  int strokes = 0;  ///< of each kind at most; 0: all
  double keep = 1;  ///< share of the strokes otherwise
  enum { none, mostly, patches } known = none;
};

Mix draw_mix(Rng& rng) {
  Mix mix;
  const double kind = rng.uniform();
  if (kind < 0.05) return mix;
  if (kind < 0.28) {
    mix.known = Mix::mostly;
    if (rng.chance(0.6)) return mix;
  } else if (kind < 0.40) {
    mix.known = Mix::patches;
  }
  mix.river = rng.chance(0.6);
  mix.ridge = rng.chance(0.6);
  mix.cue = rng.chance(0.5);
  mix.level = rng.chance(0.3);
  if (!mix.river && !mix.ridge && !mix.cue && !mix.level) (rng.chance(0.5) ? mix.river : mix.ridge) = true;
  if (rng.chance(0.25)) mix.strokes = rng.integer(1, 4);
  if (rng.chance(0.4)) mix.keep = rng.uniform(0.3, 1);
  return mix;
}

/// A smooth shift of the whole drawing, of up to three cells: a hand is not exact.
class Shake {
 public:
  explicit Shake(Rng& rng) : amplitude_(rng.chance(0.3) ? 0.0 : rng.uniform(0, 3)) {
    for (double& p : phase_) p = rng.uniform(0, 2 * std::numbers::pi);
    wave_ = rng.uniform(20, 60);
  }
  std::pair<float, float> operator()(std::pair<float, float> p) const {
    const double k = 2 * std::numbers::pi / wave_;
    return {static_cast<float>(p.first +
                               amplitude_ * std::sin(k * p.second + phase_[0]) * std::cos(k * p.first + phase_[1])),
            static_cast<float>(p.second +
                               amplitude_ * std::sin(k * p.first + phase_[2]) * std::cos(k * p.second + phase_[3]))};
  }

 private:
  double amplitude_, wave_ = 40;
  double phase_[4] = {};
};

void draw_line(const Line& line, Grid<uint8_t>& cells) {
  for (size_t i = 1; i < line.size(); ++i) {
    const auto [x0, y0] = line[i - 1];
    const auto [x1, y1] = line[i];
    const int steps = std::max(1, static_cast<int>(std::ceil(2 * std::max(std::abs(x1 - x0), std::abs(y1 - y0)))));
    for (int s = 0; s <= steps; ++s) {
      const float t = static_cast<float>(s) / static_cast<float>(steps);
      const int x = static_cast<int>(std::lround(x0 + t * (x1 - x0))),
                y = static_cast<int>(std::lround(y0 + t * (y1 - y0)));
      if (cells.contains(x, y)) cells(x, y) = 1;
    }
  }
}

Grid<uint8_t> draw_lines(const std::vector<Line>& lines, const Crop& crop, const Mix& mix, const Shake& shake,
                         Rng& rng) {
  const auto size = static_cast<float>(crop.heights.width());
  std::vector<Line> inside;
  for (const Line& line : lines) {
    Line placed;
    bool seen = false;
    for (const auto& point : line) {
      placed.push_back(crop.placed(point));
      seen |= placed.back().first >= 0 && placed.back().second >= 0 && placed.back().first < size &&
              placed.back().second < size;
    }
    if (!seen) continue;
    for (auto& point : placed) point = shake(point);
    inside.push_back(std::move(placed));
  }
  Grid<uint8_t> cells(crop.heights.frame(), 0);
  if (mix.strokes > 0) {
    for (int i = 0; i < mix.strokes && !inside.empty(); ++i) {
      const auto chosen = static_cast<size_t>(rng.integer(0, static_cast<int>(inside.size()) - 1));
      draw_line(inside[chosen], cells);
    }
    return cells;
  }
  for (Line& line : inside) {
    if (mix.keep < 1 && !rng.chance(mix.keep)) continue;
    if (rng.chance(0.15) && line.size() > 6) line.resize(line.size() / 2);  // a stroke that ends early
    draw_line(line, cells);
  }
  return cells;
}

void draw_cues(const DrawnTile& drawn, const Crop& crop, const Mix& mix, const Shake& shake, Rng& rng,
               learned::SketchMap& map) {
  map.cue = Grid<uint8_t>(map.frame, 0);
  map.cue_m = ScalarField(map.frame, 0.0F);
  const auto put = [&](int x, int y) {
    const int r = rng.integer(0, 1);
    const float z = crop.heights.clamped(x, y);
    for (int v = y - r; v <= y + r; ++v) {
      for (int u = x - r; u <= x + r; ++u) {
        if (!map.cue.contains(u, v)) continue;
        map.cue(u, v) = 1;
        map.cue_m(u, v) = z;
      }
    }
  };
  int left = mix.strokes > 0 ? mix.strokes : 1 << 20;
  for (const DrawnTile::Cue& cue : drawn.cues) {
    const auto [x, y] = shake(crop.placed({cue.x, cue.y}));
    if (!map.cue.contains(static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y))) || left <= 0 ||
        !rng.chance(mix.keep))
      continue;
    put(static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y)));
    --left;
  }
  if (rng.chance(0.3)) {  // heights given anywhere, not at summits alone
    for (int i = rng.integer(1, 8); i > 0; --i)
      put(rng.integer(0, map.frame.width - 1), rng.integer(0, map.frame.height - 1));
  }
}

void draw_level(const Crop& crop, Rng& rng, learned::SketchMap& map) {
  ScalarField blurred = crop.heights;
  geom::gaussian_blur(blurred, rng.uniform(3, 10) * map.frame.cell_m, alone());
  std::vector<float> sorted(blurred.cells().begin(), blurred.cells().end());
  const auto middle =
      sorted.begin() + static_cast<int64_t>(rng.uniform(0.3, 0.85) * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), middle, sorted.end());
  const float height = *middle;
  const bool part = rng.chance(0.3);  // painted in one place only
  const double cx = rng.uniform(0, map.frame.width), cy = rng.uniform(0, map.frame.height),
               r = rng.uniform(20, 0.6 * map.frame.width);
  map.level = Grid<int8_t>(map.frame, 0);
  for (int y = 0; y < map.frame.height; ++y) {
    for (int x = 0; x < map.frame.width; ++x) {
      if (part && std::hypot(x - cx, y - cy) > r) continue;
      map.level(x, y) = blurred(x, y) >= height ? 1 : -1;
    }
  }
}

void draw_known(const Crop& crop, const Mix& mix, Rng& rng, learned::SketchMap& map) {
  const bool mostly = mix.known == Mix::mostly;
  map.known_m = mostly ? crop.heights : HeightField(map.frame, std::numeric_limits<float>::quiet_NaN());
  for (int i = rng.integer(1, 4); i > 0; --i) {
    const double cx = rng.uniform(0, map.frame.width), cy = rng.uniform(0, map.frame.height);
    const double rx = rng.uniform(10, 0.3 * map.frame.width), ry = rng.uniform(10, 0.3 * map.frame.width);
    const bool disc = rng.chance(0.5);
    for (int y = 0; y < map.frame.height; ++y) {
      for (int x = 0; x < map.frame.width; ++x) {
        const double u = (x - cx) / rx, v = (y - cy) / ry;
        if (disc ? u * u + v * v > 1 : std::max(std::abs(u), std::abs(v)) > 1) continue;
        map.known_m(x, y) = mostly ? std::numeric_limits<float>::quiet_NaN() : crop.heights(x, y);
      }
    }
  }
}

/// Low ground and relief as somebody would state them, about right.
void draw_scale(const Crop& crop, Rng& rng, learned::SketchMap& map) {
  std::vector<float> sorted(crop.heights.cells().begin(), crop.heights.cells().end());
  const auto at = [&](double share) {
    const auto place = sorted.begin() + static_cast<int64_t>(share * static_cast<double>(sorted.size() - 1));
    std::nth_element(sorted.begin(), place, sorted.end());
    return static_cast<double>(*place);
  };
  const double low = at(0.01), high = at(0.995), relief = std::max(high - low, 1.0);
  map.relief_m = relief * rng.uniform(0.92, 1.15);
  map.low_m = low - rng.uniform(-0.03, 0.08) * relief;
}

}  // namespace

std::pair<float, float> Crop::placed(std::pair<float, float> cell) const {
  const auto last = static_cast<float>(heights.width() - 1);
  float x = cell.first - static_cast<float>(left), y = cell.second - static_cast<float>(top);
  if (transpose) std::swap(x, y);
  return {flip_x ? last - x : x, flip_y ? last - y : y};
}

std::optional<Crop> find_crop(const HeightField& tile, int size, double known, Rng& rng) {
  for (int attempt = 0; attempt < 20; ++attempt) {
    Crop crop;
    crop.left = rng.integer(0, tile.width() - size);
    crop.top = rng.integer(0, tile.height() - size);
    crop.flip_x = rng.chance(0.5);
    crop.flip_y = rng.chance(0.5);
    crop.transpose = rng.chance(0.5);
    crop.heights = HeightField(GridFrame::centred(size, size, tile.cell_m()));
    Grid<float> weight(crop.heights.frame(), 0.0F);
    crop.filled = Grid<uint8_t>(crop.heights.frame(), 0);
    int cells = 0;
    float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        int u = crop.flip_x ? size - 1 - x : x, v = crop.flip_y ? size - 1 - y : y;
        if (crop.transpose) std::swap(u, v);
        const float z = tile(crop.left + u, crop.top + v);
        crop.heights(x, y) = z;
        crop.filled(x, y) = std::isnan(z);
        if (std::isnan(z)) continue;
        weight(x, y) = 1;
        ++cells;
        low = std::min(low, z);
        high = std::max(high, z);
      }
    }
    if (cells < known * size * size || high - low < size * tile.cell_m() / 200) continue;
    if (cells < size * size) geom::pyramid_fill(crop.heights, weight, {.fade = 1.0F}, alone());
    return crop;
  }
  return std::nullopt;
}

learned::SketchMap scaled_map(const Crop& crop, Rng& rng) {
  learned::SketchMap map;
  map.frame = crop.heights.frame();
  draw_scale(crop, rng, map);
  return map;
}

Sample sketch_sample(const Crop& crop, const DrawnTile& drawn, Seed seed) {
  Rng rng(seed);
  learned::SketchMap map = scaled_map(crop, rng);
  const Mix mix = draw_mix(rng);
  const Shake shake(rng);
  if (mix.river) map.river = draw_lines(drawn.rivers, crop, mix, shake, rng);
  if (mix.ridge) map.ridge = draw_lines(drawn.ridges, crop, mix, shake, rng);
  if (mix.cue) draw_cues(drawn, crop, mix, shake, rng, map);
  if (mix.level) draw_level(crop, rng, map);
  if (mix.known != Mix::none) draw_known(crop, mix, rng, map);
  return sample_of(map, crop, seed.derive("noise"));
}

Sample sample_of(const learned::SketchMap& map, const Crop& crop, Seed noise) {
  const learned::SketchPlanes planes(map, noise, alone());
  Sample sample;
  sample.size = map.frame.width;
  const size_t cells = crop.heights.size();
  sample.planes.resize(cells * learned::kSketchPlanes);
  planes.planes().fill(0, map.frame.height, sample.planes);
  sample.base.assign(planes.base().cells().begin(), planes.base().cells().end());
  sample.target.resize(cells);
  sample.weight.assign(cells, 1.0F);
  for (size_t i = 0; i < cells; ++i) {
    sample.target[i] = static_cast<float>((crop.heights.data()[i] - map.low_m) / map.relief_m);
    if (crop.filled.data()[i] != 0) sample.weight[i] = 0;
  }
  if (map.known_m.empty()) return sample;
  // Known ground stays whatever the network says: only its rim counts. Where all of it counts, the network learns to
  // add nothing near it, and holes stay smooth.
  Grid<uint8_t> unknown(map.frame, 0);
  for (size_t i = 0; i < cells; ++i) unknown.data()[i] = std::isnan(map.known_m.data()[i]);
  const ScalarField from_unknown = geom::distance_to(unknown, alone());
  const auto rim = static_cast<float>(kRimCells * map.frame.cell_m);
  for (size_t i = 0; i < cells; ++i) {
    if (from_unknown.data()[i] > rim) sample.weight[i] = 0;
  }
  return sample;
}

}  // namespace seamount::train
