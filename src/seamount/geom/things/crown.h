// Crowns of leaves in clusters, for trees, shrubs and mangroves.
#pragma once

#include <vector>

#include "seamount/geom/things/makers.h"
#include "seamount/geom/things/thing_builder.h"

namespace seamount::geom {

struct Cluster {
  Point3 centre;
  double radius = 0.2;
  double flat = 0.8;  ///< height over width
  double lot = 0.0;   ///< when it dies
};

struct CrownStyle {
  Tone leaf, autumn;  ///< alive, and dying
  Point3 middle;      ///< of the crown
  double top = 1.0, bottom = 0.3;
  int leaves = 600;         ///< of all clusters, at the finest level
  double leaf_size = 0.05;  ///< half its length
};

/// Leaves of a crown by level: many leaves around dark cores, blobs, or one blob for each few clusters.
void add_crown(ThingBuilder& builder, const ThingMaking& making, const CrownStyle& style,
               const std::vector<Cluster>& clusters);

/// A limb: a tapered tube with a bend.
void add_limb(ThingBuilder& builder, Point3 from, Point3 to, double radius, double end_radius, int sides, Tone bark,
              Point3 bend = {});

}  // namespace seamount::geom
