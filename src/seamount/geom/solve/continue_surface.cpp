#include "seamount/geom/solve/continue_surface.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/pyramid_fill.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/scalar/blend.h"

namespace seamount::geom {
namespace {

constexpr float kRim = 3.0F;  ///< cells of known ground from its rim that say how it goes on

/// The plane of least squares through some cells: its slopes per cell, and the middle of those cells.
struct Plane {
  double slope_x = 0.0, slope_y = 0.0;
  double middle_x = 0.0, middle_y = 0.0;  ///< from the cell around which they lie
};

/// Through the cells around one that are known, or that are not; none where they lie in a line.
std::optional<Plane> plane_at(const HeightField& heights, const HeightField& known, bool of_known, int px, int py,
                              int reach) {
  double n = 0, sx = 0, sy = 0, sz = 0, xx = 0, xy = 0, yy = 0, xz = 0, yz = 0;
  for (int v = std::max(-reach, -py); v <= std::min(reach, known.height() - 1 - py); ++v) {
    for (int u = std::max(-reach, -px); u <= std::min(reach, known.width() - 1 - px); ++u) {
      if (std::isnan(known(px + u, py + v)) == of_known) continue;
      const double z = static_cast<double>(heights(px + u, py + v)) - static_cast<double>(known(px, py));
      n += 1;
      sx += u;
      sy += v;
      sz += z;
      xx += u * u;
      xy += u * v;
      yy += v * v;
      xz += u * z;
      yz += v * z;
    }
  }
  if (n < 3) return std::nullopt;
  xx -= sx * sx / n;
  xy -= sx * sy / n;
  yy -= sy * sy / n;
  xz -= sx * sz / n;
  yz -= sy * sz / n;
  const double determinant = xx * yy - xy * xy;
  if (determinant < 1e-6) return std::nullopt;
  return Plane{(xz * yy - yz * xy) / determinant, (yz * xx - xz * xy) / determinant, sx / n, sy / n};
}

/// Distances in cells from the cells that are known, or from those that are not.
ScalarField cells_from(const HeightField& known, bool unknown, const RunContext& run) {
  GridFrame frame = known.frame();
  frame.cell_m = 1.0;
  Grid<uint8_t> cells(frame, 0);
  for (size_t i = 0; i < cells.size(); ++i) cells.data()[i] = std::isnan(known.data()[i]) == unknown ? 1 : 0;
  return distance_to(cells, run);
}

struct Rim {
  const HeightField& known;
  ScalarField from_known, from_rim;

  bool is_rim(int x, int y) const { return !std::isnan(known(x, y)) && from_rim(x, y) <= kRim; }

  /// By how much more the known part rises outwards at a rim cell than what was made does.
  std::optional<float> bend_at(const HeightField& made, int x, int y) const {
    constexpr int kReach = 4;
    const std::optional<Plane> inside = plane_at(known, known, true, x, y, kReach),
                               outside = plane_at(made, known, false, x, y, kReach);
    if (!inside || !outside) return std::nullopt;
    const double away = std::hypot(outside->middle_x, outside->middle_y);
    if (away < 0.5) return std::nullopt;
    return static_cast<float>(((inside->slope_x - outside->slope_x) * outside->middle_x +
                               (inside->slope_y - outside->slope_y) * outside->middle_y) /
                              away);
  }

  void tilt(const Continuation& options, HeightField& made, const RunContext& run) const {
    ScalarField bend(known.frame(), 0.0F);
    Grid<float> weight(known.frame(), 0.0F);
    parallel_rows(run, known.width(), known.height(), [&](int begin, int end) {
      for (int y = begin; y < end; ++y) {
        for (int x = 0; x < known.width(); ++x) {
          if (std::isnan(known(x, y)) || from_rim(x, y) > 1.5F) continue;
          const std::optional<float> found = bend_at(made, x, y);
          if (!found) continue;
          bend(x, y) = *found;
          weight(x, y) = 1.0F;
        }
      }
    });
    pyramid_fill(bend, std::move(weight), {.prior = 0.0F, .fade = 0.9F}, run);
    parallel_rows(run, known.width(), known.height(), [&](int begin, int end) {
      for (int y = begin; y < end; ++y) {
        for (int x = 0; x < known.width(); ++x) {
          const float away = from_known(x, y);
          if (away == 0.0F || away > options.far) continue;
          const float share = 1.0F - smoothstep(away / options.far);
          made(x, y) += share * bend(x, y) * options.bend * (1.0F - std::exp(-away / options.bend));
        }
      }
    });
  }

  /// A rim cell and the plane that touches the known part there.
  struct Touch {
    int x;
    double height, slope_x, slope_y;
  };
  using Touches = std::vector<std::vector<Touch>>;  ///< of each row, from west to east

  Touches touches(const RunContext& run) const {
    constexpr int kReach = 1;
    Touches rows(static_cast<size_t>(known.height()));
    parallel_rows(run, known.width(), known.height(), [&](int begin, int end) {
      for (int y = begin; y < end; ++y) {
        for (int x = 0; x < known.width(); ++x) {
          if (!is_rim(x, y)) continue;
          const Plane plane = plane_at(known, known, true, x, y, kReach).value_or(Plane{});
          rows[static_cast<size_t>(y)].push_back({x, static_cast<double>(known(x, y)), plane.slope_x, plane.slope_y});
        }
      }
    });
    return rows;
  }

  /// What the planes that touch the known part say of a cell beside it.
  /// `weights`: by the squared distance.
  float continued(const Touches& rows, std::span<const double> weights, int x, int y) const {
    const int reach = static_cast<int>(std::ceil(from_known(x, y))) + 2;
    double sum = 0, total = 0;
    for (int v = std::max(0, y - reach); v <= std::min(known.height() - 1, y + reach); ++v) {
      const std::vector<Touch>& row = rows[static_cast<size_t>(v)];
      auto touch =
          std::lower_bound(row.begin(), row.end(), x - reach, [](const Touch& t, int west) { return t.x < west; });
      for (; touch != row.end() && touch->x <= x + reach; ++touch) {
        const int dx = x - touch->x, dy = y - v;
        const double weight = weights[static_cast<size_t>(dx * dx + dy * dy)];
        sum += weight * (touch->height + touch->slope_x * dx + touch->slope_y * dy);
        total += weight;
      }
    }
    return static_cast<float>(sum / total);
  }

  void touch(int near, HeightField& made, const RunContext& run) const {
    const Touches rows = touches(run);
    const int reach = near + 2;
    std::vector<double> weights;
    for (int square = 0; square <= 2 * reach * reach; ++square)
      weights.push_back(1.0 / (static_cast<double>(square) * square));
    parallel_rows(run, known.width(), known.height(), [&](int begin, int end) {
      for (int y = begin; y < end; ++y) {
        for (int x = 0; x < known.width(); ++x) {
          const float away = from_known(x, y);
          if (away == 0.0F) {
            made(x, y) = known(x, y);
          } else if (away <= static_cast<float>(near)) {
            const float share = 1.0F - smoothstep(away / static_cast<float>(near + 1));
            made(x, y) += share * (continued(rows, weights, x, y) - made(x, y));
          }
        }
      }
    });
  }
};

}  // namespace

void continue_surface(const HeightField& known, const Continuation& options, HeightField& made, const RunContext& run) {
  const Rim rim{known, cells_from(known, false, run), cells_from(known, true, run)};
  rim.tilt(options, made, run);
  rim.touch(options.near, made, run);
}

}  // namespace seamount::geom
