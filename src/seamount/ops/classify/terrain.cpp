#include "seamount/ops/classify/terrain.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/grid/surface.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/water/flat_sea.h"
#include "seamount/geom/water/inland.h"
#include "seamount/ops/classify/belt.h"
#include "seamount/ops/classify/exposure.h"
#include "seamount/ops/classify/patches.h"

namespace seamount::classify {
namespace {

constexpr int kLatticeSide = 1024;

void check_heights(const HeightField& terrain, const RunContext& run) {
  if (terrain.empty()) throw InvalidArgument("terrain", "has no cells");
  parallel_rows(run, terrain.width(), terrain.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (const float z : terrain.row(y)) {
        if (!std::isfinite(z))
          throw InvalidArgument("terrain", "row " + std::to_string(y) + " has a height that is no number");
      }
    }
  });
}

/// The terrain with a floor under a sea of unknown depth.
HeightField with_floor(HeightField out, double abyss_m, const RunContext& run) {
  const Grid<uint8_t> sea = geom::flat_sea(out, run);
  if (sea.empty()) return out;
  parallel_rows(run, out.width(), out.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < out.width(); ++x) {
        // Cells of the sea that touch land are 0 like it.
        if (out(x, y) == 0.0F) out(x, y) = static_cast<float>(-abyss_m - 1.0);
      }
    }
  });
  return out;
}

/// The highest ground in each lattice cell: thin reefs are not lost.
HeightField crests(const HeightField& terrain, const RunContext& run) {
  const int step = std::max(1, (std::max(terrain.width(), terrain.height()) + kLatticeSide - 1) / kLatticeSide);
  GridFrame lattice = terrain.frame();
  lattice.cell_m *= step;
  lattice.width = (terrain.width() + step - 1) / step;
  lattice.height = (terrain.height() + step - 1) / step;
  HeightField crest(lattice);
  parallel_rows(run, terrain.width(), lattice.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < lattice.width; ++x) {
        float highest = terrain(x * step, y * step);
        for (int j = y * step; j < std::min((y + 1) * step, terrain.height()); ++j) {
          for (int i = x * step; i < std::min((x + 1) * step, terrain.width()); ++i)
            highest = std::max(highest, terrain(i, j));
        }
        crest(x, y) = highest;
      }
    }
  });
  return crest;
}

/// What the sea is like on the lattice.
struct Sea {
  ScalarField exposure;
  ScalarField to_open;  ///< distance to exposed water deeper than bars
  ScalarField to_deep;  ///< distance to exposed water twice as deep as benches
  Grid<uint8_t> behind_belt;
};

Sea survey(const HeightField& terrain, const TerrainParams& params, const RunContext& run) {
  const HeightField crest = crests(terrain, run);
  const auto deeper = [&](double depth, const ScalarField* exposed) {
    Grid<uint8_t> cells(crest.frame());
    for (size_t i = 0; i < cells.size(); ++i) {
      cells.cells()[i] =
          crest.cells()[i] <= -depth && (exposed == nullptr || exposed->cells()[i] >= params.exposed) ? 1 : 0;
    }
    return cells;
  };
  Grid<uint8_t> barrier = deeper(params.bar_m, nullptr);
  for (uint8_t& cell : barrier.cells()) cell = cell == 0 ? 1 : 0;
  Sea sea;
  sea.exposure = exposure(barrier, params.fetch_m, run);
  sea.to_open = geom::distance_to(deeper(params.bar_m, &sea.exposure), run);
  sea.to_deep = geom::distance_to(deeper(2.0 * params.reef_depth_m, &sea.exposure), run);
  for (ScalarField* distance : {&sea.to_open, &sea.to_deep}) {
    for (float& d : distance->cells()) d = std::min(d, 1e9F);  // a number even where there is no such water
  }
  sea.behind_belt = behind_belt(
      crest,
      {.bar_m = params.bar_m, .platform_m = params.lagoon_depth_m, .gap_m = params.belt_gap_m, .open = params.exposed},
      run);
  return sea;
}

/// One place in the sea.
struct Water {
  float depth, exposed, to_open, to_deep;
  bool behind_belt;
};

Region water_label(const Water& w, const TerrainParams& p) {
  const bool sheltered = w.behind_belt || w.exposed < p.exposed;
  if (w.depth <= p.bar_m && w.to_open <= p.reef_width_m) return Region::reef;
  if (w.depth <= p.reef_depth_m) return !sheltered && w.to_deep <= p.reef_width_m ? Region::reef : Region::lagoon;
  return sheltered && w.depth <= p.lagoon_depth_m ? Region::lagoon : Region::abyss;
}

template <class Body>
void each_cell(const GridFrame& frame, const RunContext& run, Body&& body) {
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < frame.width; ++x) body(x, y);
    }
  });
}

/// The slope in front of the reef: exposed water from which the reef's edge is seen steeply enough.
void add_fore_reef(const HeightField& ground, const TerrainParams& params, LabelMap& labels, const RunContext& run) {
  Grid<uint8_t> reef(ground.frame());
  each_cell(ground.frame(), run, [&](int x, int y) { reef(x, y) = labels(x, y) == Region::reef ? 1 : 0; });
  const ScalarField distance = geom::distance_to(reef, run);
  const auto slope = static_cast<float>(std::tan(params.fore_reef_slope_deg * std::numbers::pi / 180.0));
  const auto foot = static_cast<float>(params.fore_reef_m), edge = static_cast<float>(params.reef_depth_m);
  each_cell(ground.frame(), run, [&](int x, int y) {
    const float depth = -ground(x, y);
    if (labels(x, y) == Region::abyss && depth <= foot &&
        depth - edge >= slope * (distance(x, y) - 2.0F * static_cast<float>(ground.cell_m())))
      labels(x, y) = Region::reef;
  });
}

}  // namespace

Classified terrain(const HeightField& terrain, const TerrainParams& params, const RunContext& run) {
  check_params(params);
  check_heights(terrain, run);
  const GridFrame& frame = terrain.frame();
  const HeightField ground = with_floor(geom::raise_inland(terrain, 0.0F, params.min_sea_m2, run),
                                        std::max(params.lagoon_depth_m, params.fore_reef_m), run);
  const Sea sea = survey(ground, params, run.part(0.0, 0.3));
  Grid<uint8_t> water(frame);
  each_cell(frame, run, [&](int x, int y) { water(x, y) = ground(x, y) <= 0.0F ? 1 : 0; });
  const ScalarField inland = geom::distance_to(water, run.part(0.3, 0.5));
  const ScalarField slope = geom::slope_deg(geom::at_scale(ground, params.scale_m, run), run);
  Classified out{LabelMap(frame), ScalarField(frame)};
  each_cell(frame, run.part(0.5, 0.7), [&](int x, int y) {
    const float z = ground(x, y);
    if (z > 0.0F) {
      const bool beach =
          z <= params.beach_m && inland(x, y) <= params.beach_width_m && slope(x, y) <= params.beach_slope_deg;
      out.labels(x, y) = beach ? Region::beach : Region::mountain;
      out.exposure(x, y) = 0.0F;
      return;
    }
    const GridFrame& lattice = sea.exposure.frame();
    const double column = lattice.column(frame.x(x)), row = lattice.row(frame.y(y));
    const auto read = [&](const ScalarField& field) { return geom::sample_bilinear(field, column, row); };
    const bool behind =
        sea.behind_belt.clamped(static_cast<int>(std::lround(column)), static_cast<int>(std::lround(row))) != 0;
    const Water place{-z, read(sea.exposure), read(sea.to_open), read(sea.to_deep), behind};
    out.exposure(x, y) = place.exposed;
    out.labels(x, y) = water_label(place, params);
  });
  add_fore_reef(ground, params, out.labels, run.part(0.7, 0.9));
  remove_patches(out.labels, static_cast<int64_t>(params.min_patch_m2 / (frame.cell_m * frame.cell_m)), run);
  return out;
}

}  // namespace seamount::classify
