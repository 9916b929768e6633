#include "seamount/geom/solve/transport_level.h"

#include <algorithm>

#include "seamount/geom/solve/transport_stencil.h"

namespace seamount::geom::transport {
namespace {

/// What flows between two coarse cells, of what the fine faces between them let through.
struct Exchange {
  float in = 0.0F, out = 0.0F;

  /// The part that goes both ways is diffusion, which the larger distance makes slower.
  void slow_down(float factor) {
    const float both = (1.0F - factor) * std::min(in, out);
    in -= both;
    out -= both;
  }
};

inline float weight_of(const float* weights, size_t i) { return weights != nullptr ? weights[i] : 1.0F; }

/// Adds the face between fine cell i and its neighbour at i + step; `in` flows to i.
template <bool kEast>
inline void add_face(const Level& fine, const float* weights, size_t i, size_t step, Exchange& face) {
  const Cell& here = fine.cells[i];
  const Cell& there = fine.cells[i + step];
  face.in += (kEast ? here.east : here.south) * here.diagonal * weight_of(weights, i + step);
  face.out += (kEast ? there.west : there.north) * there.diagonal * weight_of(weights, i);
}

void sum_losses(const Level& fine, const float* weights, float wall_share, Level& coarse) {
  for (int y = 0; y < coarse.height; ++y) {
    for (int x = 0; x < coarse.width; ++x) {
      const size_t to = coarse.at(x, y);
      float loss = 0.0F, wall = 0.0F;
      for (int k = 0; k < 4; ++k) {
        const size_t i = fine.at(2 * x + k % 2, 2 * y + k / 2);
        const float weight = weight_of(weights, i);
        loss += weight * (fine.cells[i].loss - fine.wall[i]);
        wall += weight * wall_share * fine.wall[i];
      }
      Cell& cell = coarse.cells[to];
      coarse.wall[to] = wall;
      cell.loss = cell.diagonal = loss + wall;
    }
  }
}

std::vector<float> pair_sums(const std::vector<float>& fine) {
  std::vector<float> sums((fine.size() + 1) / 2, 0.0F);
  for (size_t i = 0; i < fine.size(); ++i) sums[i / 2] += fine[i];
  return sums;
}

/// How much longer the way between two neighbours' middles is on the coarse level: the fine one's share of it.
std::vector<float> nearness(const std::vector<float>& fine, const std::vector<float>& coarse) {
  std::vector<float> shares(coarse.size(), 1.0F);
  for (size_t i = 0; i + 1 < coarse.size(); ++i)
    shares[i] = (fine[2 * i + 1] + fine[2 * i + 2]) / (coarse[i] + coarse[i + 1]);
  return shares;
}

inline float residual(const Cell* cell, std::ptrdiff_t stride) {
  const float links = ((cell->west * cell[-1].value + cell->east * cell[1].value) + cell->north * cell[-stride].value) +
                      cell->south * cell[stride].value;
  return cell->diagonal * ((cell->right - cell->value) + links);
}

/// Coarse right-hand sides as the sums of value(fine cell) over 2 x 2 cells. The ring around the fine level has
/// diagonal 0.
template <class Value>
void restrict_sums(const Level& fine, Level& coarse, Value value) {
  for (int y = 0; y < coarse.height; ++y) {
    Cell* to = coarse.row(y);
    const Cell* upper = fine.row(2 * y);
    const Cell* lower = upper + fine.stride;
    const bool both = 2 * y + 1 < fine.height;
    for (int x = 0; x < coarse.width; ++x) {
      const bool pair = 2 * x + 1 < fine.width;
      float sum = value(upper + 2 * x);
      if (pair) sum += value(upper + 2 * x + 1);
      if (both) sum += value(lower + 2 * x);
      if (both && pair) sum += value(lower + 2 * x + 1);
      to[x].right = to[x].diagonal > 0.0F ? sum / to[x].diagonal : 0.0F;
    }
  }
}

/// Calls put(fine cell, its index, coarse value).
template <class Put>
void for_children(const Level& coarse, Level& fine, Put put) {
  for (int y = 0; y < fine.height; ++y) {
    const Cell* from = coarse.row(y / 2);
    const size_t first = fine.at(0, y);
    for (int x = 0; x < fine.width; ++x)
      put(fine.cells[first + static_cast<size_t>(x)], first + static_cast<size_t>(x), from[x / 2].value);
  }
}

}  // namespace

Level::Level(int width_, int height_)
    : width(width_),
      height(height_),
      stride(width_ + 3),
      cells(static_cast<size_t>(stride) * static_cast<size_t>(height_ + 3), Cell{}),
      wall(cells.size(), 0.0F) {}

Level assemble(const Transport& transport, double scale, float source_scale) {
  const ScalarField& source = *transport.source;
  const Stencils<float> stencils(transport, scale);
  const int width = source.width(), height = source.height();
  Level level(width, height);
  level.column_width.assign(static_cast<size_t>(width), 1.0F);
  level.row_height.assign(static_cast<size_t>(height), 1.0F);
  const auto decay = static_cast<float>(scale * transport.decay_per_s);
  const auto source_rate = static_cast<float>(scale) * source_scale;
  const float spread = stencils.spread();
  for (int y = 0; y < height; ++y) {
    Cell* row = level.row(y);
    for (int x = 0; x < width; ++x) {
      Stencil<float> s = stencils.at(x, y);
      Cell& cell = row[x];
      cell.diagonal = decay + ((s.west_out + s.east_out) + (s.north_out + s.south_out));
      cell.loss = decay;
      float entering = 0.0F;
      if (x == 0 || y == 0 || x == width - 1 || y == height - 1) {
        const auto open = [&](bool at_border, float& in, float out) {
          if (!at_border) return;
          cell.loss += out;
          level.wall[level.at(x, y)] += spread;
          if (transport.around != nullptr) entering += in * (*transport.around)(x, y);
          in = 0.0F;
        };
        open(x == 0, s.west_in, s.west_out);
        open(x == width - 1, s.east_in, s.east_out);
        open(y == 0, s.north_in, s.north_out);
        open(y == height - 1, s.south_in, s.south_out);
      }
      const float inverse = cell.diagonal > 0.0F ? 1.0F / cell.diagonal : 0.0F;
      cell.west = s.west_in * inverse;
      cell.east = s.east_in * inverse;
      cell.north = s.north_in * inverse;
      cell.south = s.south_in * inverse;
      cell.right = (source_rate * source(x, y) + source_scale * entering) * inverse;
    }
  }
  return level;
}

void coarsen(const Level& fine, const float* weights, float wall_share, Level& coarse) {
  coarse.column_width = pair_sums(fine.column_width);
  coarse.row_height = pair_sums(fine.row_height);
  const std::vector<float> across = nearness(fine.column_width, coarse.column_width);
  const std::vector<float> down = nearness(fine.row_height, coarse.row_height);
  const auto stride = static_cast<size_t>(fine.stride);
  sum_losses(fine, weights, wall_share, coarse);
  for (int y = 0; y < coarse.height; ++y) {
    for (int x = 0; x < coarse.width; ++x) {
      Cell* here = &coarse.cells[coarse.at(x, y)];
      Exchange east, south;  // over the grid's edge both are 0
      add_face<true>(fine, weights, fine.at(2 * x + 1, 2 * y), 1, east);
      add_face<true>(fine, weights, fine.at(2 * x + 1, 2 * y + 1), 1, east);
      add_face<false>(fine, weights, fine.at(2 * x, 2 * y + 1), stride, south);
      add_face<false>(fine, weights, fine.at(2 * x + 1, 2 * y + 1), stride, south);
      east.slow_down(across[static_cast<size_t>(x)]);
      south.slow_down(down[static_cast<size_t>(y)]);
      Cell* beside = here + 1;
      Cell* below = here + coarse.stride;
      here->east = east.in;
      here->south = south.in;
      here->diagonal += east.out + south.out;
      if (x + 1 < coarse.width) beside->west = east.out, beside->diagonal += east.in;
      if (y + 1 < coarse.height) below->north = south.out, below->diagonal += south.in;
    }
    Cell* row = coarse.row(y);  // complete: the row below adds nothing to it
    for (int x = 0; x < coarse.width; ++x) {
      const float inverse = row[x].diagonal > 0.0F ? 1.0F / row[x].diagonal : 0.0F;
      row[x].west *= inverse;
      row[x].east *= inverse;
      row[x].north *= inverse;
      row[x].south *= inverse;
    }
  }
}

void restrict_residuals(const Level& fine, bool held, Level& coarse) {
  const std::ptrdiff_t stride = fine.stride;
  if (held) {
    restrict_sums(fine, coarse,
                  [stride](const Cell* cell) { return cell->value > 0.0F ? residual(cell, stride) : 0.0F; });
  } else {
    restrict_sums(fine, coarse, [stride](const Cell* cell) { return residual(cell, stride); });
  }
  for (int y = 0; y < coarse.height; ++y)
    for (int x = 0; x < coarse.width; ++x) coarse.row(y)[x].value = 0.0F;
}

void restrict_sources(const Level& fine, Level& coarse) {
  restrict_sums(fine, coarse, [](const Cell* cell) { return cell->diagonal * cell->right; });
}

void add_correction(const Level& coarse, const float* weights, Level& fine) {
  for_children(coarse, fine, [weights](Cell& cell, size_t i, float value) {
    const float corrected = cell.value + weight_of(weights, i) * value;
    cell.value = std::max(corrected, 0.05F * cell.value);
  });
}

void add_signed_correction(const Level& coarse, Level& fine) {
  for_children(coarse, fine, [](Cell& cell, size_t, float value) { cell.value += value; });
}

void prolong(const Level& coarse, Level& fine) {
  for_children(coarse, fine, [](Cell& cell, size_t, float value) { cell.value = value; });
}

}  // namespace seamount::geom::transport
