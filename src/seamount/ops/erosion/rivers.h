// Rivers and the slopes above them: rain gathers, cuts into the ground, carries what it cut, and drops it where the
// slope gives out; soil creeps, and what stands too steep over the valleys fails.
//
//   dh/dt = - K sqrt(Q) dh/dx  +  G q_s / Q  +  div(D grad(h) / (1 - |grad(h)|^2 / S^2)),   |dh/dx| <= S sqrt(hardness)
//
// (Davy and Lague 2009; Yuan, Braun, Guerit, Rouby, Cordonnier 2019; Roering, Kirchner and Dietrich 1999 for creep, by
// the slope towards each neighbour before the step, quickened tenfold at most) with Q the discharge (m3 per year), q_s
// the load (m3 per year), K by the material on top of each cell, and S the slope at which bedrock fails (repose.h). All
// of it is one implicit step from the outlets up (Braun and Willett 2013), so that any time step is stable and rivers
// and slopes agree in each: taken one after the other, creep would fill in a long step the valleys that rivers keep
// open. Gauss-Seidel sweeps make erosion, deposition and creep agree (Yuan et al.), and a last sweep downstream moves
// exactly what there is, so mass is conserved to rounding: what creep and failing slopes lose goes with the water and
// comes to lie where creep or rivers ask for it. Departures: the exponents are m = 1/2 and n = 1; layers wear one after
// the other within a step; there is no channel below a discharge Q_c, and what creeps into one is carried off as if it
// were no part of the bed, whose true width is far below a cell's, but for hollows of an area A with K A / D below
// about 1, which creep fills (Perron, Kirchner and Dietrich 2009); land begins as high over its outlets as the ground
// of a cell stands over its channel, so that coarse cells keep the volume of fine ones; lakes are filled up to their
// water level before anything flows out of them; beds do not rise far above both of their banks; where a river leaves
// its banks on gentle ground, G grows by the width of the fan over that of a cell, since a river wanders over all of
// its fan in the years of a step, and a cell's width of bed would let nearly all of the load pass.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/ops/erosion/drainage.h"
#include "seamount/ops/erosion/layers.h"

namespace seamount::erosion {

struct Rivers {
  double years = 0;          ///< length of the step
  double runoff_m_yr = 1;    ///< runoff
  double loss_per_km = 0;    ///< share of the discharge that evaporates on a kilometre
  double erodibility = 0;    ///< K of bedrock
  double debris_ease = 2;    ///< K of debris over that of bedrock
  double sediment_ease = 4;  ///< K of sediment over that of bedrock
  double deposition = 1;     ///< G
  double fan_m = 0;          ///< width over which a river lays down its load where no banks hold it and it is not steep
  double channel_m2 = 0;     ///< area whose runoff is Q_c; of a strip as long as its root where cells are narrower
  double creep_m2_yr = 0;    ///< D
  double steepest = 1e9;     ///< S, rise over run
  double hardness_variation = 0;  ///< 0 to 0.95: how unevenly rock stands (repose.h)
  Seed rock;                      ///< where it is weak
  double uplift_m = 0;            ///< by which the ground has just risen, times the maps; where sweeps begin
  double sea_m = 0;
  int sweeps = 2;  ///< of Gauss-Seidel, >= 1
};

/// Discharge of each cell in m3 per year.
void gather(const Drainage& drainage, const Maps& site, const Rivers& rivers, ScalarField& discharge,
            const RunContext& run);

/// One step of erosion and deposition. After it `load` holds, in metres of thickness on its cell, what arrived at each
/// sea cell, and `level` what was laid down on each cell of land. What arrived at outlets of the border is added to
/// ledger.exported.
void run_rivers(Layers& ground, const Maps& site, const Drainage& drainage, const ScalarField& discharge,
                const Rivers& rivers, ScalarField& load, ScalarField& level, Ledger& ledger, const RunContext& run);

}  // namespace seamount::erosion
