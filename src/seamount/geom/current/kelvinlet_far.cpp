#include "seamount/geom/current/kelvinlet_far.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/fourier.h"

namespace seamount::geom::kelvinlets {
namespace {

/// A square of nodes that holds the lattice and all sources, and as many more for the convolution not to come round.
struct Mesh {
  double x_m, y_m;  ///< first node, east and south of the grid's first cell
  double step_m;
  int n;  ///< nodes of the transforms, twice those that are used
};

constexpr int kSpare = 4;          ///< nodes on each side that interpolation asks for
constexpr double kCoarsest = 2.2;  ///< step, in steps of the lattice

Mesh make_mesh(std::span<const Source> sources, const FlowLattice& lattice) {
  const double margin = FlowLattice::kMargin * lattice.step_m;
  double west = -margin, east = lattice.last_column * lattice.step_m + margin;
  double north = -margin, south = lattice.last_row * lattice.step_m + margin;
  for (const Source& source : sources) {
    west = std::min(west, source.x);
    east = std::max(east, source.x);
    north = std::min(north, source.y);
    south = std::max(south, source.y);
  }
  const double extent = std::max(east - west, south - north);
  int n = 32;
  while (extent / (n / 2 - 1 - 2 * kSpare) > kCoarsest * lattice.step_m) n *= 2;
  const double step = extent / (n / 2 - 1 - 2 * kSpare);
  return {west - kSpare * step, north - kSpare * step, step, n};
}

/// Strengths on the mesh.
ComplexPlane spread(std::span<const Source> sources, const Mesh& mesh, bool grab, bool pressed) {
  ComplexPlane plane(mesh.n);
  for (const Source& source : sources) {
    if (source.grab != grab) continue;
    const double column = (source.x - mesh.x_m) / mesh.step_m, row = (source.y - mesh.y_m) / mesh.step_m;
    const double low_column = std::floor(column), low_row = std::floor(row);
    float across[6], down[6];
    quintic_weights(column - low_column, across);
    quintic_weights(row - low_row, down);
    const float factor = pressed ? source.pressed : 1.0F;
    for (int j = 0; j < 6; ++j) {
      const size_t to = plane.at(static_cast<int>(low_column) - 2, static_cast<int>(low_row) - 2 + j);
      for (size_t i = 0; i < 6; ++i) {
        const float weight = factor * down[j] * across[i];
        plane.re[to + i] += weight * source.re;
        plane.im[to + i] += weight * source.im;
      }
    }
  }
  return plane;
}

/// What one node does to the others: the flow's parts, in the words of Source.
struct Kernels {
  double reach_m, eps;

  /// falloff and near field of a squared distance.
  double far_share(double squared) const { return 1.0 - near_share(squared / (reach_m * reach_m)); }

  template <class Value>
  ComplexPlane fill(const Mesh& mesh, const RunContext& run, Value value) const {
    ComplexPlane plane(mesh.n);
    const int half = mesh.n / 2;
    parallel_rows(run, mesh.n, mesh.n, [&](int begin, int end) {
      for (int row = begin; row < end; ++row) {
        const double y = -(row < half ? row : row - mesh.n) * mesh.step_m;
        for (int column = 0; column < mesh.n; ++column) {
          const double x = (column < half ? column : column - mesh.n) * mesh.step_m;
          const double squared = x * x + y * y, share = far_share(squared);
          if (share <= 0.0) continue;
          const double inverse = 1.0 / std::sqrt(squared + eps * eps);
          const auto [re, im] = value(x, y, inverse);
          plane.re[plane.at(column, row)] = static_cast<float>(share * re);
          plane.im[plane.at(column, row)] = static_cast<float>(share * im);
        }
      }
    });
    transform(plane, run);
    return plane;
  }
};

struct Complex {
  double re, im;
};

void add_product(const ComplexPlane& a, const ComplexPlane& b, ComplexPlane& sum, const RunContext& run) {
  parallel_rows(run, a.n, a.n, [&](int begin, int end) {
    for (size_t i = a.at(0, begin); i < a.at(0, end); ++i) {
      sum.re[i] += a.re[i] * b.re[i] - a.im[i] * b.im[i];
      sum.im[i] += a.re[i] * b.im[i] + a.im[i] * b.re[i];
    }
  });
}

/// Scale and twist: m falloff z.
void add_round(std::span<const Source> sources, const Mesh& mesh, const Kernels& kernels, ComplexPlane& sum,
               const RunContext& run) {
  ComplexPlane strengths = spread(sources, mesh, false, false);
  transform(strengths, run);
  const double eps2 = kernels.eps * kernels.eps;
  add_product(strengths,
              kernels.fill(mesh, run,
                           [eps2](double x, double y, double inverse) {
                             const double cube = inverse * inverse * inverse,
                                          falloff = cube + 1.5 * eps2 * cube * inverse * inverse;
                             return Complex{falloff * x, falloff * y};
                           }),
              sum, run);
}

/// b of all grabs, if it is one.
std::optional<float> common_b(std::span<const Source> sources) {
  std::optional<float> common;
  for (const Source& source : sources) {
    if (!source.grab) continue;
    if (common && *common != source.pressed) return std::nullopt;
    common = source.pressed;
  }
  return common;
}

/// Grabs: (1/r_eps + eps^2 / (2 r_eps^3)) F + (r^2 / (2 r_eps^3) - 1/r_eps) b F + z^2 / (2 r_eps^3) conj(b F). The
/// first two kernels are real and even, so that one transform makes both: their spectra are its real and imaginary
/// parts.
void add_grabs(std::span<const Source> sources, const Mesh& mesh, const Kernels& kernels, ComplexPlane& sum,
               const RunContext& run) {
  ComplexPlane force = spread(sources, mesh, true, false);
  transform(force, run);
  ComplexPlane pressed = force;
  if (const std::optional<float> b = common_b(sources)) {
    for (std::vector<float>* part : {&pressed.re, &pressed.im})
      for (float& v : *part) v *= *b;
  } else {
    pressed = spread(sources, mesh, true, true);
    transform(pressed, run);
  }
  const double eps2 = kernels.eps * kernels.eps;
  const ComplexPlane straight = kernels.fill(mesh, run, [eps2](double x, double y, double inverse) {
    const double cube = inverse * inverse * inverse;
    return Complex{inverse + 0.5 * eps2 * cube, 0.5 * (x * x + y * y) * cube - inverse};
  });
  const ComplexPlane turned = kernels.fill(mesh, run, [](double x, double y, double inverse) {
    const double cube = inverse * inverse * inverse;
    return Complex{0.5 * (x * x - y * y) * cube, x * y * cube};
  });
  parallel_rows(run, mesh.n, mesh.n, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      for (int column = 0; column < mesh.n; ++column) {
        const size_t i = sum.at(column, row), opposite = sum.at((mesh.n - column) % mesh.n, (mesh.n - row) % mesh.n);
        const float re = pressed.re[opposite], im = -pressed.im[opposite];  // the spectrum of conj(b F)
        sum.re[i] +=
            straight.re[i] * force.re[i] + straight.im[i] * pressed.re[i] + turned.re[i] * re - turned.im[i] * im;
        sum.im[i] +=
            straight.re[i] * force.im[i] + straight.im[i] * pressed.im[i] + turned.re[i] * im + turned.im[i] * re;
      }
    }
  });
}

/// The radius whose square is the mean of the sources', weighted by their strengths: so errors cancel in a sum.
double mean_radius(std::span<const Source> sources, bool grab) {
  double squares = 0.0, weights = 1e-300;
  for (const Source& source : sources) {
    if (source.grab != grab) continue;
    const double weight = std::hypot(static_cast<double>(source.re), static_cast<double>(source.im));
    squares += weight * static_cast<double>(source.eps) * static_cast<double>(source.eps);
    weights += weight;
  }
  return std::sqrt(squares / weights);
}

}  // namespace

void add_far(std::span<const Source> sources, double reach_m, FlowLattice& lattice, const RunContext& run) {
  if (sources.empty()) return;
  const Mesh mesh = make_mesh(sources, lattice);
  ComplexPlane sum(mesh.n);
  const auto grabs = std::count_if(sources.begin(), sources.end(), [](const Source& s) { return s.grab; });
  if (grabs < static_cast<std::ptrdiff_t>(sources.size()))
    add_round(sources, mesh, {reach_m, mean_radius(sources, false)}, sum, run);
  if (grabs > 0) add_grabs(sources, mesh, {reach_m, mean_radius(sources, true)}, sum, run);
  transform_back(sum, mesh.n / 2, run);
  add_picture({sum.re.data(), sum.im.data(), mesh.n, mesh.x_m, mesh.y_m, mesh.step_m}, lattice, run);
}

}  // namespace seamount::geom::kelvinlets
