#include "seamount/ops/amplify/sparse.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/halve_cells.h"
#include "seamount/geom/grid/voids.h"
#include "seamount/geom/solve/fill_voids.h"
#include "seamount/ops/amplify/atom_detail.h"

namespace seamount::amplify {
namespace {

constexpr int64_t kMostCellsASide = 65536;
constexpr int64_t kMostCells = int64_t{1} << 30;
constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

int times(Factor factor) { return 2 << static_cast<int>(factor); }

void check_size(const GridFrame& frame, Factor factor) {
  const int64_t width = int64_t{frame.width} * times(factor), height = int64_t{frame.height} * times(factor);
  if (width <= kMostCellsASide && height <= kMostCellsASide && width * height <= kMostCells) return;
  throw InvalidArgument("factor", std::string(Choices<Factor>::names[static_cast<size_t>(factor)]) + " makes " +
                                      std::to_string(width) + " x " + std::to_string(height) +
                                      " cells; at most 65536 a side and 2^30 in all");
}

/// Each cell four times.
Grid<uint8_t> repeated(const Grid<uint8_t>& cells) {
  Grid<uint8_t> out(geom::halved_frame(cells.frame()));
  for (int y = 0; y < out.height(); ++y)
    for (int x = 0; x < out.width(); ++x) out(x, y) = cells(x / 2, y / 2);
  return out;
}

/// Takes detail off level cells, and fades it in over those beside them.
void fade_at_level(const Grid<uint8_t>& level, Grid<float>& detail, const RunContext& run) {
  // 0 at the corners of level cells; corner (x, y) is north-west of cell (x, y).
  const auto corner = [&](int x, int y) {
    const bool any =
        (level.clamped(x - 1, y - 1) | level.clamped(x, y - 1) | level.clamped(x - 1, y) | level.clamped(x, y)) != 0;
    return any ? 0.0F : 1.0F;
  };
  parallel_rows(run, detail.width(), level.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < level.width(); ++x) {
        const float nw = corner(x, y), ne = corner(x + 1, y), sw = corner(x, y + 1), se = corner(x + 1, y + 1);
        if (nw + ne + sw + se == 4.0F) continue;
        const auto blend = [](float most, float half_a, float half_b, float least) {
          return (9.0F * most + 3.0F * (half_a + half_b) + least) / 16.0F;
        };
        detail(2 * x, 2 * y) *= blend(nw, ne, sw, se);
        detail(2 * x + 1, 2 * y) *= blend(ne, nw, se, sw);
        detail(2 * x, 2 * y + 1) *= blend(sw, nw, se, ne);
        detail(2 * x + 1, 2 * y + 1) *= blend(se, ne, sw, nw);
      }
    }
  });
}

HeightField doubled(const HeightField& terrain, const Grid<uint8_t>* level, const AtomDetail& atoms,
                    const RunContext& run) {
  HeightField fine = atoms.of(terrain, run.part(0.0, 0.8));
  if (level != nullptr) fade_at_level(*level, fine, run.part(0.8, 0.82));
  Grid<float> rest = geom::means_of_four(fine, run.part(0.82, 0.85));
  for (size_t i = 0; i < rest.size(); ++i) rest.data()[i] = terrain.data()[i] - rest.data()[i];
  geom::add_halved_cells(rest, level, fine, run.part(0.85, 1.0));
  return fine;
}

/// 1 if a cell and all known ones around it are land, -1 if all are sea, 0 where a coast may be. Unknown: 0.
int side_of(const HeightField& terrain, int x, int y) {
  int land = 0, sea = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const float z = terrain.clamped(x + dx, y + dy);
      if (z > 0.0F) ++land;
      if (z <= 0.0F) ++sea;
    }
  }
  if (std::isnan(terrain(x, y)) || (land > 0 && sea > 0)) return 0;
  return land > 0 ? 1 : -1;
}

/// Draws the cells of a block towards its mean as far as it takes to have them on one side of sea level.
void keep_side(HeightField& fine, int x0, int y0, int n, float mean, int side) {
  float worst = static_cast<float>(side) * mean;
  for (int y = y0; y < y0 + n; ++y)
    for (int x = x0; x < x0 + n; ++x) worst = std::min(worst, static_cast<float>(side) * fine(x, y));
  const float above = static_cast<float>(side) * mean;
  if (worst > 0.0F || (side < 0 && worst == 0.0F)) return;
  constexpr float kLeft = 0.9375F;  // of the height over sea level may be used up
  const float share = above > worst ? kLeft * above / (above - worst) : 0.0F;
  for (int y = y0; y < y0 + n; ++y)
    for (int x = x0; x < x0 + n; ++x) fine(x, y) = mean + share * (fine(x, y) - mean);
}

/// What holds for whole cells of the terrain: unknown ones stay so, and land and sea keep their sides.
void settle_cells(const HeightField& terrain, int factor, HeightField& fine, const RunContext& run) {
  parallel_rows(run, fine.width(), terrain.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < terrain.width(); ++x) {
        const float mean = terrain(x, y);
        if (std::isnan(mean)) {
          for (int fy = y * factor; fy < (y + 1) * factor; ++fy)
            std::fill_n(fine.row(fy).begin() + x * factor, factor, kUnknown);
        } else if (const int side = side_of(terrain, x, y); side != 0) {
          keep_side(fine, x * factor, y * factor, factor, mean, side);
        }
      }
    }
  });
}

}  // namespace

HeightField sparse(const HeightField& terrain, const Dictionary& dictionary, const SparseParams& params,
                   const RunContext& run) {
  check_params(params);
  if (terrain.empty()) throw InvalidArgument("terrain", "has no cells");
  if (dictionary.shapes.empty()) throw InvalidArgument("dictionary", "has no atoms");
  check_size(terrain.frame(), params.factor);
  const int factor = times(params.factor);
  HeightField made = terrain;
  if (const int64_t voids = geom::count_voids(made, run.part(0.0, 0.01)); voids == terrain.frame().cells()) {
    GridFrame frame = terrain.frame();
    for (int done = 1; done < factor; done *= 2) frame = geom::halved_frame(frame);
    return HeightField(frame, kUnknown);
  } else if (voids > 0) {
    geom::fill_voids(made, run.part(0.01, 0.02));
  }
  Grid<uint8_t> level = geom::level_cells(made, run.part(0.02, 0.03));
  const bool any_level = std::find(level.cells().begin(), level.cells().end(), 1) != level.cells().end();
  const AtomDetail atoms(dictionary, params.strength);
  for (int done = 1; done < factor; done *= 2) {
    const double from = 0.03 + 0.92 * (done * done - 1.0) / (factor * factor - 1.0);
    const double to = 0.03 + 0.92 * (4.0 * done * done - 1.0) / (factor * factor - 1.0);
    if (done > 1 && any_level) level = repeated(level);
    made = doubled(made, any_level ? &level : nullptr, atoms, run.part(from, to));
  }
  settle_cells(terrain, factor, made, run.part(0.95, 1.0));
  return made;
}

}  // namespace seamount::amplify
