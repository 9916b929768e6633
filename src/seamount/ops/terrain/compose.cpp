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
#include "seamount/geom/grid/voids.h"
#include "seamount/geom/scalar/blend.h"
#include "seamount/model/extent.h"
#include "seamount/model/sample_known.h"

namespace seamount::terrain {
namespace {

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

void check_all_meet(const std::vector<const HeightField*>& terrains, const GridFrame& frame) {
  for (size_t i = 0; i < terrains.size(); ++i) {
    const Extent own = Extent::of(terrains[i]->frame()), whole = Extent::of(frame);
    if (own.overlaps(whole)) continue;
    throw IncompatibleInputs("terrain" + (i == 0 ? std::string() : "_" + std::to_string(i + 1)) +
                             ": lies nowhere on the domain: " + extent_text(own) +
                             "; the domain: " + extent_text(whole));
  }
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
    const float fading = fade.per_cell > 0.0F ? geom::smoothstep(inside * fade.per_cell) : 1.0F;
    const bool known = own[i] == own[i];
    const float w = known ? fading : 0.0F;
    const float below = (1.0F - w) * coverage[i];
    const float all = w + below;
    const float z = known ? scale * own[i] + raise : 0.0F;
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
    std::fill(coverage_.begin(), coverage_.end(), params_.outside_m ? 1.0F : 0.0F);
    std::fill(heights.begin(), heights.end(), static_cast<float>(params_.outside_m.value_or(0.0)));
    for (const Placed& p : placed) over(p, y, heights);
    for (size_t i = 0; i < heights.size(); ++i)
      if (!(coverage_[i] > 0.0F)) heights[i] = std::numeric_limits<float>::quiet_NaN();
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
    const bool holes = geom::any_void({&own_[from], count});
    for (size_t i = from; holes && i < from + count; ++i)
      if (std::isnan(own_[i])) own_[i] = sample_known(*p.terrain, places_.columns[i], places_.rows[i]);
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

GridFrame frame_around(const std::vector<const HeightField*>& terrains) {
  constexpr double kMostASide = 65536, kMostCells = 1 << 30, kRounding = 1e-6;
  GridFrame frame = terrains.front()->frame();
  Extent all = Extent::of(frame);
  for (const HeightField* terrain : terrains) all.include(Extent::of(terrain->frame()));
  const double west = std::ceil((frame.west_m - all.west) / frame.cell_m - kRounding);
  const double north = std::ceil((all.north - frame.north_m) / frame.cell_m - kRounding);
  frame.west_m -= west * frame.cell_m;
  frame.north_m += north * frame.cell_m;
  const double columns = std::ceil((all.east - frame.west_m) / frame.cell_m - kRounding);
  const double rows = std::ceil((frame.north_m - all.south) / frame.cell_m - kRounding);
  if (columns > kMostASide || rows > kMostASide || columns * rows > kMostCells)
    throw InvalidArgument("terrain", "all of them cover " + extent_text(all) + ", " + format_number(columns) + " x " +
                                         format_number(rows) + " cells of the first one's " +
                                         format_number(frame.cell_m) + " m; at most 65536 a side and 2^30 in all");
  frame.width = static_cast<int>(columns);
  frame.height = static_cast<int>(rows);
  return frame;
}

Reach compose_reach(const ComposeParams& params) {
  if (params.places.empty())
    return Reach::everything(
        "terrains that lie where they lie decide how large it is; places put them into the domain");
  if (!params.outside_m) return Reach::everything("ground without a terrain is counted; outside_m gives it a height");
  return Reach::place();
}

HeightField compose(const std::vector<const HeightField*>& terrains, const ComposeParams& params,
                    const GridFrame& frame, const RunContext& run) {
  check_params(params);
  std::vector<Placed> placed = place_terrains(terrains, params);
  if (params.places.empty()) check_all_meet(terrains, frame);
  const std::vector<HeightField> averaged = average_finer(placed, frame.cell_m, run.part(0.0, 0.3));
  HeightField out(frame);
  parallel_rows(run.part(0.3, 1.0), frame.width, frame.height, [&](int begin, int end) {
    Row row(frame, params);
    for (int y = begin; y < end; ++y) row.compose(placed, y, out.row(y));
  });
  const auto unknown = std::count_if(out.cells().begin(), out.cells().end(), [](float z) { return std::isnan(z); });
  if (unknown > 0) {
    run.say(std::to_string(unknown) + " of " + std::to_string(out.size()) +
            " cells stay unknown: no terrain has a height there, and outside_m is not given");
  }
  return out;
}

}  // namespace seamount::terrain
