#include "seamount/geom/contour/chains.h"

#include <limits>

namespace seamount::geom {
namespace {

constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();

/// Follows segments from a crossing on and takes them out of `next`.
ContourChain follow(uint32_t first, std::span<const Crossing> crossings, std::vector<uint32_t>& next,
                    const RunContext& run) {
  ContourChain chain;
  chain.level = crossings[first].level;
  chain.first = first;
  uint32_t at = first;
  do {
    if (chain.points.size() % 65536 == 0) run.check_cancelled();
    chain.points.push_back(crossings[at].at);
    chain.last = at;
    const uint32_t to = next[at];
    next[at] = kNone;
    at = to;
  } while (at != kNone && at != first);
  chain.closed = at == first;
  return chain;
}

}  // namespace

std::vector<ContourChain> join_segments(std::span<const Crossing> crossings, std::span<const ContourSegment> segments,
                                        const RunContext& run) {
  std::vector<uint32_t> next(crossings.size(), kNone);
  std::vector<char> entered(crossings.size(), 0);
  for (const ContourSegment& segment : segments) {
    next[segment.from] = segment.to;
    entered[segment.to] = 1;
  }
  std::vector<ContourChain> chains;
  for (const ContourSegment& segment : segments) {
    if (entered[segment.from] == 0) chains.push_back(follow(segment.from, crossings, next, run));
  }
  for (const ContourSegment& segment : segments) {
    if (next[segment.from] != kNone) chains.push_back(follow(segment.from, crossings, next, run));
  }
  return chains;
}

}  // namespace seamount::geom
