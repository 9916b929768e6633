// What the ground's cover depends on beyond a place's own height and slope: how open it lies, where water gathers, what
// rain reaches it, how far the sea is, and what labels say.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/label_map.h"

namespace seamount::render {

/// Changes slowly: kept at no more than 1024 cells a side.
struct CoverTexel {
  float sky = 1.0F, concavity = 0.0F;              ///< of light.h
  float wet = 0.0F;                                ///< 0 on ridges and slopes, 1 along valley floors and on wet flats
  float rain = 1.0F;                               ///< over the land's mean
  float shore_m = 0.0F;                            ///< distance to the sea, or in it to land; at most kFarthestShore
  float beach = 0.0F, lagoon = 0.0F, reef = 0.0F;  ///< shares of labels
  friend CoverTexel operator+(CoverTexel a, CoverTexel b) {
    return {a.sky + b.sky,         a.concavity + b.concavity, a.wet + b.wet,       a.rain + b.rain,
            a.shore_m + b.shore_m, a.beach + b.beach,         a.lagoon + b.lagoon, a.reef + b.reef};
  }
  friend CoverTexel operator*(float s, CoverTexel a) {
    return {s * a.sky, s * a.concavity, s * a.wet, s * a.rain, s * a.shore_m, s * a.beach, s * a.lagoon, s * a.reef};
  }
};

inline constexpr float kFarthestShore = 5000.0F;  ///< metres

/// `heights`: over the water, exaggerated. `dry` (may be empty): 1 where ground below the water is no sea floor.
/// `wind_from`: bearing of the wind that brings rain, radians. Labels may be null and of another size.
///
/// Wetness: the topographic wetness index ln(a / tan b) of Beven and Kirkby (1979) of the drained area a metre of
/// contour. Rain: more where the ground rises before the wind, less in the lee of heights, below a line that falls four
/// degrees behind them (a sketch of orographic rain, not a model of it). Parallel; about 120 ns a cell of the kept
/// size.
Grid<CoverTexel> ground_cover(const HeightField& heights, const Mask& dry, const LabelMap* labels, double exaggeration,
                              double wind_from, const RunContext& run);

}  // namespace seamount::render
