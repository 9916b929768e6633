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
  int half = 16;
  while (extent / (half - 1 - 2 * kSpare) > kCoarsest * lattice.step_m) half *= 2;
  const double step = extent / (half - 1 - 2 * kSpare);
  return {west - kSpare * step, north - kSpare * step, step, 2 * half};
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

using KernelRow = void (*)(const FarKernel& kernel, int first, float y, int count, float* re, float* im);

/// A convolution on one mesh.
struct Convolution {
  const Mesh& mesh;
  double reach_m;
  ComplexPlane& scratch;
  const RunContext& run;

  /// The spectrum of what one node does to the others.
  ComplexPlane kernel(double eps, KernelRow row) const {
    ComplexPlane plane(mesh.n);
    const int half = mesh.n / 2;
    const FarKernel far{static_cast<float>(mesh.step_m), static_cast<float>(1.0 / reach_m), static_cast<float>(eps)};
    parallel_rows(run, mesh.n, mesh.n, [&](int begin, int end) {
      for (int y = begin; y < end; ++y) {
        const auto north = static_cast<float>(-(y < half ? y : y - mesh.n) * mesh.step_m);
        float *re = &plane.re[plane.at(0, y)], *im = &plane.im[plane.at(0, y)];
        row(far, 0, north, half, re, im);
        row(far, -half, north, half, re + half, im + half);
      }
    });
    transform(plane, scratch, run);
    return plane;
  }

  ComplexPlane strengths(std::span<const Source> sources, bool grab, bool pressed) const {
    ComplexPlane plane = spread(sources, mesh, grab, pressed);
    transform(plane, scratch, run);
    return plane;
  }
};

void add_product(const ComplexPlane& a, const ComplexPlane& b, ComplexPlane& sum, const RunContext& run) {
  parallel_rows(run, a.n, a.n, [&](int begin, int end) {
    for (size_t i = a.at(0, begin); i < a.at(0, end); ++i) {
      sum.re[i] += a.re[i] * b.re[i] - a.im[i] * b.im[i];
      sum.im[i] += a.re[i] * b.im[i] + a.im[i] * b.re[i];
    }
  });
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
void add_grabs(std::span<const Source> sources, double eps, const Convolution& convolution, ComplexPlane& sum) {
  const ComplexPlane force = convolution.strengths(sources, true, false);
  ComplexPlane pressed(0);
  if (const std::optional<float> b = common_b(sources)) {
    pressed = force;
    for (std::vector<float>* part : {&pressed.re, &pressed.im})
      for (float& v : *part) v *= *b;
  } else {
    pressed = convolution.strengths(sources, true, true);
  }
  const ComplexPlane straight = convolution.kernel(eps, far_straight_row);
  const ComplexPlane turned = convolution.kernel(eps, far_turned_row);
  const Mesh& mesh = convolution.mesh;
  parallel_rows(convolution.run, mesh.n, mesh.n, [&](int begin, int end) {
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
  ComplexPlane sum(mesh.n), scratch(mesh.n);
  const Convolution convolution{mesh, reach_m, scratch, run};
  const auto grabs = std::count_if(sources.begin(), sources.end(), [](const Source& s) { return s.grab; });
  if (grabs < static_cast<std::ptrdiff_t>(sources.size())) {
    const ComplexPlane strengths = convolution.strengths(sources, false, false);
    add_product(strengths, convolution.kernel(mean_radius(sources, false), far_round_row), sum, run);
  }
  if (grabs > 0) add_grabs(sources, mean_radius(sources, true), convolution, sum);
  transform_back(sum, scratch, mesh.n / 2, run);
  add_picture({sum.re.data(), sum.im.data(), mesh.n, mesh.x_m, mesh.y_m, mesh.step_m}, lattice, run);
}

}  // namespace seamount::geom::kelvinlets
