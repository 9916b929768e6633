// Parts of flats with few rim cells (piece_flats.h).
#include <algorithm>

#include "seamount/geom/water/piece_flats.h"
#include "seamount/geom/water/pieces.h"

namespace seamount::geom {
namespace {

constexpr size_t kMostRims = 32;  ///< of a part whose rim cells are linked
constexpr int64_t kLooks = 16;    ///< at each cell of a piece
constexpr int64_t kLinksOfARimCell = 4;

/// What of the rim flats hangs together within the piece.
struct Part {
  std::vector<int32_t> rims;
  int64_t cells = 0;
  int64_t looks() const { return static_cast<int64_t>(rims.size()) * cells; }
  int64_t links() const { return static_cast<int64_t>(rims.size() * (rims.size() - 1) / 2); }
};

std::vector<Part> find_parts(const FlowDirections& marked, const RunContext& run) {
  const int width = marked.width(), height = marked.height();
  std::vector<Part> parts;
  FlatSteps walked(marked);
  for (int32_t rim = 0; rim < rim_size(width, height); ++rim) {
    const int32_t first = rim_cell(rim, width, height);
    if (walked.of_cell(first) != kFarAway) continue;
    Part part;
    walked.spread({{first, 0}}, run, [&](std::span<const FlatStart> reached) {
      part.cells += static_cast<int64_t>(reached.size());
      for (const FlatStart& one : reached) {
        const int32_t number = rim_number(one.cell % width, one.cell / width, width, height);
        if (number >= 0) part.rims.push_back(number);
      }
    });
    parts.push_back(std::move(part));
  }
  return parts;
}

/// `steps`: kFarAway on the part, before and after.
void link(const Part& part, const FlowDirections& marked, FlatSteps& steps, const RunContext& run, RimLinks& made) {
  const int width = marked.width(), height = marked.height();
  std::vector<int32_t> all;
  for (size_t i = 0; i < part.rims.size(); ++i) {
    made.linked[static_cast<size_t>(part.rims[i])] = 1;
    if (i + 1 == part.rims.size()) return;
    all.clear();
    steps.spread({{rim_cell(part.rims[i], width, height), 0}}, run, [&](std::span<const FlatStart> reached) {
      for (const FlatStart& one : reached) all.push_back(one.cell);
    });
    for (size_t k = i + 1; k < part.rims.size(); ++k)
      made.links.push_back({part.rims[i], part.rims[k], steps.of_cell(rim_cell(part.rims[k], width, height))});
    for (const int32_t cell : all) steps.set(cell % width, cell / width, kFarAway);
  }
}

}  // namespace

RimLinks link_rims(const FlowDirections& marked, const RunContext& run) {
  std::vector<Part> parts = find_parts(marked, run);
  std::stable_sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.looks() < b.looks(); });
  const int32_t rims = rim_size(marked.width(), marked.height());
  int64_t looks = kLooks * static_cast<int64_t>(marked.size()), links = kLinksOfARimCell * rims;
  RimLinks made{{}, std::vector<uint8_t>(static_cast<size_t>(rims), 0)};
  FlatSteps steps(marked);
  for (const Part& part : parts) {
    if (part.rims.size() > kMostRims || part.looks() > looks || part.links() > links) continue;
    looks -= part.looks();
    links -= part.links();
    link(part, marked, steps, run, made);
  }
  return made;
}

}  // namespace seamount::geom
