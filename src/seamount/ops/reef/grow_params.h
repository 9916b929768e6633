// Parameters of reef.grow (grow.h). Heights are metres about sea level, bearings clockwise from north.
#pragma once

#include <array>
#include <optional>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/ops/reef/habitat_params.h"
#include "seamount/ops/reef/surface_params.h"
#include "seamount/ops/reef/walk_params.h"

namespace seamount::reef {

/// What is done to the terrain at the end (P4).
struct FinishParams {
  double blur_m = 0.0;
  bool normalise = false;
  double low_m = -250.0;
  double high_m = 250.0;

  static constexpr auto fields() {
    using P = FinishParams;
    const Range height = between(-12000, 9000);
    return std::tuple(field(&P::blur_m, "blur_m", "m", between(0, 1e5), "blur of the result; 0: none"),
                      field(&P::normalise, "normalise", "stretch the result to low_m ... high_m"),
                      field(&P::low_m, "low_m", "m", height, "lowest height after normalising"),
                      field(&P::high_m, "high_m", "m", height, "highest height after normalising"));
  }
};

struct GrowParams {
  std::optional<double> lattice_m;
  int particles = 0;
  double irregularity = 1.0;
  double swell_from_deg = 130.0;
  std::optional<double> lagoon_gap_m;
  StartParams starts;
  BoundParams bounds;
  WalkParams walk;
  KernelParams kernel;
  HeightParams heights;
  SandParams sand;
  PassParams passes;
  DetailParams detail;
  FinishParams finish;

  static constexpr auto fields() {
    using P = GrowParams;
    return std::tuple(
        field(&P::lattice_m, "lattice_m", "m", between(0.1, 1e6),
              "cell of the lattice on which particles walk and settle; if absent 70, or the terrain's cells or 1 / "
              "2048 of "
              "it where those are larger"),
        field(&P::particles, "particles", "", between(0, 4000000),
              "particles to shoot; 0: one for 8 cells of wide habitat, one for 2 along its rim"),
        field(&P::irregularity, "irregularity", "", between(0, 1),
              "how far particles, radii and outlines depart from the lattice"),
        field(&P::swell_from_deg, "swell_from_deg", "deg", between(-360, 360), "bearing from which the swell comes"),
        field(&P::lagoon_gap_m, "lagoon_gap_m", "m", between(0, 1e6),
              "water behind passes up to this width is labelled lagoon; 2 kernel radii if absent"),
        field(&P::starts, "starts", "where growth starts"), field(&P::bounds, "bounds", "where particles may settle"),
        field(&P::walk, "walk", "how particles come to the reef"),
        field(&P::kernel, "kernel", "shape of the reef around each particle"),
        field(&P::heights, "heights", "how far the reef lifts the ground"), field(&P::sand, "sand", "lagoons and cays"),
        field(&P::passes, "passes", "ways from lagoons to the open sea"),
        field(&P::detail, "detail", "unevenness of the reef"),
        field(&P::finish, "finish", "blur and range of the result"));
  }

  static constexpr std::array kFormerNames = {FormerName{"kernels", "starts.points"},
                                              FormerName{"line", "starts.line"},
                                              FormerName{"kernel_height_m", "starts.contour_m"},
                                              FormerName{"line_cover", "starts.line_cover"},
                                              FormerName{"segment_m", "starts.segment_m"},
                                              FormerName{"random_kernels", "starts.random"},
                                              FormerName{"habitat_low_m", "bounds.low_m"},
                                              FormerName{"habitat_high_m", "bounds.high_m"},
                                              FormerName{"margin_m", "bounds.margin_m"},
                                              FormerName{"stickiness", "walk.stickiness"},
                                              FormerName{"launch", "walk.launch"},
                                              FormerName{"current", "walk.current"},
                                              FormerName{"current_to_deg", "walk.current_to_deg"},
                                              FormerName{"max_steps", "walk.max_steps"},
                                              FormerName{"kernel_radius_m", "kernel.radius_m"},
                                              FormerName{"combine", "kernel.combine"},
                                              FormerName{"k", "kernel.k"},
                                              FormerName{"k1", "kernel.k1"},
                                              FormerName{"k1_jitter", "kernel.k1_jitter"},
                                              FormerName{"k2", "kernel.k2"},
                                              FormerName{"lift", "heights.mode"},
                                              FormerName{"flat_m", "heights.flat_m"},
                                              FormerName{"crest_m", "heights.crest_m"},
                                              FormerName{"lift_m", "heights.lift_m"},
                                              FormerName{"rim_m", "heights.rim_m"},
                                              FormerName{"lee_rim", "heights.lee_rim"},
                                              FormerName{"w0", "heights.w0"},
                                              FormerName{"w1", "heights.w1"},
                                              FormerName{"w2", "heights.w2"},
                                              FormerName{"datum_m", "heights.datum_m"},
                                              FormerName{"lagoon_m", "sand.lagoon_m"},
                                              FormerName{"lagoon_fill", "sand.fill"},
                                              FormerName{"cays", "sand.cays"},
                                              FormerName{"cay_m", "sand.cay_m"},
                                              FormerName{"relief_m", "detail.relief_m"},
                                              FormerName{"grooves_m", "detail.grooves_m"},
                                              FormerName{"blur_m", "finish.blur_m"},
                                              FormerName{"normalise", "finish.normalise"},
                                              FormerName{"normalised_low_m", "finish.low_m"},
                                              FormerName{"normalised_high_m", "finish.high_m"}};
};

}  // namespace seamount::reef
