#include "seamount/ops/amplify/shape.h"

#include <cmath>
#include <numbers>

#include "seamount/base/simd.h"

namespace seamount::amplify {
namespace {

constexpr int kCells = kShape * kShape;
constexpr double kPlaneShare = 0.4;

/// What the cells of a turned shape are multiplied with: [feature][cell].
using Basis = std::array<std::array<double, kCells>, kFeatures>;

/// The features of the cosines (2 <= along + across <= 4, and both first ones with all of the plane at its share).
Basis make_basis() {
  Basis basis{};
  int feature = 0;
  for (int order = 1; order <= 5; ++order) {
    for (int along = 0; along <= order; ++along) {
      const int across = order - along;
      if (order == 5 && along != 0 && across != 0) continue;  // the two that fill up to sixteen
      const auto wave = [](int k, int i) {
        return std::sqrt((k == 0 ? 1.0 : 2.0) / kShape) * std::cos(std::numbers::pi * k * (i + 0.5) / kShape);
      };
      for (int y = 0; y < kShape; ++y)
        for (int x = 0; x < kShape; ++x) basis[feature][kShape * y + x] = wave(along, x) * wave(across, y);
      ++feature;
    }
  }
  // Cosines of a shape less 1 - kPlaneShare of its plane: the same is taken from each cosine.
  const double squares = kShape * kShape * (kShape * kShape - 1) / 12.0;  // sum of squares of x - 2.5 over the cells
  for (auto& wave : basis) {
    double east = 0.0, south = 0.0;
    for (int i = 0; i < kCells; ++i) {
      east += wave[i] * (i % kShape - 0.5 * (kShape - 1));
      south += wave[i] * (i / kShape - 0.5 * (kShape - 1));
    }
    for (int i = 0; i < kCells; ++i) {
      const double plane =
          (east * (i % kShape - 0.5 * (kShape - 1)) + south * (i / kShape - 0.5 * (kShape - 1))) / squares;
      wave[i] -= (1.0 - kPlaneShare) * plane;
    }
  }
  return basis;
}

/// The basis for cells as they lie on the ground, by turn and cell.
struct TurnedBasis {
  std::array<std::array<Features, kCells>, 8> of;
  TurnedBasis() {
    const Basis basis = make_basis();
    for (int turn = 0; turn < 8; ++turn) {
      for (int i = 0; i < kCells; ++i) {
        const auto [x, y] = on_ground(static_cast<Turn>(turn), i % kShape, i / kShape, kShape);
        for (int f = 0; f < kFeatures; ++f) of[turn][kShape * y + x][f] = static_cast<float>(basis[f][i]);
      }
    }
  }
};

SEAMOUNT_VECTORISED void project(const float* cells, const Features* basis, float* out) {
  for (int i = 0; i < kCells; ++i)
    for (int f = 0; f < kFeatures; ++f) out[f] += cells[i] * basis[i][f];
}

Turn turn_of(const std::array<float, kCells>& cells) {
  float east = 0.0F, south = 0.0F;
  for (int y = 0; y < kShape; ++y) {
    for (int x = 0; x < kShape; ++x) {
      const float z = cells[kShape * y + x];
      east += z * (static_cast<float>(x) - 0.5F * (kShape - 1));
      south += z * (static_cast<float>(y) - 0.5F * (kShape - 1));
    }
  }
  return static_cast<Turn>((east < 0.0F ? 1 : 0) | (south < 0.0F ? 2 : 0) | (std::abs(south) > std::abs(east) ? 4 : 0));
}

}  // namespace

Shape describe_shape(const float* cells, int stride) {
  static const TurnedBasis kBasis;
  std::array<float, kCells> local;
  const float middle = cells[stride * (kShape / 2) + kShape / 2];
  for (int y = 0; y < kShape; ++y)
    for (int x = 0; x < kShape; ++x) local[kShape * y + x] = cells[y * stride + x] - middle;
  Shape shape;
  shape.turn = turn_of(local);
  project(local.data(), kBasis.of[shape.turn].data(), shape.features.data());
  float squares = 0.0F;
  for (const float f : shape.features) squares += f * f;
  shape.relief_m = std::sqrt(squares);
  if (shape.relief_m > 0.0F)
    for (float& f : shape.features) f /= shape.relief_m;
  return shape;
}

}  // namespace seamount::amplify
