// The detail that a dictionary gives a terrain at twice its resolution.
#pragma once

#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/ops/amplify/dictionary.h"

namespace seamount::amplify {

class AtomDetail {
 public:
  /// REQUIRES: at least one atom.
  AtomDetail(const Dictionary& dictionary, double strength);

  /// Metres to add on cells of half the size: for shapes two cells apart the detail of their nearest atoms, each
  /// faded over its core by a raised cosine, of which four sum to one everywhere. Its means over the terrain's cells
  /// are not zero. REQUIRES: no NaN. Parallel.
  Grid<float> of(const Grid<float>& terrain, const RunContext& run) const;

 private:
  /// An atom on the ground.
  struct Place {
    int atom;
    float metres;  ///< its detail is multiplied with
    Turn turn;
  };
  /// Those of a row of shapes, whose cores begin two cells west and north of (0, 2 row).
  void find_row(const Grid<float>& around, int row, std::span<Place> places) const;
  /// Adds a row of fine cells, of which row `north` of the cores lies there.
  void add_row(std::span<const Place> places, int north, std::span<float> fine) const;

  AtomTable table_;
  std::vector<Detail> faded_;  ///< with the fading and the strength in them
};

}  // namespace seamount::amplify
