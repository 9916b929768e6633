// The surface that a reef makes of the ground, row by row: from the kernels' lifts to heights (grow.h has the
// equations).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/geom/grid/upsample_rows.h"
#include "seamount/geom/scalar/curve.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/model/grid.h"
#include "seamount/ops/reef/kernels.h"
#include "seamount/ops/reef/surface_params.h"

namespace seamount::reef {

/// The kernels as tables: N over t = 1 - D / R and E over k1 D / R.
struct KernelTables {
  explicit KernelTables(const KernelParams& params);
  geom::CurveTable normal;
  geom::CurveTable edge;
};

/// A field of a reef that is `none` in most rows, which are then not read.
struct Layer {
  Layer() = default;
  Layer(ScalarField values, float without);

  ScalarField field;          ///< empty: `none` everywhere
  std::vector<uint8_t> rows;  ///< 1 where a row holds more than `none`
  float none = 0.0F;
};

/// What grow() knows about a reef besides its terrain; fields lie on a lattice of their own.
struct Form {
  ScalarField distance;  ///< to the outline, metres, positive inside
  ScalarField crowding;  ///< share of reef in the surroundings
  ScalarField exposure;  ///< 1 windward, -1 in the lee
  Layer lagoon;          ///< metres from the flat into the lagoon behind it, negative on flats and outside
  Layer knolls;          ///< share of the way from a lagoon's floor to the flat
  Layer cays;            ///< 0 ... 1: islets
  Layer passes;          ///< metres of water in passes, 0 outside
  const KernelTables* tables = nullptr;
  std::optional<KernelSums> sums;  ///< of P4's kernels; absent: union
};

/// What shapes the surface: groups of grow()'s parameters.
struct SurfaceParams {
  KernelParams kernel;
  HeightParams heights;
  SandParams sand;
  DetailParams detail;
  double irregularity = 1.0;
  double radius_m = 100.0;  ///< of the kernels
  double low_m = -40.0;     ///< the lowest ground on which corals have light
};

/// Computes rows of the result. Keeps scratch: one per thread. `form` must outlive it.
class SurfaceRows {
 public:
  SurfaceRows(const Form& form, const SurfaceParams& params, const GridFrame& frame, Seed seed);

  /// base -> height and aggregate of row y.
  void row(int y, std::span<const float> base, std::span<float> height, std::span<float> aggregate);

 private:
  bool read_lifts(int y);
  void read_form(double place);
  void read_layer(const Layer& layer, geom::RowUpsampler& rows, double place, std::vector<float>& out) const;
  void add_grooves(int y);

  const Form& form_;
  SurfaceParams params_;
  GridFrame frame_;
  Seed seed_;
  geom::Fbm fine_, relief_;
  geom::RowUpsampler distance_rows_, crowding_rows_, exposure_rows_, lagoon_rows_, knoll_rows_, cay_rows_, pass_rows_,
      above_rows_, below_rows_;
  std::vector<float> distance_, crowding_, exposure_, lagoon_, knoll_, cay_, pass_, above_, below_, fine_noise_,
      relief_noise_, normal_lift_, edge_lift_;
};

}  // namespace seamount::reef
