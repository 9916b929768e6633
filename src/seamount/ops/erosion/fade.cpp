#include "seamount/ops/erosion/fade.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seamount::erosion {
namespace {

constexpr double kShareOfSlope = 0.6, kLeastSlope = 0.01, kMostSlope = 0.3;
constexpr int kRounds = 2;  // of sweeps down and up: ways that bend both ways need a second

/// Sweeps a grid down and up; `meet(cell, neighbour, cells_apart)` updates a cell by a neighbour that was met before.
template <class Meet>
void sweep(const GridFrame& frame, const RunContext& run, Meet&& meet) {
  const int width = frame.width, height = frame.height;
  constexpr float kDiagonal = std::numbers::sqrt2_v<float>;
  const auto visit = [&](int x, int y, int way) {
    const auto at = [&](int i, int j) { return static_cast<size_t>(j) * width + i; };
    const auto inside = [&](int i) { return i >= 0 && i < width; };
    const size_t cell = at(x, y);
    if (inside(x - way)) meet(cell, at(x - way, y), 1.0F);
    if (y - way < 0 || y - way >= height) return;
    meet(cell, at(x, y - way), 1.0F);
    for (const int side : {-1, 1})
      if (inside(x + side)) meet(cell, at(x + side, y - way), kDiagonal);
  };
  for (int round = 0; round < kRounds; ++round) {
    run.check_cancelled();
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) visit(x, y, 1);
    for (int y = height - 1; y >= 0; --y)
      for (int x = width - 1; x >= 0; --x) visit(x, y, -1);
  }
}

/// The greatest change around each cell, less what fading takes on the way there.
ScalarField change_around(const HeightField& before, const HeightField& after, double fade, const RunContext& run) {
  ScalarField most(before.frame());
  for (size_t i = 0; i < most.size(); ++i) most.data()[i] = std::abs(after.data()[i] - before.data()[i]);
  const auto lost = static_cast<float>(fade * before.cell_m());
  sweep(before.frame(), run, [&](size_t cell, size_t from, float apart) {
    most.data()[cell] = std::max(most.data()[cell], most.data()[from] - lost * apart);
  });
  return most;
}

double volume_of(const HeightField& surface) {
  double sum = 0;
  for (const float z : surface.cells()) sum += z;
  return sum * surface.cell_m() * surface.cell_m();
}

}  // namespace

double slope_of_fade(const HeightField& after) {
  double sum = 0;
  for (int y = 0; y + 1 < after.height(); ++y)
    for (int x = 0; x + 1 < after.width(); ++x)
      sum += std::hypot(after(x + 1, y) - after(x, y), after(x, y + 1) - after(x, y));
  const double mean = sum / (static_cast<double>(after.size()) * after.cell_m());
  return std::clamp(kShareOfSlope * mean, kLeastSlope, kMostSlope);
}

Mask opened(const Mask& mask) {
  Mask open = mask;
  for (float& share : open.cells()) share = share > 0.0F ? 1.0F : 0.0F;
  return open;
}

Mask faded(const Mask& mask, const HeightField& before, const HeightField& after, const RunContext& run) {
  const double fade = slope_of_fade(after);
  const ScalarField most = change_around(before, after, fade, run);
  const auto gain = static_cast<float>(fade * mask.cell_m());
  Mask share = mask;
  sweep(mask.frame(), run, [&](size_t cell, size_t from, float apart) {
    const float reach = share.data()[from] * most.data()[cell] + gain * apart;
    if (share.data()[cell] * most.data()[cell] > reach) share.data()[cell] = reach / most.data()[cell];
  });
  return share;
}

void keep_share(const Mask& share, const Layers& before, Layers& after, Ledger& ledger, const RunContext& run) {
  run.check_cancelled();
  const double start_m3 = volume_of(before.surface);
  const double error = start_m3 - volume_of(after.surface) + ledger.uplifted - ledger.exported;
  double all = 0, kept = 0;
  for (size_t i = 0; i < share.size(); ++i) {
    const float part = share.data()[i];
    const double moved = std::abs(after.surface.data()[i] - before.surface.data()[i]);
    all += moved;
    kept += part * moved;
    if (part >= 1.0F) continue;
    const auto keep = [&](ScalarField& now, const ScalarField& then) {
      now.data()[i] = then.data()[i] + part * (now.data()[i] - then.data()[i]);
    };
    keep(after.surface, before.surface);
    keep(after.debris, before.debris);
    keep(after.sediment, before.sediment);
  }
  const double ratio = all > 0 ? kept / all : 1.0;
  for (double* volume : {&ledger.uplifted, &ledger.eroded, &ledger.deposited}) *volume *= ratio;
  ledger.exported = start_m3 - volume_of(after.surface) + ledger.uplifted - ratio * error;
}

}  // namespace seamount::erosion
