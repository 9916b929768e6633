#include "seamount/ops/sketch/extract.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/water/flow.h"
#include "seamount/geom/water/flow_invert.h"
#include "seamount/geom/water/inland.h"
#include "seamount/geom/water/skeleton.h"
#include "seamount/ops/sketch/stochastic_flow.h"

namespace seamount::sketch {
namespace {

/// A place where water, or what runs uphill, gathers and stays.
struct Cue {
  int x, y;  ///< of the coarse terrain
  bool basin;
};

/// What the rain on a coarse terrain shows, of one of the two networks.
struct Network {
  Grid<uint8_t> lines;
  std::vector<Cue> cues;
};

/// The terrain and what of it is land.
struct Ground {
  const HeightField& terrain;
  Mask land;  ///< 1 or 0; empty: all of it
  float sea;

  Ground(const HeightField& ground, const ExtractParams& params, const RunContext& run)
      : terrain(ground), sea(params.sea ? 0.0F : geom::kNoSea) {
    if (!params.sea) return;
    land = geom::raise_inland(terrain, sea, params.min_sea_m2, run);
    bool all = true;
    for (float& z : land.cells()) all = all && z > sea, z = z > sea ? 1.0F : 0.0F;
    if (all) land = {};
  }
  bool is_land(size_t cell) const { return land.empty() || land.data()[cell] != 0.0F; }
  double land_share() const {
    double cells = 0;
    for (const float one : land.cells()) cells += static_cast<double>(one);
    return land.empty() ? 1.0 : cells / static_cast<double>(land.size());
  }
};

struct Scale {
  double coarse_m, blur_m;
  uint32_t line_drops, cue_drops;
  int min_cells;  ///< of the terrain, for branches and pieces
};

Scale scale_of(const ExtractParams& params, const Ground& ground) {
  constexpr double kCoarseCells = 128.0, kBlur = 0.7, kLinePart = 500.0, kCuePart = 150.0;
  const GridFrame& frame = ground.terrain.frame();
  Scale scale{};
  scale.coarse_m =
      std::max(frame.cell_m, params.coarse_m.value_or(std::max(frame.width_m(), frame.height_m()) / kCoarseCells));
  scale.blur_m = params.blur_m.value_or(kBlur * scale.coarse_m);
  const double area_m2 = frame.width_m() * frame.height_m() * ground.land_share();
  const auto drops = [&](double from_m2) {
    return static_cast<uint32_t>(std::clamp(from_m2 / (scale.coarse_m * scale.coarse_m), 2.0, 4e9));
  };
  scale.line_drops = drops(params.min_area_m2.value_or(area_m2 / kLinePart));
  scale.cue_drops = drops(params.cue_area_m2.value_or(area_m2 / kCuePart));
  scale.min_cells = static_cast<int>(std::min(1e6, params.min_length * scale.coarse_m / frame.cell_m));
  return scale;
}

GridFrame coarse_frame(const GridFrame& frame, const Scale& scale) {
  GridFrame coarse = frame;
  coarse.cell_m = scale.coarse_m;
  coarse.width = std::max(1, static_cast<int>(std::lround(frame.width_m() / scale.coarse_m)));
  coarse.height = std::max(1, static_cast<int>(std::lround(frame.height_m() / scale.coarse_m)));
  return coarse;
}

/// Blurred, on cells of about coarse_m that fit the terrain's corner; the sea is level.
HeightField coarsen(const Ground& ground, const Scale& scale, const RunContext& run) {
  const GridFrame coarse = coarse_frame(ground.terrain.frame(), scale);
  const auto resampled = [&](const ScalarField& fine) {
    return coarse == fine.frame() ? fine : geom::resample(fine, coarse, run);
  };
  HeightField blurred = ground.terrain;
  if (ground.land.empty()) {
    geom::gaussian_blur(blurred, scale.blur_m, run);
    return resampled(blurred);
  }
  ScalarField share = ground.land;
  for (size_t i = 0; i < blurred.size(); ++i) blurred.data()[i] = ground.is_land(i) ? blurred.data()[i] : 0.0F;
  geom::gaussian_blur(blurred, scale.blur_m, run);
  geom::gaussian_blur(share, scale.blur_m, run);
  constexpr float kSome = 1e-3F;
  for (size_t i = 0; i < blurred.size(); ++i) {
    if (share.data()[i] > kSome) blurred.data()[i] /= share.data()[i];
  }
  HeightField out = resampled(blurred);
  const ScalarField land = resampled(ground.land);
  for (size_t i = 0; i < out.size(); ++i) {
    float& z = out.data()[i];
    z = land.data()[i] < 0.5F ? ground.sea : std::max(z, std::nextafter(ground.sea, INFINITY));
  }
  return out;
}

/// Reads `water`, whose cells lie `shift` further in, back onto the coarse terrain.
Network read_water(const Water& water, const GridFrame& coarse, int shift, bool basins, const Scale& scale) {
  Network network{Grid<uint8_t>(coarse), {}};
  for (int y = 0; y < coarse.height; ++y) {
    for (int x = 0; x < coarse.width; ++x) {
      network.lines(x, y) = water.passed(x + shift, y + shift) >= scale.line_drops ? 1 : 0;
      if (water.ended(x + shift, y + shift) >= scale.cue_drops) network.cues.push_back({x, y, basins});
    }
  }
  return network;
}

StochasticFlow flow_of(const ExtractParams& params, const HeightField& coarse, float sea) {
  constexpr double kReliefPart = 200.0;
  const auto [low, high] = std::minmax_element(coarse.cells().begin(), coarse.cells().end());
  const double relief = static_cast<double>(*high) - std::max(sea, *low);
  return {.leave = params.leave,
          .shallow_m = static_cast<float>(params.shallow_m.value_or(std::max(0.0, relief) / kReliefPart))};
}

Network find_rivers(const HeightField& coarse, float sea, const ExtractParams& params, const Scale& scale, Seed seed,
                    const RunContext& run) {
  Grid<uint8_t> land(coarse.frame());
  for (size_t i = 0; i < land.size(); ++i) land.data()[i] = coarse.data()[i] > sea ? 1 : 0;
  Network rivers = read_water(
      stochastic_flow(coarse, land, sea, geom::kFlowWall, flow_of(params, coarse, sea), seed.derive("rivers"), run),
      coarse.frame(), 0, true, scale);
  for (size_t i = 0; i < land.size(); ++i) rivers.lines.data()[i] &= land.data()[i];
  return rivers;
}

Network find_ridges(const HeightField& coarse, float sea, const ExtractParams& params, const Scale& scale, Seed seed,
                    const RunContext& run) {
  const HeightField inverted = geom::invert_with_walls(coarse, sea, run);
  Grid<uint8_t> land(inverted.frame());
  for (size_t i = 0; i < land.size(); ++i) land.data()[i] = inverted.data()[i] < geom::kFlowWall ? 1 : 0;
  Network ridges = read_water(stochastic_flow(inverted, land, geom::kNoSea, geom::kFlowWall,
                                              flow_of(params, coarse, sea), seed.derive("ridges"), run),
                              coarse.frame(), 1, false, scale);
  // The edge cuts slopes in two and makes ridges of them that are none.
  const GridFrame& frame = coarse.frame();
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      if (x == 0 || y == 0 || x == frame.width - 1 || y == frame.height - 1) ridges.lines(x, y) = 0;
    }
  }
  std::erase_if(ridges.cues, [&](const Cue& cue) {
    return cue.x == 0 || cue.y == 0 || cue.x == frame.width - 1 || cue.y == frame.height - 1;
  });
  return ridges;
}

/// Coarse lines as lines one cell wide on the terrain's land.
Grid<uint8_t> refine(const Grid<uint8_t>& lines, const Ground& ground, const Scale& scale, const RunContext& run) {
  constexpr float kInside = 0.33F;  // a diagonal of single cells has at least 0.45 along its middle
  const GridFrame& frame = ground.terrain.frame();
  ScalarField soft(lines.frame());
  for (size_t i = 0; i < soft.size(); ++i) soft.data()[i] = lines.data()[i];
  Grid<uint8_t> fine(frame);
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const double row = soft.frame().row(frame.y(y));
      for (int x = 0; x < frame.width; ++x)
        fine(x, y) = geom::sample_bspline(soft, soft.frame().column(frame.x(x)), row) > kInside ? 1 : 0;
    }
  });
  geom::thin(fine, run);
  for (size_t i = 0; i < fine.size(); ++i) fine.data()[i] = ground.is_land(i) ? fine.data()[i] : 0;
  geom::prune_skeleton(fine, scale.min_cells, scale.min_cells, run);
  return fine;
}

void add_lines(const Grid<uint8_t>& skeleton, double value, Drawing& drawing) {
  for (const geom::CellChain& chain : geom::trace_skeleton(skeleton)) {
    if (chain.size() < 2) continue;
    drawing.lines.push_back({geom::smooth_chain(chain, skeleton.frame()), value, false});
  }
}

Mask as_mask(const Grid<uint8_t>& cells) {
  Mask mask(cells.frame());
  for (size_t i = 0; i < mask.size(); ++i) mask.data()[i] = cells.data()[i];
  return mask;
}

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
Image paint(const Sketch& sketch, const HeightField& coarse) {
  const GridFrame& frame = sketch.river.frame();
  const auto [low, high] = std::minmax_element(coarse.cells().begin(), coarse.cells().end());
  const float range = std::max(1e-3F, *high - *low);
  Image image(frame.width, frame.height);
  const int radius = std::max(1, std::min(frame.width, frame.height) / 128);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      if (sketch.ridge(x, y) > 0.0F) image.pixel(x, y)[0] = 255;
      if (sketch.river(x, y) > 0.0F) image.pixel(x, y)[2] = 255;
      if (sketch.cue(x, y) <= 0.0F) continue;
      const float share = std::clamp((sketch.altitude_m(x, y) - *low) / range, 0.0F, 1.0F);
      const auto green = static_cast<uint8_t>(std::lround(1.0F + 254.0F * share));
      for (int v = std::max(0, y - radius); v <= std::min(frame.height - 1, y + radius); ++v) {
        for (int u = std::max(0, x - radius); u <= std::min(frame.width - 1, x + radius); ++u) {
          if ((u - x) * (u - x) + (v - y) * (v - y) <= radius * radius + 1) image.pixel(u, v)[1] = green;
        }
      }
    }
  }
  return image;
}

}  // namespace

Sketch extract(const HeightField& terrain, const ExtractParams& params, Seed seed, const RunContext& run) {
  check_params(params);
  const GridFrame& frame = terrain.frame();
  const Ground ground(terrain, params, run);
  const Scale scale = scale_of(params, ground);
  const HeightField coarse = coarsen(ground, scale, run.part(0.0, 0.2));
  const Network none{Grid<uint8_t>(coarse.frame(), 0), {}};
  const Network rivers =
      params.rivers || params.cues ? find_rivers(coarse, ground.sea, params, scale, seed, run.part(0.2, 0.5)) : none;
  const Network ridges =
      params.ridges || params.cues ? find_ridges(coarse, ground.sea, params, scale, seed, run.part(0.5, 0.8)) : none;
  Sketch sketch{{}, {}, ScalarField(frame, 0.0F), Mask(frame, 0.0F), {}, {}};
  sketch.lines.crs = frame.crs;
  const Grid<uint8_t> river = refine(params.rivers ? rivers.lines : none.lines, ground, scale, run.part(0.8, 0.9));
  const Grid<uint8_t> ridge = refine(params.ridges ? ridges.lines : none.lines, ground, scale, run.part(0.9, 1.0));
  add_lines(river, 0.0, sketch.lines);
  add_lines(ridge, 1.0, sketch.lines);
  sketch.river = as_mask(river);
  sketch.ridge = as_mask(ridge);
  if (params.cues) {
    add_cues(rivers.cues, coarse, sketch);
    add_cues(ridges.cues, coarse, sketch);
  }
  sketch.image = paint(sketch, coarse);
  return sketch;
}

}  // namespace seamount::sketch
