#include "seamount/ops/sketch/extract.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "seamount/base/parallel.h"
#include "seamount/geom/water/flow.h"
#include "seamount/geom/water/flow_invert.h"
#include "seamount/geom/water/inland.h"
#include "seamount/ops/sketch/courses.h"
#include "seamount/ops/sketch/ground.h"
#include "seamount/ops/sketch/ink.h"
#include "seamount/ops/sketch/stochastic_flow.h"
#include "seamount/ops/sketch/strokes.h"

namespace seamount::sketch {
namespace {

/// A place where water, or what runs uphill, gathers and stays.
struct Cue {
  int x, y;  ///< of the coarse terrain
  bool basin;
};

/// What the rain on a coarse terrain shows, of one of the two networks.
struct Network {
  Inked inked;
  std::vector<Cue> cues;
};

struct Scale {
  double coarse_m, blur_m;
  double line_cells, cue_cells;  ///< of rain, coarse
};

Scale scale_of(const ExtractParams& params, const GridFrame& frame) {
  constexpr double kCoarseCells = 128.0, kBlur = 0.7;
  Scale scale{};
  scale.coarse_m =
      std::max(frame.cell_m, params.coarse_m.value_or(std::max(frame.width_m(), frame.height_m()) / kCoarseCells));
  scale.blur_m = params.blur_m.value_or(kBlur * scale.coarse_m);
  return scale;
}

void set_thresholds(const ExtractParams& params, const Ground& ground, Scale& scale) {
  constexpr double kLinePart = 500.0, kCuePart = 150.0;
  const GridFrame& frame = ground.heights.frame();
  const double area_m2 = frame.width_m() * frame.height_m() * ground.land_share();
  const auto cells = [&](double from_m2) { return std::max(2.0, from_m2 / (scale.coarse_m * scale.coarse_m)); };
  scale.line_cells = cells(params.min_area_m2.value_or(area_m2 / kLinePart));
  scale.cue_cells = cells(params.cue_area_m2.value_or(area_m2 / kCuePart));
}

GridFrame coarse_frame(const GridFrame& frame, const Scale& scale) {
  GridFrame coarse = frame;
  coarse.cell_m = scale.coarse_m;
  coarse.width = std::max(1, static_cast<int>(std::lround(frame.width_m() / scale.coarse_m)));
  coarse.height = std::max(1, static_cast<int>(std::lround(frame.height_m() / scale.coarse_m)));
  return coarse;
}

/// The step in which heights were rounded: whole metres, say. Heights that were resampled have none to speak of.
double rounding_of(const HeightField& terrain) {
  float least = std::numeric_limits<float>::infinity();
  for (int y = 0; y < terrain.height(); ++y) {
    const auto row = terrain.row(y);
    for (size_t x = 0; x + 1 < row.size(); ++x)
      if (const float step = std::abs(row[x] - row[x + 1]); step > 0.0F) least = std::min(least, step);
  }
  return std::isfinite(least) ? static_cast<double>(least) : 0.0;
}

/// Relief that is none: of pits, and of valleys and crests, which on small cells have less of it.
struct Flat {
  double pit_m, side_m;
};

Flat flat_of(const ExtractParams& params, const HeightField& terrain, const HeightField& coarse, float sea) {
  constexpr double kReliefPart = 200.0, kSideSlope = 0.05, kLeastSlope = 0.01, kMostOfSlope = 10.0, kRoundings = 2.0;
  if (params.shallow_m) return {*params.shallow_m, *params.shallow_m};
  const auto [low, high] = std::minmax_element(coarse.cells().begin(), coarse.cells().end());
  const double relief = static_cast<double>(*high) - static_cast<double>(std::max(sea, *low));
  const double least =
      std::max(std::min(kMostOfSlope, kLeastSlope * coarse.cell_m()), kRoundings * rounding_of(terrain));
  const double part = relief / kReliefPart;
  return {std::max(part, least), std::max(std::min(part, kSideSlope * coarse.cell_m()), least)};
}

/// Where a pit of the coarse terrain is one of the terrain too, and not of the blur that dams gorges.
Grid<uint8_t> find_basins(const Ground& ground, const GridFrame& coarse, double flat_m, const RunContext& run) {
  const HeightField filled = geom::fill_depressions(ground.heights, ground.sea_m, run);
  Grid<uint8_t> deep(coarse, 0), near(coarse, 0);
  const GridFrame& frame = filled.frame();
  for (int y = 0; y < frame.height; ++y) {
    const int row = std::clamp(static_cast<int>(std::lround(coarse.row(frame.y(y)))), 0, coarse.height - 1);
    for (int x = 0; x < frame.width; ++x) {
      if (!(static_cast<double>(filled(x, y) - ground.heights(x, y)) > flat_m)) continue;
      deep(std::clamp(static_cast<int>(std::lround(coarse.column(frame.x(x)))), 0, coarse.width - 1), row) = 1;
    }
  }
  for (int y = 0; y < coarse.height; ++y)
    for (int x = 0; x < coarse.width; ++x)
      for (int v = std::max(0, y - 1); v <= std::min(coarse.height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(coarse.width - 1, x + 1); ++u) near(x, y) |= deep(u, v);
  return near;
}

/// Coarse cells on the edge of what is known, which cuts slopes in two and makes ridges of them that are none.
Grid<uint8_t> find_rims(const Ground& ground, const GridFrame& coarse) {
  constexpr int kReach = 2;
  Grid<uint8_t> rims(coarse, 0);
  const GridFrame& frame = ground.heights.frame();
  const auto mark = [&](int x, int y) {
    for (int v = std::max(0, y - kReach); v <= std::min(coarse.height - 1, y + kReach); ++v)
      for (int u = std::max(0, x - kReach); u <= std::min(coarse.width - 1, x + kReach); ++u) rims(u, v) = 1;
  };
  for (int y = 0; y < frame.height && !ground.land.empty(); ++y) {
    const int row = static_cast<int>(std::lround(coarse.row(frame.y(y))));
    for (int x = 0; x < frame.width; ++x)
      if (ground.heights(x, y) == geom::kUnknownGround)
        mark(static_cast<int>(std::lround(coarse.column(frame.x(x)))), row);
  }
  for (int y = 0; y < coarse.height; ++y)
    for (int x = 0; x < coarse.width; ++x)
      if (x == 0 || y == 0 || x == coarse.width - 1 || y == coarse.height - 1) rims(x, y) = 1;
  return rims;
}

/// Where most drops of a coarse terrain stay, `shift` cells further in. A place that hardly differs from its
/// surroundings is none.
std::vector<Cue> find_cues(const Water& water, const HeightField& coarse, int shift, bool basins, const Scale& scale,
                           double flat_m) {
  constexpr int kReach = 3;
  constexpr double kStandsOut = 2.0;
  std::vector<Cue> cues;
  for (int y = 0; y < coarse.height(); ++y) {
    for (int x = 0; x < coarse.width(); ++x) {
      if (water.ended(x + shift, y + shift) < scale.cue_cells) continue;
      float most = 0.0F;
      for (int v = -kReach; v <= kReach; ++v)
        for (int u = -kReach; u <= kReach; ++u)
          most = std::max(most, std::abs(coarse.clamped(x + u, y + v) - coarse(x, y)));
      if (static_cast<double>(most) >= kStandsOut * flat_m) cues.push_back({x, y, basins});
    }
  }
  return cues;
}

struct Sketcher {
  const ExtractParams& params;
  const Ground& ground;
  const HeightField& coarse;
  const Scale& scale;
  Flat flat;
  Seed seed;

  StochasticFlow flow() const { return {.leave = params.leave, .shallow_m = static_cast<float>(flat.pit_m)}; }
  CourseParams courses() const {
    return {.least_cells = scale.line_cells,
            .flat_m = flat.pit_m,
            .stands_out_m = flat.side_m,
            .least_length = params.min_length,
            .leave = params.leave,
            .basin_cells = scale.cue_cells};
  }

  Inked draw(const Courses& courses, bool ridges, const RunContext& run) const {
    std::vector<Vec2> ends;
    for (const int32_t cell : courses.basins) {
      const int32_t x = cell % coarse.width(), y = cell / coarse.width();
      ends.push_back({coarse.frame().x(x), coarse.frame().y(y)});
    }
    return ink(draw_strokes(courses, coarse, ground, ridges, flat.side_m), ground, !ridges, ends, 1.5 * scale.coarse_m,
               scale.coarse_m, run);
  }

  Network rivers(const RunContext& run) const {
    Grid<uint8_t> land(coarse.frame());
    for (size_t i = 0; i < land.size(); ++i) land.data()[i] = coarse.data()[i] > ground.sea_m ? 1 : 0;
    const Water water =
        stochastic_flow(coarse, land, ground.sea_m, geom::kFlowWall, flow(), seed.derive("rivers"), run);
    Network out{{}, find_cues(water, coarse, 0, true, scale, flat.pit_m)};
    CourseParams way = courses();
    way.basins = find_basins(ground, coarse.frame(), flat.pit_m, run);
    const Courses found =
        find_courses({coarse, land, water.passed, ground.sea_m, geom::kFlowWall, coarse, 0, false}, way, run);
    for (const int32_t cell : found.basins) {
      const int x = cell % coarse.width(), y = cell / coarse.width();
      if (std::none_of(out.cues.begin(), out.cues.end(), [&](const Cue& cue) { return cue.x == x && cue.y == y; }))
        out.cues.push_back({x, y, true});
    }
    out.inked = draw(found, false, run);
    return out;
  }

  Network ridges(const RunContext& run) const {
    const HeightField inverted = geom::invert_with_walls(coarse, ground.sea_m, run);
    Grid<uint8_t> land(inverted.frame());
    for (size_t i = 0; i < land.size(); ++i) land.data()[i] = inverted.data()[i] < geom::kFlowWall ? 1 : 0;
    const Water water =
        stochastic_flow(inverted, land, geom::kNoSea, geom::kFlowWall, flow(), seed.derive("ridges"), run);
    Network out{{}, find_cues(water, coarse, 1, false, scale, flat.pit_m)};
    CourseParams way = courses();
    way.rims = find_rims(ground, coarse.frame());
    std::erase_if(out.cues, [&](const Cue& cue) { return way.rims(cue.x, cue.y) != 0; });
    const Courses found =
        find_courses({inverted, land, water.passed, geom::kNoSea, geom::kFlowWall, coarse, 1, true}, way, run);
    out.inked = draw(found, true, run);
    return out;
  }

  /// Those that are asked for, side by side: much of each is one thread's work.
  std::array<Network, 2> both(bool rivers_too, bool ridges_too, const RunContext& run) const {
    std::array<Network, 2> out;
    RunContext silent = run;  // of two at once
    silent.progress = nullptr;
    parallel_blocks(run, 2, 1, [&](int64_t begin, int64_t) {
      if (begin == 0 && rivers_too) out[0] = rivers(silent);
      if (begin == 1 && ridges_too) out[1] = ridges(silent);
    });
    return out;
  }
};

/// The cell of `frame` in which the middle of a coarse cell lies, and its height on the coarse terrain.
void add_cues(const std::vector<Cue>& cues, const HeightField& coarse, Sketch& sketch) {
  const GridFrame& frame = sketch.cue.frame();
  for (const Cue& cue : cues) {
    const Vec2 place{coarse.frame().x(cue.x), coarse.frame().y(cue.y)};
    const auto height = static_cast<double>(coarse(cue.x, cue.y));
    const int x = std::clamp(static_cast<int>(std::lround(frame.column(place.x))), 0, frame.width - 1);
    const int y = std::clamp(static_cast<int>(std::lround(frame.row(place.y))), 0, frame.height - 1);
    sketch.cue(x, y) = 1.0F;
    sketch.altitude_m(x, y) = static_cast<float>(height);
    sketch.lines.points.push_back({place, height, {{"basin", cue.basin ? 1.0 : 0.0}}});
  }
}

/// P1's colours; cues are discs so that one can see them.
Image paint(const Sketch& sketch) {
  const GridFrame& frame = sketch.river.frame();
  Image image(frame.width, frame.height);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      if (sketch.ridge(x, y) > 0.0F) image.pixel(x, y)[0] = 255;
      if (sketch.river(x, y) > 0.0F) image.pixel(x, y)[2] = 255;
    }
  }
  const int radius = std::max(1, std::min(frame.width, frame.height) / 128);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      if (sketch.cue(x, y) <= 0.0F) continue;
      const uint8_t green =
          green_of(static_cast<double>(sketch.altitude_m(x, y)), sketch.lowest_cue_m, sketch.highest_cue_m);
      for (int v = std::max(0, y - radius); v <= std::min(frame.height - 1, y + radius); ++v)
        for (int u = std::max(0, x - radius); u <= std::min(frame.width - 1, x + radius); ++u)
          if ((u - x) * (u - x) + (v - y) * (v - y) <= radius * radius + 1) image.pixel(u, v)[1] = green;
    }
  }
  return image;
}

/// The height of each cue's colour is known from its point.
void colour_cues(Sketch& sketch) {
  if (sketch.lines.points.empty()) return;
  const auto [low, high] =
      std::minmax_element(sketch.lines.points.begin(), sketch.lines.points.end(),
                          [](const ValuedPoint& a, const ValuedPoint& b) { return a.value < b.value; });
  sketch.lowest_cue_m = low->value;
  sketch.highest_cue_m = high->value;
  for (ValuedPoint& cue : sketch.lines.points)
    cue.attributes.push_back(
        {"green", static_cast<double>(green_of(cue.value, sketch.lowest_cue_m, sketch.highest_cue_m))});
}

void add_lines(std::vector<Polyline> lines, double value, Drawing& drawing) {
  for (Polyline& line : lines) drawing.lines.push_back({std::move(line), value, false});
}

}  // namespace

uint8_t green_of(double height_m, double lowest_m, double highest_m) {
  constexpr double kLowest = 32.0, kHighest = 255.0;
  const double share = highest_m > lowest_m ? (height_m - lowest_m) / (highest_m - lowest_m) : 1.0;
  return static_cast<uint8_t>(std::lround(kLowest + (kHighest - kLowest) * std::clamp(share, 0.0, 1.0)));
}

Sketch extract(const HeightField& terrain, const ExtractParams& params, Seed seed, const RunContext& run) {
  check_params(params);
  const GridFrame& frame = terrain.frame();
  Scale scale = scale_of(params, frame);
  const Ground ground = find_ground(terrain, params.sea, params.min_sea_m2, run.part(0.0, 0.1));
  set_thresholds(params, ground, scale);
  const HeightField coarse = blurred_land(ground, scale.blur_m, coarse_frame(frame, scale), run.part(0.1, 0.2));
  const Sketcher sketcher{params, ground, coarse, scale, flat_of(params, terrain, coarse, ground.sea_m), seed};
  Sketch sketch{Mask(frame, 0.0F), Mask(frame, 0.0F), ScalarField(frame, 0.0F), Mask(frame, 0.0F), {}, {}, 0.0, 0.0};
  sketch.lines.crs = frame.crs;
  std::array<Network, 2> networks =
      sketcher.both(params.rivers || params.cues, params.ridges || params.cues, run.part(0.2, 1.0));
  auto& [rivers, ridges] = networks;
  if (params.cues) add_cues(rivers.cues, coarse, sketch);
  if (params.rivers) {
    sketch.river = std::move(rivers.inked.cells);
    add_lines(std::move(rivers.inked.lines), 0.0, sketch.lines);
  }
  if (params.cues) add_cues(ridges.cues, coarse, sketch);
  if (params.ridges) {
    sketch.ridge = std::move(ridges.inked.cells);
    add_lines(std::move(ridges.inked.lines), 1.0, sketch.lines);
  }
  colour_cues(sketch);
  sketch.image = paint(sketch);
  return sketch;
}

}  // namespace seamount::sketch
