#include "seamount/tiles/border_flats.h"

#include <algorithm>

namespace seamount::tiles {
namespace {

using geom::kFarAway, geom::kNoFlat;

std::vector<geom::FlatStart> starts_in(const geom::FlowDirections& marked, size_t from) {
  return from == kFromOutlets ? geom::cells_that_drain(marked) : geom::cells_beside_higher(marked);
}

int32_t rims_of(const geom::FlowDirections& codes) { return geom::rim_size(codes.width(), codes.height()); }

}  // namespace

TileFlats look_at_flats(const geom::FlowDirections& marked, const RunContext& run) {
  TileFlats found;
  const auto cells = marked.cells();
  if (std::none_of(cells.begin(), cells.end(), [](uint8_t code) { return code >= geom::kRimFlat; })) return found;
  for (const size_t from : {kFromOutlets, kFromHigher}) {
    geom::FlatSteps steps(marked);
    steps.spread(starts_in(marked, from), run);
    for (int32_t rim = 0; rim < rims_of(marked); ++rim)
      found.steps[from].push_back(steps.of_cell(geom::rim_cell(rim, marked.width(), marked.height())));
  }
  found.links = geom::link_rims(marked, run);
  return found;
}

BorderFlats::BorderFlats(const Layout& layout, const std::vector<int32_t>& first_node)
    : layout_(layout),
      first_node_(first_node),
      linked_(static_cast<size_t>(first_node.back()), 0),
      waits_(static_cast<size_t>(layout.count())),
      walked_(waits_.size()) {
  for (std::vector<int32_t>& of_node : steps_) of_node.assign(linked_.size(), kNoFlat);
  for (std::vector<uint8_t>& of_node : entered_) of_node.assign(linked_.size(), 0);
}

RimPlace BorderFlats::place_of(int32_t node) const {
  const auto next = std::upper_bound(first_node_.begin(), first_node_.end(), node);
  const auto tile = static_cast<int>(next - first_node_.begin()) - 1;
  return {tile, node - first_node_[static_cast<size_t>(tile)]};
}

void BorderFlats::add(int tile, const TileFlats& flats) {
  const int32_t first = first_node_[static_cast<size_t>(tile)];
  for (const size_t from : {kFromOutlets, kFromHigher})
    std::copy(flats.steps[from].begin(), flats.steps[from].end(), steps_[from].begin() + first);
  std::copy(flats.links.linked.begin(), flats.links.linked.end(), linked_.begin() + first);
  for (const geom::FlatLink& link : flats.links.links) told_.push_back({first + link.a, first + link.b, link.steps});
}

/// By the node that they begin at, each link both ways.
void BorderFlats::sort_links() {
  first_link_.assign(linked_.size() + 1, 0);
  for (const geom::FlatLink& link : told_) {
    ++first_link_[static_cast<size_t>(link.a) + 1];
    ++first_link_[static_cast<size_t>(link.b) + 1];
  }
  for (size_t node = 1; node < first_link_.size(); ++node) first_link_[node] += first_link_[node - 1];
  links_.resize(2 * told_.size());
  std::vector<int32_t> next(first_link_.begin(), first_link_.end() - 1);
  for (const geom::FlatLink& link : told_) {
    links_[static_cast<size_t>(next[static_cast<size_t>(link.a)]++)] = {link.b, link.steps};
    links_[static_cast<size_t>(next[static_cast<size_t>(link.b)]++)] = {link.a, link.steps};
  }
  told_ = {};
}

void BorderFlats::settle() {
  sort_links();
  for (const size_t from : {kFromOutlets, kFromHigher}) {
    for (int32_t node = 0; node < static_cast<int32_t>(linked_.size()); ++node)
      if (const int32_t steps = steps_of(from, node); steps != kNoFlat && steps != kFarAway)
        queue_[from].push({steps, node});
    settle(from);
  }
}

/// Is that fewer steps than were known?
bool BorderFlats::lower(size_t from, int32_t node, int64_t steps) {
  int32_t& known = steps_[from][static_cast<size_t>(node)];
  if (steps >= known) return false;
  known = static_cast<int32_t>(steps);
  queue_[from].push({known, node});
  return true;
}

/// Dijkstra: what is reached over borders and links from where there are fewer steps now.
void BorderFlats::settle(size_t from) {
  auto& queue = queue_[from];
  while (!queue.empty()) {
    const int32_t steps = queue.top().first, node = queue.top().second;
    queue.pop();
    if (steps != steps_of(from, node)) continue;
    for (int32_t i = first_link_[static_cast<size_t>(node)]; i < first_link_[static_cast<size_t>(node) + 1]; ++i)
      lower(from, links_[static_cast<size_t>(i)].to, int64_t{steps} + links_[static_cast<size_t>(i)].steps);
    for_each_beyond(layout_, place_of(node), [&](const RimPlace& beyond) {
      const int32_t other = node_of(beyond);
      if (!lower(from, other, int64_t{steps} + 1) || linked_[static_cast<size_t>(other)] != 0) return;
      uint8_t& entered = entered_[from][static_cast<size_t>(other)];
      if (entered == 0) waits_[static_cast<size_t>(beyond.tile)][from].push_back(other);
      entered = 1;
    });
  }
}

std::vector<int> BorderFlats::next_tiles() {
  std::vector<int64_t> fewest(waits_.size(), kFarAway);  // steps with which a tile is entered
  for (size_t tile = 0; tile < waits_.size(); ++tile) {
    for (const size_t from : {kFromOutlets, kFromHigher})
      for (const int32_t node : waits_[tile][from])
        fewest[tile] = std::min(fewest[tile], int64_t{steps_of(from, node)});
  }
  const int64_t up_to = *std::min_element(fewest.begin(), fewest.end()) + layout_.size;
  std::vector<int> tiles;
  for (size_t tile = 0; tile < waits_.size(); ++tile) {
    walked_[tile] = {};
    if (fewest[tile] == kFarAway || fewest[tile] > up_to) continue;
    tiles.push_back(static_cast<int>(tile));
    walked_[tile].swap(waits_[tile]);
    for (const size_t from : {kFromOutlets, kFromHigher})
      for (const int32_t node : walked_[tile][from]) entered_[from][static_cast<size_t>(node)] = 0;
  }
  return tiles;
}

std::vector<Reached> BorderFlats::walk(int tile, const geom::FlowDirections& marked, const RunContext& run) const {
  std::vector<Reached> reached;
  const int32_t first = first_node_[static_cast<size_t>(tile)];
  const auto cell_of = [&](int32_t node) { return geom::rim_cell(node - first, marked.width(), marked.height()); };
  for (const size_t from : {kFromOutlets, kFromHigher}) {
    std::vector<geom::FlatStart> starts;
    for (const int32_t node : walked_[static_cast<size_t>(tile)][from])
      starts.push_back({cell_of(node), steps_of(from, node)});
    if (starts.empty()) continue;
    geom::FlatSteps steps(marked);
    steps.spread(std::move(starts), run);
    for (int32_t node = first; node < first + rims_of(marked); ++node)
      if (const int32_t there = steps.of_cell(cell_of(node)); there < steps_of(from, node))
        reached.push_back({node, static_cast<int32_t>(from), there});
  }
  return reached;
}

void BorderFlats::lower(const std::vector<Reached>& reached) {
  for (const Reached& one : reached) lower(static_cast<size_t>(one.from), one.node, one.steps);
  for (const size_t from : {kFromOutlets, kFromHigher}) settle(from);
}

int BorderFlats::waiting() const {
  return static_cast<int>(std::count_if(waits_.begin(), waits_.end(), [](const Entered& entered) {
    return !entered[kFromOutlets].empty() || !entered[kFromHigher].empty();
  }));
}

/// Of a tile's cells and of those around it.
geom::FlatSteps BorderFlats::all_steps(int tile, const geom::FlowDirections& marked, size_t from,
                                       const RunContext& run) const {
  std::vector<geom::FlatStart> starts = starts_in(marked, from);
  for (int32_t rim = 0; rim < rims_of(marked); ++rim)
    if (const int32_t steps = steps_of(from, node_of({tile, rim})); steps != kNoFlat && steps != kFarAway)
      starts.push_back({geom::rim_cell(rim, marked.width(), marked.height()), steps});
  geom::FlatSteps steps(marked);
  steps.spread(std::move(starts), run);
  const Rect rect = layout_.tile(tile);
  for (int32_t rim = 0; rim < rims_of(marked); ++rim) {
    for_each_beyond(layout_, {tile, rim}, [&](const RimPlace& beyond) {
      const CellPlace at = cell_place(layout_, beyond);
      steps.set(at.column - rect.column, at.row - rect.row, steps_of(from, node_of(beyond)));
    });
  }
  return steps;
}

void BorderFlats::aim(int tile, geom::FlowDirections& marked, const RunContext& run) const {
  geom::aim_rim_flats(marked, all_steps(tile, marked, kFromOutlets, run), all_steps(tile, marked, kFromHigher, run));
}

}  // namespace seamount::tiles
