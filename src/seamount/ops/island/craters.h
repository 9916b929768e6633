// Craters that somebody drew: hollows at summits that keep their water, while all other land is made to drain.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "seamount/geom/scalar/curve.h"
#include "seamount/model/grid.h"
#include "seamount/ops/island/summits.h"

namespace seamount::island {

/// Those of peaks whose profile, or the island's where they have none, is highest away from the summit.
class Craters {
 public:
  Craters(const std::vector<Peak>& peaks, const geom::CurveFunction& profile);

  /// While it lives the craters of a terrain lie at 0 m, so that what drains into them has an outlet.
  class Hold {
   public:
    Hold(const Craters& craters, HeightField& terrain);
    ~Hold();
    Hold(const Hold&) = delete;
    Hold& operator=(const Hold&) = delete;

   private:
    HeightField& terrain_;
    std::vector<std::pair<int64_t, float>> kept_;
  };

 private:
  struct Crater {
    Vec2 centre;
    double radius_m = 0;
  };
  std::vector<Crater> craters_;
};

}  // namespace seamount::island
