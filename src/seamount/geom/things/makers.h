// One maker for each kind of thing: its mesh as a pure function of size, seed, health and level of detail. What a maker
// draws at random does not depend on health, so that an ailing thing is the same one with less of it: leaves and
// branches that a healthier one has are missing, and what is left is paler. Colours: NATURE's field values in round
// figures, muted.
#pragma once

#include "seamount/base/rng.h"
#include "seamount/geom/things/tone.h"
#include "seamount/model/things.h"

namespace seamount::geom {

struct ThingMaking {
  Seed seed;
  double height_m = 1.0;
  double width_m = 1.0;
  double health = 1.0;  ///< [0, 1]
  int level = 0;        ///< 0 about 1500 triangles, 1 about 300, 2 about 40
  bool own_colour = true;
  Tone colour;  ///< where own_colour is false

  Tone main(unsigned rgb) const { return own_colour ? tone(rgb) : colour; }
  /// One of three by level.
  template <class T>
  T by_level(T fine, T middle, T coarse) const {
    return level == 0 ? fine : level == 1 ? middle : coarse;
  }
  /// Whether a part that was drawn with `lot` in [0, 1) is still there; all of them at health 1, `least` of them at 0.
  bool has(double lot, double least) const { return lot < least + (1.0 - least) * health; }
};

ThingMesh make_rock(const ThingMaking& making);             ///< a boulder of joint planes and grain
ThingMesh make_pebble(const ThingMaking& making);           ///< rounded by water
ThingMesh make_arch(const ThingMaking& making);             ///< a rock arch of beds, its legs apart along x
ThingMesh make_branching_coral(const ThingMaking& making);  ///< staghorn: forked branches with pale tips
ThingMesh make_massive_coral(const ThingMaking& making);    ///< a dome with the relief of brain coral
ThingMesh make_table_coral(const ThingMaking& making);      ///< a plate of branchlets on a stalk
ThingMesh make_foliose_coral(const ThingMaking& making);    ///< whorls of thin plates
ThingMesh make_sea_fan(const ThingMaking& making);          ///< branches in one plane, across y
ThingMesh make_sponge(const ThingMaking& making);           ///< a group of hollow tubes
ThingMesh make_palm(const ThingMaking& making);             ///< coconut: a bent trunk with fronds
ThingMesh make_broadleaf(const ThingMaking& making);        ///< a trunk that forks into clusters of leaves
ThingMesh make_conifer(const ThingMaking& making);          ///< whorls of drooping branches
ThingMesh make_shrub(const ThingMaking& making);            ///< many stems, leaves to the ground
ThingMesh make_mangrove(const ThingMaking& making);         ///< a low crown on stilt roots
ThingMesh make_seagrass(const ThingMaking& making);         ///< a tuft of straps that lean one way
ThingMesh make_kelp(const ThingMaking& making);             ///< stipes with blades along them

}  // namespace seamount::geom
