#include "seamount/geom/water/facet.h"

#include "seamount/base/parallel.h"

namespace seamount::geom {

void turn_to_facets(const HeightField& filled, float sea_level_m, Seed seed, FlowDirections& directions,
                    const RunContext& run) {
  const int width = filled.width(), height = filled.height();
  const auto steps = flow_steps(width);
  parallel_rows(run, width, height, [&](int begin, int end) {
    for (int y = std::max(begin, 1); y < std::min(end, height - 1); ++y) {
      for (int x = 1; x + 1 < width; ++x) {
        const auto cell = static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
        uint8_t& way = directions.data()[cell];
        if (way >= kOutlet) continue;
        const float* const here = filled.data() + cell;
        std::array<float, 8> fall{};
        for (size_t k = 0; k < 8; ++k) fall[k] = *here - std::max(sea_level_m, here[steps[k]]);
        const uint8_t turned = steepest_facet(fall, facet_draw(seed, cell));
        if (turned < 8 && fall[turned] > 0) way = turned;
      }
    }
  });
}

}  // namespace seamount::geom
