#include "seamount/geom/water/facet.h"

#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"

namespace seamount::geom {
namespace {

/// One facet, as steepest_facet() sees it.
SEAMOUNT_INLINE void look_at(float ahead, float across, float straight, float turn, float& steepest, float& way) {
  const float aside = across - ahead, square = ahead * std::abs(ahead), corner = 0.5F * across * std::abs(across);
  const bool inside = aside > 0 && aside < ahead;
  const float here = inside ? square + aside * aside : std::max(square, corner);
  const float turned = inside ? aside / ahead : corner > square ? 1.0F : 0.0F;
  way = here > steepest ? straight + turn * turned : way;
  steepest = std::max(here, steepest);
}

/// The direction of steepest_facet() in eighths of a circle for cells [1, width - 1) of a row, -1 where none falls.
SEAMOUNT_VECTORISED void find_ways(const float* north, const float* here, const float* south, float sea, int width,
                                   float* ways) {
  for (int x = 1; x < width - 1; ++x) {
    const float z = here[x];
    const float e = z - std::max(sea, here[x + 1]), ne = z - std::max(sea, north[x + 1]),
                n = z - std::max(sea, north[x]), nw = z - std::max(sea, north[x - 1]),
                w = z - std::max(sea, here[x - 1]), sw = z - std::max(sea, south[x - 1]),
                s = z - std::max(sea, south[x]), se = z - std::max(sea, south[x + 1]);
    float steepest = 0, way = -9;
    look_at(e, ne, 0, 1, steepest, way);
    look_at(e, se, 0, -1, steepest, way);
    look_at(n, nw, 2, 1, steepest, way);
    look_at(n, ne, 2, -1, steepest, way);
    look_at(w, sw, 4, 1, steepest, way);
    look_at(w, nw, 4, -1, steepest, way);
    look_at(s, se, 6, 1, steepest, way);
    look_at(s, sw, 6, -1, steepest, way);
    ways[x] = way;
  }
}

}  // namespace

void turn_to_facets(const HeightField& filled, float sea_level_m, Seed seed, FlowDirections& directions,
                    const RunContext& run) {
  const int width = filled.width(), height = filled.height();
  const auto steps = flow_steps(width);
  parallel_rows(run, width, height, [&](int begin, int end) {
    std::vector<float> ways(static_cast<size_t>(width));
    for (int y = std::max(begin, 1); y < std::min(end, height - 1); ++y) {
      const float* const row = filled.row(y).data();
      find_ways(row - width, row, row + width, sea_level_m, width, ways.data());
      for (int x = 1; x + 1 < width; ++x) {
        const auto cell = static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
        uint8_t& way = directions.data()[cell];
        const float turned = ways[static_cast<size_t>(x)];
        if (way >= kOutlet || turned < -8) continue;
        const unsigned drawn = static_cast<unsigned>(turned + 8.0F + facet_draw(seed, cell)) & 7U;
        if (std::max(sea_level_m, row[x + steps[drawn]]) < row[x]) way = static_cast<uint8_t>(drawn);
      }
    }
  });
}

}  // namespace seamount::geom
