// The shipped network around pieces of known ground (P1 sec. 6.3): no seam shows.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "seamount/io/find_model.h"
#include "seamount/io/weights.h"
#include "seamount/ops/learned/sketch.h"
#include "seamount/ops/sketch/extract.h"
#include "seamount/ops/terrain/compose.h"
#include "seamount/ops/terrain/noise.h"

namespace seamount::train {
namespace {

constexpr int kPiece = 60;

HeightField piece(uint64_t n) {
  terrain::NoiseParams params;
  params.kind = n == 1 ? terrain::NoiseKind::ridged : terrain::NoiseKind::mountains;
  params.height_m = n == 2 ? 250 : 700;
  params.wavelength_m = 2500;
  params.base_m = 600;
  return terrain::noise(params, GridFrame::centred(kPiece, kPiece, 60), Seed{70 + n}, {});
}

/// Mean jump of slope from one pair of cells to the next but one, across rims, and 4 to 14 cells inside and outside.
struct Jumps {
  double rim = 0, inside = 0, outside = 0;
};

Jumps jumps_of(const HeightField& made, const std::vector<Vec2>& places) {
  double sum[3] = {0, 0, 0};
  int count[3] = {0, 0, 0};
  const auto jump = [&](int x, int y, int dx, int dy) {  // between (x, y) and the cell behind it
    return std::abs((made(x + dx, y + dy) - made(x, y)) - (made(x - dx, y - dy) - made(x - 2 * dx, y - 2 * dy)));
  };
  for (const Vec2& place : places) {
    const int left = static_cast<int>(std::lround(made.frame().column(place.x) - 0.5 * kPiece + 0.5)),
              top = static_cast<int>(std::lround(made.frame().row(place.y) - 0.5 * kPiece + 0.5));
    for (int along = 0; along < kPiece; ++along) {
      for (int from = -14; from <= 14; ++from) {
        if (from != 0 && std::abs(from) < 4) continue;
        const int kind = from == 0 ? 0 : from > 0 ? 1 : 2;
        for (const int x : {left + from, left + kPiece - from})
          sum[kind] += static_cast<double>(jump(x, top + along, 1, 0));
        for (const int y : {top + from, top + kPiece - from})
          sum[kind] += static_cast<double>(jump(left + along, y, 0, 1));
        count[kind] += 4;
      }
    }
  }
  return {sum[0] / count[0], sum[1] / count[1], sum[2] / count[2]};
}

TEST(SketchSeams, SlopesGoOnAcrossTheRimsOfPieces) {
  const learned::Network network(io::read_weights(io::find_model("sketch")), learned::Precision::f32);
  const std::vector<HeightField> pieces{piece(0), piece(1), piece(2)};
  terrain::ComposeParams placing;
  placing.places = {{-4500, 4200}, {4800, 3600}, {-600, -4800}};
  placing.feather_m = 0;
  const HeightField laid =
      terrain::compose({&pieces[0], &pieces[1], &pieces[2]}, placing, GridFrame::centred(320, 320, 60), {});
  const sketch::Sketch drawn = sketch::extract(laid, {}, Seed{1}, {});
  for (size_t i = 0; i < laid.size(); ++i) {
    const float ink = drawn.river.data()[i] + drawn.ridge.data()[i] + drawn.cue.data()[i];
    ASSERT_TRUE(ink == 0 || !std::isnan(laid.data()[i]));
  }
  learned::SketchParams params;
  params.ridges = {{{{-3000, 4000}, {0, 3000}, {3200, 3700}}}};
  params.rivers = {{{{-600, -6600}, {300, -9600}}}};
  learned::SketchInputs inputs;
  inputs.terrain = &laid;
  inputs.lines = &drawn.lines;
  for (const uint64_t seed : {1, 2, 3}) {
    const HeightField made = learned::sketch(inputs, params, network, laid.frame(), Seed{seed}, {});
    for (size_t i = 0; i < laid.size(); ++i) {
      ASSERT_TRUE(std::isfinite(made.data()[i]));
      ASSERT_TRUE(std::isnan(laid.data()[i]) || made.data()[i] == laid.data()[i]);
    }
    const Jumps jumps = jumps_of(made, placing.places);
    EXPECT_LT(jumps.rim, 1.05 * 0.5 * (jumps.inside + jumps.outside))
        << jumps.rim << " m, inside " << jumps.inside << " m, outside " << jumps.outside << " m";
  }
}

}  // namespace
}  // namespace seamount::train
