#include "seamount/ops/reef/shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/scalar/blend.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/ops/reef/regions.h"

namespace seamount::reef {
namespace {

constexpr int kMostNodes = 4096;
constexpr float kFarAway_m = 1e6F;  // stands for infinity, so that fields stay finite
constexpr float kOutside = 4.0F;    // of min d / R where no colony is near

/// Colonies by lattice cell.
class ColonyGrid {
 public:
  ColonyGrid(const std::vector<Colony>& colonies, const std::vector<LatticeCell>& cells, const GridFrame& lattice)
      : colonies_(colonies), index_(lattice, -1), near_(lattice, 0) {
    double widest = 0, furthest = 0;
    for (size_t i = 0; i < cells.size(); ++i) {
      const Colony& c = colonies[i];
      widest = std::max(widest, c.radius_m);
      const double fx = lattice.column(c.centre.x) - cells[i].x, fy = lattice.row(c.centre.y) - cells[i].y;
      furthest = std::max({furthest, std::abs(fx), std::abs(fy)});
      index_(cells[i].x, cells[i].y) = static_cast<int32_t>(i);
    }
    reach_ = static_cast<int>(std::ceil(1.4 * widest / lattice.cell_m + furthest + 0.5));
    for (const LatticeCell s : cells) mark_near(s);
  }

  /// min over colonies of d / R, right up to 1.4 at least.
  float nearest(double x, double y) const {
    const GridFrame& f = index_.frame();
    const int cx = static_cast<int>(std::lround(f.column(x))), cy = static_cast<int>(std::lround(f.row(y)));
    if (!near_.clamped(cx, cy)) return kOutside;
    float least = kOutside * kOutside;
    for (int iy = std::max(0, cy - reach_); iy <= std::min(f.height - 1, cy + reach_); ++iy) {
      for (int ix = std::max(0, cx - reach_); ix <= std::min(f.width - 1, cx + reach_); ++ix) {
        const int32_t i = index_(ix, iy);
        if (i < 0) continue;
        const Colony& c = colonies_[static_cast<size_t>(i)];
        const double dx = x - c.centre.x, dy = y - c.centre.y;
        least = std::min(least, static_cast<float>((dx * dx + dy * dy) / (c.radius_m * c.radius_m)));
      }
    }
    return std::sqrt(least);
  }

 private:
  void mark_near(LatticeCell s) {
    for (int y = std::max(0, s.y - reach_); y <= std::min(near_.height() - 1, s.y + reach_); ++y) {
      for (int x = std::max(0, s.x - reach_); x <= std::min(near_.width() - 1, s.x + reach_); ++x) near_(x, y) = 1;
    }
  }

  const std::vector<Colony>& colonies_;
  Grid<int32_t> index_;
  Grid<uint8_t> near_;
  int reach_ = 0;
};

/// Distance in nodes to the outline next to a node, from t = d / R and its slope.
float nodes_from_outline(const ScalarField& t, int x, int y) {
  const float gx = t.clamped(x + 1, y) - t.clamped(x - 1, y), gy = t.clamped(x, y + 1) - t.clamped(x, y - 1);
  return std::abs(t(x, y) - 1.0F) / std::max(0.5F * std::sqrt(gx * gx + gy * gy), 1e-4F);
}

/// How deep a node lies behind the outline, in nodes: next to it by the slope of t, further in by the nearest node on
/// the other side and how far that one is from the outline.
float depth_behind(const ScalarField& t, int x, int y, int nx, int ny) {
  const float local = nodes_from_outline(t, x, y);
  const auto dx = static_cast<float>(x - nx), dy = static_cast<float>(y - ny);
  const float far = std::max(0.0F, std::sqrt(dx * dx + dy * dy) - std::min(1.0F, nodes_from_outline(t, nx, ny)));
  return local + geom::smoothstep(far - 1.0F) * (far - local);
}

/// Writes to `distance`, with a sign, how deep nodes that are not on the other side lie behind the outline.
void write_depth(const ScalarField& t, const Grid<uint8_t>& other_side, float sign, ScalarField& distance,
                 const RunContext& run) {
  Grid<int32_t> nearest;
  geom::nearest_feature(other_side, nearest, run);
  const auto cell = static_cast<float>(t.cell_m());
  parallel_rows(run, t.width(), t.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < t.width(); ++x) {
        if (other_side(x, y) != 0) continue;
        const int32_t n = nearest(x, y);
        if (n < 0) {
          distance(x, y) = sign * kFarAway_m;
          continue;
        }
        distance(x, y) = sign * cell * depth_behind(t, x, y, n % t.width(), n / t.width());
      }
    }
  });
}

}  // namespace

GridFrame shape_frame(const GridFrame& frame, double step_m) {
  GridFrame shape = frame;
  shape.cell_m = std::max(step_m, std::max(frame.width_m(), frame.height_m()) / kMostNodes);
  shape.width = static_cast<int>(std::ceil(frame.width_m() / shape.cell_m)) + 1;
  shape.height = static_cast<int>(std::ceil(frame.height_m() / shape.cell_m)) + 1;
  shape.west_m = frame.west_m + 0.5 * (frame.width_m() - shape.width_m());
  shape.north_m = frame.north_m - 0.5 * (frame.height_m() - shape.height_m());
  return shape;
}

ScalarField outline_distance(const std::vector<Colony>& colonies, const std::vector<LatticeCell>& cells,
                             const GridFrame& lattice, const GridFrame& frame, const Bend& bend, double least_hole_m2,
                             Seed seed, const RunContext& run) {
  const ColonyGrid grid(colonies, cells, lattice);
  const geom::Fbm noise{.wavelength_m = bend.wavelength_m, .octaves = 6, .gain = 0.55, .cell_m = 0.7 * frame.cell_m};
  const double strength = bend.amplitude_m / 0.35;
  ScalarField t(frame);
  Grid<uint8_t> inside(frame), outside(frame);
  parallel_rows(run.part(0.0, 0.6), frame.width, frame.height, [&](int begin, int end) {
    std::vector<float> east(static_cast<size_t>(frame.width), 0.0F), north(static_cast<size_t>(frame.width), 0.0F);
    for (int y = begin; y < end; ++y) {
      if (strength > 0) {
        geom::fbm_row(seed.derive("reef.bend_east"), noise, frame.x(0), frame.cell_m, frame.y(y), east);
        geom::fbm_row(seed.derive("reef.bend_north"), noise, frame.x(0), frame.cell_m, frame.y(y), north);
      }
      for (int x = 0; x < frame.width; ++x) {
        const auto i = static_cast<size_t>(x);
        t(x, y) = grid.nearest(frame.x(x) + strength * east[i], frame.y(y) + strength * north[i]);
        outside(x, y) = t(x, y) < 1.0F ? 0 : 1;
      }
    }
  });
  if (least_hole_m2 > 0) drop_small(outside, least_hole_m2);
  for (size_t i = 0; i < outside.size(); ++i) {
    inside.cells()[i] = 1 - outside.cells()[i];
    if (inside.cells()[i] != 0 && t.cells()[i] >= 1.0F) t.cells()[i] = 0.9F;
  }
  ScalarField distance(frame);
  write_depth(t, outside, 1.0F, distance, run.part(0.6, 0.8));
  write_depth(t, inside, -1.0F, distance, run.part(0.8, 1.0));
  return distance;
}

ScalarField crowding(const ScalarField& distance, double sigma_m, const RunContext& run) {
  ScalarField reef(distance.frame());
  const auto soft = static_cast<float>(1.0 / distance.cell_m());
  for (size_t i = 0; i < reef.size(); ++i) reef.cells()[i] = std::clamp(0.5F + distance.cells()[i] * soft, 0.0F, 1.0F);
  geom::gaussian_blur(reef, sigma_m, run);
  return reef;
}

ScalarField exposure(const ScalarField& distance, double swell_from_deg, double sigma_m, const RunContext& run) {
  const double angle = swell_from_deg * std::numbers::pi / 180.0;
  const auto sx = static_cast<float>(std::sin(angle)), sy = static_cast<float>(-std::cos(angle));  // rows run south
  ScalarField out(distance.frame(), 0.0F);
  parallel_rows(run, out.width(), out.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < out.width(); ++x) {
        const float gx = distance.clamped(x + 1, y) - distance.clamped(x - 1, y);
        const float gy = distance.clamped(x, y + 1) - distance.clamped(x, y - 1);
        const float length = std::sqrt(gx * gx + gy * gy);
        if (length > 1e-6F) out(x, y) = -(gx * sx + gy * sy) / length;
      }
    }
  });
  geom::gaussian_blur(out, sigma_m, run);
  return out;
}

ScalarField distance_to_open_sea(const ScalarField& distance, const HeightField& ground, double gap_m,
                                 const RunContext& run) {
  const GridFrame& frame = distance.frame();
  Grid<uint8_t> solid(frame), open(frame, 0);
  for (size_t i = 0; i < solid.size(); ++i) solid.cells()[i] = distance.cells()[i] > 0 || ground.cells()[i] > 0 ? 1 : 0;
  const ScalarField room = geom::distance_to(solid, run);
  const double half = 0.5 * gap_m;
  std::vector<int64_t> front;
  const auto visit = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= frame.width || y >= frame.height) return;
    if (open(x, y) != 0 || room(x, y) <= half || solid(x, y) != 0) return;
    open(x, y) = 1;
    front.push_back(static_cast<int64_t>(y) * frame.width + x);
  };
  for (int x = 0; x < frame.width; ++x) visit(x, 0), visit(x, frame.height - 1);
  for (int y = 0; y < frame.height; ++y) visit(0, y), visit(frame.width - 1, y);
  while (!front.empty()) {
    const auto x = static_cast<int>(front.back() % frame.width), y = static_cast<int>(front.back() / frame.width);
    front.pop_back();
    visit(x - 1, y), visit(x + 1, y), visit(x, y - 1), visit(x, y + 1);
  }
  ScalarField out = geom::distance_to(open, run);
  for (float& d : out.cells()) d = std::clamp(d - static_cast<float>(half), 0.0F, kFarAway_m);
  return out;
}

}  // namespace seamount::reef
