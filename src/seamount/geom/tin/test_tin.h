// Networks for tests: a lattice whose nodes are moved about and whose squares are split at random.
#pragma once

#include "seamount/base/rng.h"
#include "seamount/model/tin.h"

namespace seamount::geom {

template <class Height>
Tin lattice_tin(int width, int height, double cell_m, Seed seed, Height&& height_at) {
  Tin tin;
  tin.frame = GridFrame::centred(width - 1, height - 1, cell_m);
  Rng rng(seed);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double reach = 0.24 * cell_m;
      Vec2 p{tin.frame.west_m + x * cell_m, tin.frame.south_m() + y * cell_m};
      if (x > 0 && x + 1 < width) p.x += rng.uniform(-reach, reach);
      if (y > 0 && y + 1 < height) p.y += rng.uniform(-reach, reach);
      tin.nodes.push_back(p);
      tin.height_m.push_back(static_cast<float>(height_at(p)));
    }
  }
  for (int y = 0; y + 1 < height; ++y) {
    for (int x = 0; x + 1 < width; ++x) {
      const int32_t a = y * width + x, b = a + 1, c = b + width, d = a + width;
      if (rng.chance(0.5)) {
        tin.triangles.insert(tin.triangles.end(), {{a, b, c}, {a, c, d}});
      } else {
        tin.triangles.insert(tin.triangles.end(), {{a, b, d}, {b, c, d}});
      }
    }
  }
  return tin;
}

}  // namespace seamount::geom
