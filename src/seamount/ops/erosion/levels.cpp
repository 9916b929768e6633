#include "seamount/ops/erosion/levels.h"

#include <array>
#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/geom/pyramid.h"

namespace seamount::erosion {
namespace {

// How deep erosion goes, or how thick deposits are, until half of a cell's own detail is gone; in cells.
constexpr double kErodedDepth = 3.0, kBuriedDepth = 0.1;
constexpr int kSmoothCorrections = 3;

ScalarField halved_map(const ScalarField& map, const RunContext& run) {
  return map.empty() ? ScalarField() : geom::halved(map, run);
}

/// Where a fine grid may change.
struct Openness {
  const Mask& mask;
  const Grid<uint8_t>& pinned;
  float operator()(size_t cell) const { return pinned.data()[cell] != 0 ? 0.0F : value_or_one(mask, cell); }
};

/// The cells of a fine grid that make one of a coarse grid: 4, or 2 or 1 at odd edges.
struct Block {
  std::array<size_t, 4> cell = {};
  int count = 0;

  Block(const GridFrame& fine, int x, int y) {
    for (int dy = 0; dy < 2; ++dy) {
      for (int dx = 0; dx < 2; ++dx) {
        if (2 * x + dx >= fine.width || 2 * y + dy >= fine.height) continue;
        cell[count++] = static_cast<size_t>(2 * y + dy) * fine.width + (2 * x + dx);
      }
    }
  }
};

/// Calls f(block, coarse cell) for every block, in parallel rows.
template <class F>
void for_blocks(const GridFrame& coarse, const GridFrame& fine, const RunContext& run, F f) {
  parallel_rows(run, coarse.width, coarse.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < coarse.width; ++x) f(Block(fine, x, y), static_cast<size_t>(y) * coarse.width + x);
    }
  });
}

ScalarField difference(const ScalarField& a, const ScalarField& b) {
  ScalarField out(a.frame());
  for (size_t i = 0; i < a.size(); ++i) out.data()[i] = a.data()[i] - b.data()[i];
  return out;
}

/// What the mean of `change` over each block lacks to `wanted`, added by smooth interpolation.
void correct_smoothly(const ScalarField& wanted, const Openness& open, ScalarField& change, const RunContext& run) {
  const ScalarField lacking = difference(wanted, geom::halved(change, run));
  const ScalarField smooth = geom::doubled(lacking, change.frame(), run);
  for (size_t i = 0; i < change.size(); ++i) change.data()[i] += smooth.data()[i] * open(i);
}

/// Makes the mean of `change` over a block `wanted`, where the mask lets it.
void correct(const Block& block, const Openness& open, float wanted, ScalarField& change) {
  float mean = 0.0F, room = 0.0F;
  for (int k = 0; k < block.count; ++k) {
    mean += change.data()[block.cell[k]];
    room += open(block.cell[k]);
  }
  if (room <= 0.0F) return;
  const float rest = (wanted * static_cast<float>(block.count) - mean) / room;
  for (int k = 0; k < block.count; ++k) {
    change.data()[block.cell[k]] += rest * open(block.cell[k]);
  }
}

/// What a layer's change is on the finer grid; a layer never becomes negative.
void refine_layer(const ScalarField& now, const ScalarField& start, ScalarField& layer, const Openness& open,
                  const RunContext& run) {
  const ScalarField coarse = difference(now, start);
  ScalarField change = geom::doubled(coarse, layer.frame(), run);
  for_blocks(now.frame(), layer.frame(), run, [&](const Block& block, size_t parent) {
    for (int k = 0; k < block.count; ++k) {
      const size_t cell = block.cell[k];
      change.data()[cell] = std::max(-layer.data()[cell], change.data()[cell] * open(cell));
    }
    correct(block, open, coarse.data()[parent], change);
    for (int k = 0; k < block.count; ++k) {
      float& thickness = layer.data()[block.cell[k]];
      thickness = std::max(0.0F, thickness + change.data()[block.cell[k]]);
    }
  });
}

}  // namespace

Ground halved(const Ground& ground, const RunContext& run) {
  return {geom::halved(ground.surface, run), geom::halved(ground.rock, run), geom::halved(ground.sediment, run)};
}

Site halved(const Site& site, const RunContext& run) {
  return {halved_map(site.hardness, run), halved_map(site.mask, run), halved_map(site.uplift, run)};
}

void refine(const Ground& now, const Ground& start, Ground& fine, const Site& site, const Grid<uint8_t>& pinned,
            Ledger& ledger, const RunContext& run) {
  const Openness open{site.mask, pinned};
  refine_layer(now.rock, start.rock, fine.rock, open, run);
  refine_layer(now.sediment, start.sediment, fine.sediment, open, run);
  const GridFrame& frame = fine.frame();
  const ScalarField coarse = difference(now.surface, start.surface);
  ScalarField change = geom::doubled(coarse, frame, run);
  const ScalarField smooth = geom::doubled(start.surface, frame, run);
  const auto eroded = static_cast<float>(kErodedDepth * frame.cell_m);
  const auto buried = static_cast<float>(kBuriedDepth * frame.cell_m);
  for_blocks(now.frame(), frame, run, [&](const Block& block, size_t) {
    for (int k = 0; k < block.count; ++k) {
      const size_t cell = block.cell[k];
      const float moved = change.data()[cell] / (change.data()[cell] > 0.0F ? buried : eroded);
      const float gone = 1.0F - 1.0F / (1.0F + moved * moved);
      const float detail = fine.surface.data()[cell] - smooth.data()[cell];
      change.data()[cell] = (change.data()[cell] - gone * detail) * open(cell);
    }
  });
  for (int k = 0; k < kSmoothCorrections; ++k) correct_smoothly(coarse, open, change, run);
  for_blocks(now.frame(), frame, run, [&](const Block& block, size_t parent) {
    correct(block, open, coarse.data()[parent], change);
    for (int k = 0; k < block.count; ++k) fine.surface.data()[block.cell[k]] += change.data()[block.cell[k]];
  });
  double coarse_sum = 0, fine_sum = 0;
  for (const float by : coarse.cells()) coarse_sum += by;
  for (const float by : change.cells()) fine_sum += by;
  ledger.exported += (4.0 * coarse_sum - fine_sum) * frame.cell_m * frame.cell_m;
}

}  // namespace seamount::erosion
