#include "seamount/geom/grid/surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/grid/resample.h"

namespace seamount::geom {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr float kDegreesF = static_cast<float>(kDegrees);

/// Height of a cell or of one beyond the edge, where heights are those within, turned about the edge cell:
/// z(-i) = 2 z(0) - z(i).
double turned_height(const HeightField& terrain, int x, int y) {
  const int inner_x = std::clamp(x, 0, terrain.width() - 1), inner_y = std::clamp(y, 0, terrain.height() - 1);
  if (x != inner_x) {
    const int mirrored = std::clamp(2 * inner_x - x, 0, terrain.width() - 1);
    return 2.0 * turned_height(terrain, inner_x, y) - turned_height(terrain, mirrored, y);
  }
  if (y != inner_y) {
    const int mirrored = std::clamp(2 * inner_y - y, 0, terrain.height() - 1);
    return 2.0 * terrain(x, inner_y) - terrain(x, mirrored);
  }
  return terrain(x, y);
}

/// A row with one cell more at both ends; beyond the edge heights go on linearly.
void pad_row(const HeightField& terrain, int y, std::vector<float>& out) {
  const int inner = std::clamp(y, 0, terrain.height() - 1);
  const auto row = terrain.row(inner);
  std::copy(row.begin(), row.end(), out.begin() + 1);
  if (y != inner) {
    const auto mirrored = terrain.row(std::clamp(2 * inner - y, 0, terrain.height() - 1));
    for (size_t i = 0; i < row.size(); ++i) out[i + 1] = 2.0F * row[i] - mirrored[i];
  }
  const size_t last = row.size();
  out[0] = last > 1 ? 2.0F * out[1] - out[2] : out[1];
  out[last + 1] = last > 1 ? 2.0F * out[last] - out[last - 1] : out[last];
}

/// Derivatives at cell i from three padded rows. `first` = 1 / (6 cell), `second` = 1 / (3 cell^2).
struct Fit {
  float p, q, r, s, t;
};

SEAMOUNT_INLINE Fit fit_cell(const float* north, const float* here, const float* south, int i, float first,
                             float second) {
  const float west = north[i] + here[i] + south[i], east = north[i + 2] + here[i + 2] + south[i + 2];
  const float top = north[i] + north[i + 1] + north[i + 2], bottom = south[i] + south[i + 1] + south[i + 2];
  const float middle_column = north[i + 1] + here[i + 1] + south[i + 1],
              middle_row = here[i] + here[i + 1] + here[i + 2];
  return {first * (east - west), first * (top - bottom), second * ((east - middle_column) - (middle_column - west)),
          0.75F * second * ((north[i + 2] - north[i]) - (south[i + 2] - south[i])),
          second * ((top - middle_row) - (middle_row - bottom))};
}

/// atan of x in [0, 1], to 1e-7: a polynomial through Chebyshev nodes on [0, tan(pi/8)], and atan(x) = pi/4 -
/// atan((1 - x) / (1 + x)) above.
SEAMOUNT_INLINE float arc(float x) {
  const bool steep = x > 0.41421356F;
  const float u = steep ? (1.0F - x) / (1.0F + x) : x;
  const float z = u * u;
  const float small =
      u *
      (1.0F + z * (-0.333333069F + z * (0.19998183F + z * (-0.142395327F + z * (0.105698288F - 0.0602630524F * z)))));
  return steep ? 0.785398163F - small : small;
}

SEAMOUNT_INLINE float slope_of(Fit f) {
  const float g = std::sqrt(f.p * f.p + f.q * f.q);
  return kDegreesF * (g > 1.0F ? 1.57079633F - arc(1.0F / g) : arc(g));
}

SEAMOUNT_INLINE float aspect_of(Fit f) {
  const float east = f.p > 0.0F ? f.p : -f.p, north = f.q > 0.0F ? f.q : -f.q;
  const bool sideways = east > north;
  const float larger = sideways ? east : north, smaller = sideways ? north : east;
  const float octant = kDegreesF * arc(larger > 0.0F ? smaller / larger : 0.0F);
  const float quadrant = sideways ? 90.0F - octant : octant;     // from the north-south line
  const float half = f.q > 0.0F ? 180.0F - quadrant : quadrant;  // falls to the south where q > 0
  const float bearing = f.p > 0.0F ? 360.0F - half : half;       // falls to the west where p > 0
  return larger > 0.0F ? (bearing < 360.0F ? bearing : 0.0F) : -1.0F;
}

SEAMOUNT_INLINE float mean_of(Fit f) {
  const float pp = f.p * f.p, qq = f.q * f.q, root = std::sqrt(1.0F + pp + qq);
  return -0.5F * ((1.0F + qq) * f.r - 2.0F * f.p * f.q * f.s + (1.0F + pp) * f.t) / (root * root * root);
}

SEAMOUNT_INLINE float profile_of(Fit f) {
  const float g = f.p * f.p + f.q * f.q, root = std::sqrt(1.0F + g);
  const float along = f.p * f.p * f.r + 2.0F * f.p * f.q * f.s + f.q * f.q * f.t;
  return g > 1e-20F ? -along / (g * root * root * root) : mean_of(f);
}

SEAMOUNT_INLINE float plan_of(Fit f) {
  const float g = f.p * f.p + f.q * f.q;
  const float across = f.q * f.q * f.r - 2.0F * f.p * f.q * f.s + f.p * f.p * f.t;
  return g > 1e-20F ? -across / (g * std::sqrt(1.0F + g)) : mean_of(f);
}

struct Stencil {
  const float* north;
  const float* here;
  const float* south;
  int count;
  float first, second;
};

SEAMOUNT_VECTORISED void slope_row(const Stencil s, float* __restrict out) {
  for (int i = 0; i < s.count; ++i) out[i] = slope_of(fit_cell(s.north, s.here, s.south, i, s.first, s.second));
}

SEAMOUNT_VECTORISED void aspect_row(const Stencil s, float* __restrict out) {
  for (int i = 0; i < s.count; ++i) out[i] = aspect_of(fit_cell(s.north, s.here, s.south, i, s.first, s.second));
}

SEAMOUNT_VECTORISED void profile_row(const Stencil s, float* __restrict out) {
  for (int i = 0; i < s.count; ++i) out[i] = profile_of(fit_cell(s.north, s.here, s.south, i, s.first, s.second));
}

SEAMOUNT_VECTORISED void plan_row(const Stencil s, float* __restrict out) {
  for (int i = 0; i < s.count; ++i) out[i] = plan_of(fit_cell(s.north, s.here, s.south, i, s.first, s.second));
}

SEAMOUNT_VECTORISED void mean_row(const Stencil s, float* __restrict out) {
  for (int i = 0; i < s.count; ++i) out[i] = mean_of(fit_cell(s.north, s.here, s.south, i, s.first, s.second));
}

ScalarField measure(const HeightField& terrain, void (*row)(Stencil, float*), const RunContext& run) {
  ScalarField out(terrain.frame());
  const double cell = terrain.cell_m();
  parallel_rows(run, terrain.width(), terrain.height(), [&](int begin, int end) {
    const auto padded = static_cast<size_t>(terrain.width()) + 2;
    std::vector<float> north(padded), here(padded), south(padded);
    pad_row(terrain, begin - 1, north);
    pad_row(terrain, begin, here);
    for (int y = begin; y < end; ++y) {
      pad_row(terrain, y + 1, south);
      row({north.data(), here.data(), south.data(), terrain.width(), static_cast<float>(1.0 / (6.0 * cell)),
           static_cast<float>(1.0 / (3.0 * cell * cell))},
          out.row(y).data());
      std::swap(north, here);
      std::swap(here, south);
    }
  });
  return out;
}

}  // namespace

SurfaceFit fit_surface(const HeightField& terrain, int x, int y) {
  const auto z = [&](int dx, int dy) { return turned_height(terrain, x + dx, y - dy); };  // dy: to the north
  const double cell = terrain.cell_m();
  const double west = z(-1, 1) + z(-1, 0) + z(-1, -1), east = z(1, 1) + z(1, 0) + z(1, -1);
  const double north = z(-1, 1) + z(0, 1) + z(1, 1), south = z(-1, -1) + z(0, -1) + z(1, -1);
  const double column = z(0, 1) + z(0, 0) + z(0, -1), row = z(-1, 0) + z(0, 0) + z(1, 0);
  return {(east - west) / (6.0 * cell), (north - south) / (6.0 * cell),
          (west + east - 2.0 * column) / (3.0 * cell * cell),
          (z(1, 1) + z(-1, -1) - z(-1, 1) - z(1, -1)) / (4.0 * cell * cell),
          (north + south - 2.0 * row) / (3.0 * cell * cell)};
}

double SurfaceFit::slope_deg() const { return std::atan(std::hypot(p, q)) * kDegrees; }

double SurfaceFit::aspect_deg() const {
  if (p == 0.0 && q == 0.0) return -1.0;
  const double bearing = std::atan2(-p, -q) * kDegrees;
  return bearing < 0.0 ? bearing + 360.0 : bearing;
}

double SurfaceFit::mean_curvature() const {
  return -0.5 * ((1.0 + q * q) * r - 2.0 * p * q * s + (1.0 + p * p) * t) / std::pow(1.0 + p * p + q * q, 1.5);
}

double SurfaceFit::profile_curvature() const {
  const double g = p * p + q * q;
  if (g <= 1e-20) return mean_curvature();
  return -(p * p * r + 2.0 * p * q * s + q * q * t) / (g * std::pow(1.0 + g, 1.5));
}

double SurfaceFit::plan_curvature() const {
  const double g = p * p + q * q;
  if (g <= 1e-20) return mean_curvature();
  return -(q * q * r - 2.0 * p * q * s + p * p * t) / (g * std::sqrt(1.0 + g));
}

namespace {

/// Cells by which at_scale() goes on beyond the edge.
double margin_cells(double scale_m, double cell_m) { return std::ceil(1.6 * scale_m / cell_m); }

}  // namespace

int scale_reach(double scale_m, double cell_m) {
  constexpr double kMost = 1 << 24;
  if (!(scale_m >= cell_m)) return 0;
  // At the edge what lies beyond is turned back from within.
  return std::max(blur_reach(0.5 * scale_m, cell_m), static_cast<int>(std::min(margin_cells(scale_m, cell_m), kMost)));
}

HeightField at_scale(const HeightField& terrain, double scale_m, const RunContext& run) {
  const double cell = terrain.cell_m();
  if (!(scale_m >= cell)) return terrain;
  // Heights beyond the edge are those within, turned by half a turn about the edge cell; the same for scales larger
  // than the terrain, whose margin ends where there is nothing left to turn.
  const auto margin = [&](int size) {
    return static_cast<int>(std::min(margin_cells(scale_m, cell), std::max(0.0, size - 1.0)));
  };
  const int left = margin(terrain.width()), top = margin(terrain.height());
  GridFrame wide = terrain.frame();  // its corner does not count; a window's margin stands before its own cells
  wide.width += 2 * left;
  wide.height += 2 * top;
  HeightField padded(wide);
  parallel_rows(run, wide.width, wide.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < wide.width; ++x) {
        const int column = x - left, row = y - top;
        padded(x, y) = terrain.contains(column, row) ? terrain(column, row)
                                                     : static_cast<float>(turned_height(terrain, column, row));
      }
    }
  });
  gaussian_blur(padded, 0.5 * scale_m, run);
  HeightField out(terrain.frame());
  parallel_rows(run, out.width(), out.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const auto row = padded.row(y + top).subspan(static_cast<size_t>(left), static_cast<size_t>(out.width()));
      std::copy(row.begin(), row.end(), out.row(y).begin());
    }
  });
  return out;
}

ScalarField slope_deg(const HeightField& terrain, const RunContext& run) { return measure(terrain, slope_row, run); }

ScalarField aspect_deg(const HeightField& terrain, const RunContext& run) { return measure(terrain, aspect_row, run); }

ScalarField curvature(const HeightField& terrain, Curvature kind, const RunContext& run) {
  return measure(terrain,
                 kind == Curvature::profile ? profile_row
                 : kind == Curvature::plan  ? plan_row
                                            : mean_row,
                 run);
}

}  // namespace seamount::geom
