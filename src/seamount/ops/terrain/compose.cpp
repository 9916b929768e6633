#include "seamount/ops/terrain/compose.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/grid/sample_rows.h"
#include "seamount/geom/grid/similarity.h"
#include "seamount/geom/scalar/blend.h"

namespace seamount::terrain {
namespace {

constexpr float kThinCoverage = 1e-4F;  // of the first terrain beyond its edge: it only counts where nothing else is

/// A terrain with the similarity that carries it to its place.
struct Placed {
  const HeightField* terrain = nullptr;
  geom::Similarity at;
  float raise = 0.0F;
};

double nth(const std::vector<double>& values, size_t i, double missing) {
  return i < values.size() ? values[i] : missing;
}

std::vector<Placed> place_terrains(const std::vector<const HeightField*>& terrains, const ComposeParams& params) {
  if (terrains.empty()) throw InvalidArgument("terrain", "there is nothing to compose");
  const size_t count = params.places.empty() ? terrains.size() : params.places.size();
  if (terrains.size() != 1 && count != terrains.size()) {
    throw InvalidArgument("places", format_number(static_cast<double>(count)) + " places for " +
                                        format_number(static_cast<double>(terrains.size())) + " terrains");
  }
  std::vector<Placed> placed;
  for (size_t i = 0; i < count; ++i) {
    const HeightField& terrain = *terrains[terrains.size() == 1 ? 0 : i];
    if (terrain.empty()) throw InvalidArgument("terrain", "has no cells");
    const GridFrame& own = terrain.frame();
    const Vec2 middle{own.west_m + 0.5 * own.width_m(), own.north_m - 0.5 * own.height_m()};
    const double turn = nth(params.turns_deg, i, 0.0) * std::numbers::pi / 180.0;
    placed.push_back({&terrain,
                      {.place = params.places.empty() ? middle : params.places[i],
                       .cosine = std::cos(turn),
                       .sine = std::sin(turn),
                       .scale = nth(params.scales, i, 1.0),
                       .origin = middle},
                      static_cast<float>(nth(params.raises_m, i, 0.0))});
  }
  return placed;
}

/// Terrains whose cells are much finer than the frame's, averaged to its cells.
std::vector<HeightField> average_finer(std::vector<Placed>& placed, double cell_m, const RunContext& run) {
  std::vector<HeightField> averaged(placed.size());
  for (size_t i = 0; i < placed.size(); ++i) {
    const GridFrame& own = placed[i].terrain->frame();
    const double cell = cell_m / placed[i].at.scale;
    if (cell < 1.5 * own.cell_m) continue;
    GridFrame coarse = own;
    coarse.cell_m = cell;
    coarse.width = std::max(1, static_cast<int>(std::ceil(own.width_m() / cell - 1e-6)));
    coarse.height = std::max(1, static_cast<int>(std::ceil(own.height_m() / cell - 1e-6)));
    averaged[i] = geom::resample(*placed[i].terrain, coarse, run);
    placed[i].terrain = &averaged[i];
  }
  return averaged;
}

/// How the edges of a placed grid fade: its last column and row, and 1 / feather in its cells (0: not at all).
struct Fade {
  float last_column, last_row, per_cell;
};

SEAMOUNT_VECTORISED void lay_over(const Fade fade, float scale, float raise, int count, const float* __restrict columns,
                                  const float* __restrict rows, const float* __restrict own, float* __restrict coverage,
                                  float* __restrict heights) {
  for (int i = 0; i < count; ++i) {
    const float across = columns[i] < fade.last_column - columns[i] ? columns[i] : fade.last_column - columns[i];
    const float along = rows[i] < fade.last_row - rows[i] ? rows[i] : fade.last_row - rows[i];
    const float inside = (across < along ? across : along) + 0.5F;
    const float w = fade.per_cell > 0.0F ? geom::smoothstep(inside * fade.per_cell) : 1.0F;
    const float below = (1.0F - w) * coverage[i];
    const float all = w + below;
    const float z = scale * own[i] + raise;
    heights[i] = w < 1.0F ? (all > 0.0F ? (w * z + below * heights[i]) / all : heights[i]) : z;
    coverage[i] = all;
  }
}

/// One row of the result, terrain over terrain.
class Row {
 public:
  Row(const GridFrame& frame, const ComposeParams& params)
      : frame_(frame), params_(params), places_(frame.width), own_(places_.columns.size()), coverage_(own_.size()) {}

  void compose(const std::vector<Placed>& placed, int y, std::span<float> heights) {
    std::fill(coverage_.begin(), coverage_.end(), params_.outside_m ? 1.0F : kThinCoverage);
    if (params_.outside_m) {
      std::fill(heights.begin(), heights.end(), static_cast<float>(*params_.outside_m));
    } else {
      const Placed& first = placed.front();
      places_.locate(first.at, first.terrain->frame(), frame_, y, true);
      geom::sample_bicubic_rows(*first.terrain, places_.columns, places_.rows, heights);
      for (float& z : heights) z = static_cast<float>(first.at.scale) * z + first.raise;
    }
    for (const Placed& p : placed) over(p, y, heights);
  }

 private:
  void over(const Placed& p, int y, std::span<float> heights) {
    const GridFrame& own = p.terrain->frame();
    places_.locate(p.at, own, frame_, y);
    if (places_.first >= places_.last) return;
    const auto from = static_cast<size_t>(places_.first);
    const auto count = static_cast<size_t>(places_.last - places_.first);
    geom::sample_bicubic_rows(*p.terrain, {&places_.columns[from], count}, {&places_.rows[from], count},
                              {&own_[from], count});
    const double feather_cells = params_.feather_m / (own.cell_m * p.at.scale);
    const Fade fade{static_cast<float>(own.width - 1), static_cast<float>(own.height - 1),
                    feather_cells > 0.0 ? static_cast<float>(1.0 / feather_cells) : 0.0F};
    lay_over(fade, static_cast<float>(p.at.scale), p.raise, static_cast<int>(count), &places_.columns[from],
             &places_.rows[from], &own_[from], &coverage_[from], &heights[from]);
  }

  const GridFrame& frame_;
  const ComposeParams& params_;
  geom::PlacedRow places_;
  std::vector<float> own_, coverage_;
};

}  // namespace

HeightField compose(const std::vector<const HeightField*>& terrains, const ComposeParams& params,
                    const GridFrame& frame, const RunContext& run) {
  check_params(params);
  std::vector<Placed> placed = place_terrains(terrains, params);
  const std::vector<HeightField> averaged = average_finer(placed, frame.cell_m, run.part(0.0, 0.3));
  HeightField out(frame);
  parallel_rows(run.part(0.3, 1.0), frame.width, frame.height, [&](int begin, int end) {
    Row row(frame, params);
    for (int y = begin; y < end; ++y) row.compose(placed, y, out.row(y));
  });
  return out;
}

}  // namespace seamount::terrain
