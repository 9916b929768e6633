// What a network sees of a map: planes, made a band of rows at a time so that a large map is never held sixteen times.
#pragma once

#include <functional>
#include <span>

namespace seamount::learned {

/// Input planes of a map. fill(begin, end, values) writes rows [begin, end) of all planes, channels last:
/// values[((y - begin) width + x) planes + plane]. Called for rows of the map only, by several threads at once, and
/// more than once for a row; the same row must get the same numbers each time.
struct Planes {
  int width = 0, height = 0, count = 0;
  std::function<void(int begin, int end, std::span<float> values)> fill;
};

}  // namespace seamount::learned
