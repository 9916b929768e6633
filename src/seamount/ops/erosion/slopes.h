// Slopes: what is steeper than its material can stand slides, and bedrock crumbles to debris.
//
// Each layer slides at its own angle (slides.h; Benes and Forsbach 2001); bedrock that breaks off is debris from then
// on. Weathering turns bare bedrock into debris where it is steep, less under cover (Cordonnier et al. 2017b). All of
// it moves mass between neighbours only, nothing across the border of the map. Creep is in rivers.h, where it and water
// shape ground together.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/ops/erosion/layers.h"

namespace seamount::erosion {

struct Slopes {
  double years = 0;
  double sediment_angle_deg = 25;
  double debris_angle_deg = 35;
  double bedrock_angle_deg = 50;
  double weathering_m_yr = 0;  ///< bedrock that turns to debris where it stands bare and steep
  int slides = 2;              ///< rounds of sliding
};

/// One step. `share` and `next` are room to work in, of the ground's size. Parallel; about 10 ns per cell and round.
void run_slopes(Layers& ground, const Maps& site, const Slopes& slopes, ScalarField& share, ScalarField& next,
                const RunContext& run);

}  // namespace seamount::erosion
