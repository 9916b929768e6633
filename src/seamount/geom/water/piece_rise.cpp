#include "seamount/geom/water/piece_rise.h"

#include <algorithm>
#include <bit>

#include "seamount/geom/water/pieces.h"

namespace seamount::geom {
namespace {

constexpr int32_t kUnknown = -2;

}  // namespace

int32_t float_number(float height) {
  const auto bits = std::bit_cast<int32_t>(height);
  return bits >= 0 ? bits : -(bits & INT32_MAX);
}

float float_of_number(int32_t number) {
  return number >= 0 ? std::bit_cast<float>(number) : -std::bit_cast<float>(-number);
}

std::vector<RimRise> rim_rises(const HeightField& filled, const FlowDirections& codes, const RunContext& run) {
  const int width = codes.width(), height = codes.height();
  std::vector<RimRise> rises(codes.size(), {kUnknown, 0, 0});
  std::vector<RimRise> of_rim;
  std::vector<int32_t> way;
  for (int32_t rim = 0; rim < rim_size(width, height); ++rim) {
    run.check_cancelled();
    const int32_t first = rim_cell(rim, width, height);
    way.clear();
    for (int32_t cell = first; rises[static_cast<size_t>(cell)].exit == kUnknown;) {
      way.push_back(cell);
      const uint8_t code = codes.data()[cell];
      const int32_t own = float_number(filled.data()[cell]);
      const int x = cell % width, y = cell / width;
      if (code >= 8) {
        rises[static_cast<size_t>(cell)] = {-1, 0, own};
      } else if (!codes.contains(x + kFlowDx[code], y + kFlowDy[code])) {
        rises[static_cast<size_t>(cell)] = {rim_number(x, y, width, height), 1, own};
      } else {
        cell += kFlowDy[code] * width + kFlowDx[code];
        continue;
      }
      way.pop_back();
    }
    for (; !way.empty(); way.pop_back()) {
      const int32_t cell = way.back();
      const uint8_t code = codes.data()[cell];
      const RimRise& next = rises[static_cast<size_t>(cell + kFlowDy[code] * width + kFlowDx[code])];
      rises[static_cast<size_t>(cell)] = {next.exit, next.steps + 1,
                                          std::max(float_number(filled.data()[cell]), next.least + 1)};
    }
    of_rim.push_back(rises[static_cast<size_t>(first)]);
  }
  return of_rim;
}

}  // namespace seamount::geom
