// sketch.extract: the sketch that somebody would have drawn of a terrain: rivers, ridges, and altitude cues.
//
// Source: P1 sec. 5.1, fig. 6 to 8. The terrain is blurred and down-sampled; drops of rain run from every cell by a
// stochastic D8 (stochastic_flow.h). Ridges are the rivers of the inverted terrain. Basins are where many drops
// disappear, peaks the same upside down; both are altitude cues.
//
// Ours: P1 up-samples the cells that many drops pass and thins them, which leaves circles, combs on even slopes and
// lines along the coarse grid. Here each cell has one way on, where most drops go (courses.h), so that lines are trees;
// they begin in a valley, or on a crest, that stands out from the ground beside it, so that plains, lakes and a sea
// without depth stay empty; and they are drawn as smooth strokes in the valley (strokes.h) before they become cells
// (ink.h). Every river reaches the edge, the sea or a basin that is a cue; in the latter a share of the water stays, if
// the terrain itself, and not the blur, has a hollow there. Ridges end where they fade. Land is blurred with land
// alone.
#pragma once

#include <array>
#include <optional>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/geom/water/inland.h"
#include "seamount/model/areas.h"
#include "seamount/model/grid.h"
#include "seamount/model/image.h"

namespace seamount::sketch {

struct ExtractParams {
  std::optional<double> coarse_m;
  std::optional<double> blur_m;
  std::optional<double> min_area_m2;
  std::optional<double> cue_area_m2;
  double leave = 0.3;
  std::optional<double> shallow_m;
  double min_length = 4.0;
  bool sea = true;
  std::optional<double> min_sea_m2;
  bool rivers = true;
  bool ridges = true;
  bool cues = true;

  static constexpr auto fields() {
    using P = ExtractParams;
    return std::tuple(
        field(&P::coarse_m, "coarse_m", "m", between(0.01, 1e6),
              "cell size on which water runs; a 128th of the terrain's longer side if absent"),
        field(&P::blur_m, "blur_m", "m", between(0, 1e6),
              "deviation of the blur before it: how little of the detail is drawn; 0.7 coarse cells if absent"),
        field(&P::min_area_m2, "min_area_m2", "m2", between(1, 1e13),
              "ground whose rain makes a river, or a ridge; a 500th of the land if absent"),
        field(&P::cue_area_m2, "cue_area_m2", "m2", between(1, 1e13),
              "ground whose rain ends in one place and makes it a cue; a 150th of the land if absent"),
        field(&P::leave, "leave", "", between(0, 1), "probability with which a drop leaves a local minimum"),
        field(
            &P::shallow_m, "shallow_m", "m", between(0, 1000),
            "relief that is none: minima no deeper hold no water, and valleys and crests that stand out no more are "
            "not "
            "drawn; if absent, a 200th of all relief (for valleys and crests a twentieth of a coarse cell if less), at "
            "least a hundredth of a coarse cell (10 m at most) and two steps of rounded heights"),
        field(&P::min_length, "min_length", "", between(0, 100),
              "shortest branch and piece that is kept, in coarse cells"),
        field(&P::sea, "sea",
              "rivers end at sea level and ridges stand above it; otherwise the sea floor is ground as well"),
        field(&P::min_sea_m2, "min_sea_m2", "m2", between(0, 1e15), geom::kLeastSeaMeaning),
        field(&P::rivers, "rivers", "draw rivers"), field(&P::ridges, "ridges", "draw ridges"),
        field(&P::cues, "cues", "draw peaks and basins with their heights"));
  }

  static constexpr std::array kFormerNames = {FormerName{"least_sea_m2", "min_sea_m2"}};
};

struct Sketch {
  Mask river;              ///< 1 on the lines, else 0; one cell wide, without holes
  Mask ridge;              ///< the same
  ScalarField altitude_m;  ///< height at the cues, 0 elsewhere
  Mask cue;                ///< 1 where altitude_m counts
  Image image;             ///< ridges red, rivers blue, cues as discs of green_of() their height; nothing: black
  Drawing lines;  ///< value 0: river, 1: ridge, both downstream and joined at their ends; points: cues with height
                  ///< as value, "basin" (1) or not (0), and "green"
  double lowest_cue_m;   ///< height of green 32; 0 without cues
  double highest_cue_m;  ///< height of green 255
};

/// How green a cue is: 32 the lowest, 255 the highest of its sketch, in proportion between; 255 if all are equal. So
/// height = lowest + (green - 32) / 223 (highest - lowest).
uint8_t green_of(double height_m, double lowest_m, double highest_m);

/// Unknown cells (NaN) are not drawn on; water leaves there. Throws InvalidArgument for params out of range. Parallel;
/// memory 36 bytes per cell of the terrain with the result; time about linear in the cells, and in coarse cells times
/// the length of a drop's way.
Sketch extract(const HeightField& terrain, const ExtractParams& params, Seed seed, const RunContext& run);

}  // namespace seamount::sketch
