// island.archipelago: several islands in one sea.
//
// Source: P0 sec. 1.5.1 (copy-paste): heights blended by the smooth maximum of eq. 1.15, labels by priority mountain >
// beach > lagoon and reef > abyss.
#pragma once

#include <tuple>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"
#include "seamount/model/label_map.h"

namespace seamount::island {

struct ArchipelagoParams {
  Polyline places;
  std::vector<double> turns_deg;
  std::vector<double> scales;
  double blend_m = 1.0;

  static constexpr auto fields() {
    using P = ArchipelagoParams;
    return std::tuple(
        field(&P::places, "places",
              "where each island's centre goes; a single island is copied to every place; none: islands "
              "stay where they are"),
        field(&P::turns_deg, "turns_deg", "deg", between(-360, 360),
              "how far each island is turned, counter-clockwise; missing ones are 0"),
        field(&P::scales, "scales", "", between(0.05, 5),
              "how much each island is scaled, width and height of its land alike; reefs keep their depths; missing "
              "ones are 1"),
        field(&P::blend_m, "blend_m", "m", between(0.001, 100),
              "how much the smooth maximum exceeds two islands where they are equal"));
  }
};

/// One island on its own frame.
struct Member {
  const HeightField* terrain = nullptr;
  const LabelMap* labels = nullptr;  ///< null: labels of this member are not known
};

struct Archipelago {
  HeightField terrain;
  LabelMap labels;  ///< empty unless every member has labels
};

/// The labels of one island in its place on a frame, abyss around it.
LabelMap placed_labels(const LabelMap& labels, Vec2 place, double turn_deg, double scale, const GridFrame& frame,
                       const RunContext& run);

/// The label that wins where islands overlap.
Region prior_label(Region a, Region b);

/// Blends islands on a frame. All come to lie on one sea floor, the lowest of theirs: what a member has below 60 m or
/// half its depth is stretched down to it, reefs, lagoons and beaches keep their heights whatever the scale, and what
/// is under water fades to the floor along the member's own edge. Where the lagoon of one reaches over the reef of
/// another there is one lagoon, without a wall across it. Throws InvalidArgument for params out of range or a number of
/// places that fits neither one island nor all of them. Parallel; about 15 ns of CPU time per cell and member.
Archipelago archipelago(const std::vector<Member>& members, const ArchipelagoParams& params, const GridFrame& frame,
                        const RunContext& run);

}  // namespace seamount::island
