#include "seamount/tiles/drainage.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/geom/water/groups.h"
#include "seamount/geom/water/inland.h"
#include "seamount/recipe/kinds.h"

namespace seamount::tiles {
namespace {

constexpr double kLargeWater = 0.01;     ///< of the terrain (geom/water/inland.h)
constexpr float kLowestDry_m = 1000.0F;  ///< deeper water is sea

const HeightField& heights_of(const recipe::Value& value) {
  return value.is<recipe::kinds::Terrain>() ? value.get<recipe::kinds::Terrain>() : value.get<recipe::kinds::Field>();
}

}  // namespace

Drainage::Drainage(const World& world, size_t step, OutputOf terrain, float sea_m, std::optional<double> min_sea_m2,
                   const RunContext& run)
    : world_(world),
      step_(step),
      terrain_(std::move(terrain)),
      sea_m_(sea_m),
      min_sea_m2_(min_sea_m2),
      run_{run.threads, {}, run.cancelled, run.note},
      frame_(world.frame(terrain_)),
      layout_(frame_, world.tile_size()) {
  int64_t node = 1;  // 0: the outside
  for (int tile = 0; tile < layout_.count(); ++tile) {
    first_node_.push_back(static_cast<int32_t>(node));
    node += rim_size(layout_, tile);
  }
  first_node_.push_back(static_cast<int32_t>(node));
  if (node > std::numeric_limits<int32_t>::max())
    throw NeedsWhole{"tiles of " + std::to_string(layout_.size) + " cells have too long rims"};
  filled_ = store("-filled");
  codes_ = store("-codes");
}

std::shared_ptr<const StoredRaster> Drainage::store(const std::string& name) const {
  return world_.on_disk_as({step_, name}, recipe::kinds::Field::kind(), frame_);
}

void Drainage::forget() const noexcept {
  filled_->remove();
  codes_->remove();
}

void Drainage::each_tile(const RunContext& run, const std::function<void(int tile)>& body) const {
  for (int tile = 0; tile < layout_.count(); ++tile) {
    run.check_cancelled();
    body(tile);
    run.report((tile + 1.0) / layout_.count());
  }
}

HeightField Drainage::terrain(int tile) const { return heights_of(world_.window(terrain_, layout_.tile(tile))); }

HeightField Drainage::marked(int tile) const { return bed(layout_.tile(tile)); }

HeightField Drainage::bed(const Rect& rect) const {
  HeightField piece = heights_of(world_.window(terrain_, rect));
  for (float& z : piece.cells())
    if (std::isnan(z)) z = geom::kUnknownGround;
  return piece;
}

HeightField Drainage::ground(int tile) const { return ground(tile, std::nextafter(sea_m_, INFINITY)); }

HeightField Drainage::ground(int tile, float hollow_m) const {
  HeightField piece = marked(tile);
  const auto& hollow = hollows_[static_cast<size_t>(tile)];
  if (std::find(hollow.begin(), hollow.end(), true) == hollow.end()) return piece;
  const geom::PieceWaters waters = geom::find_waters(piece, sea_m_, open_sides(layout_, tile), run_);
  for (size_t i = 0; i < piece.size(); ++i) {
    const int32_t water = waters.of.data()[i];
    if (water >= 0 && hollow[static_cast<size_t>(water)]) piece.data()[i] = hollow_m;
  }
  return piece;
}

/// Waters of tiles that hang together over their borders, and which of them are no sea: geom::raise_inland().
void Drainage::find_hollows(const RunContext& run) {
  hollows_.assign(static_cast<size_t>(layout_.count()), {});
  if (std::isinf(sea_m_)) return;
  std::vector<geom::PieceWater> all;
  std::vector<int32_t> first_water, of_rim(static_cast<size_t>(first_node_.back()), -1);
  each_tile(run, [&](int tile) {
    const geom::PieceWaters waters = geom::find_waters(marked(tile), sea_m_, open_sides(layout_, tile), run_);
    const auto first = static_cast<int32_t>(all.size());
    first_water.push_back(first);
    all.insert(all.end(), waters.all.begin(), waters.all.end());
    for (int32_t rim = 0; rim < rim_size(layout_, tile); ++rim) {
      const int32_t water = waters.of.data()[geom::rim_cell(rim, waters.of.width(), waters.of.height())];
      if (water >= 0) of_rim[static_cast<size_t>(node_of({tile, rim}))] = first + water;
    }
  });
  first_water.push_back(static_cast<int32_t>(all.size()));
  geom::Groups groups(static_cast<int32_t>(all.size()));
  for_each_border_pair(layout_, [&](const RimPlace& a, const RimPlace& b) {
    const int32_t one = of_rim[static_cast<size_t>(node_of(a))], other = of_rim[static_cast<size_t>(node_of(b))];
    if (one < 0 || other < 0) return;
    const int32_t x = groups.find(one), y = groups.find(other);
    if (x == y) return;
    groups.join(x, y);
    geom::PieceWater &low = all[static_cast<size_t>(std::min(x, y))], &high = all[static_cast<size_t>(std::max(x, y))];
    low = {low.cells + high.cells, std::min(low.lowest, high.lowest), low.open || high.open};
  });
  const auto is_hollow = [&](const geom::PieceWater& water) {
    if (water.open) return false;
    const auto cells = static_cast<double>(water.cells);
    if (min_sea_m2_) return cells < *min_sea_m2_ / (frame_.cell_m * frame_.cell_m);
    if (cells >= kLargeWater * static_cast<double>(frame_.cells()))
      throw NeedsWhole{
          "a water below sea level without a way to the edge covers a hundredth of it or more; "
          "min_sea_m2 decides what such waters are"};
    return water.lowest >= sea_m_ - kLowestDry_m;
  };
  for (int tile = 0; tile < layout_.count(); ++tile) {
    for (int32_t water = first_water[static_cast<size_t>(tile)]; water < first_water[static_cast<size_t>(tile) + 1];
         ++water)
      hollows_[static_cast<size_t>(tile)].push_back(is_hollow(all[static_cast<size_t>(groups.find(water))]));
  }
}

std::vector<geom::Spill> Drainage::all_spills(const RunContext& run) {
  std::vector<geom::Spill> spills;
  std::vector<float> rim_z(static_cast<size_t>(first_node_.back()));
  std::vector<bool> outside(rim_z.size(), false);
  each_tile(run, [&](int tile) {
    const geom::Flooded flooded = geom::flood_piece(ground(tile), sea_m_, open_sides(layout_, tile), run_);
    const int32_t first = first_node_[static_cast<size_t>(tile)];
    const auto node = [&](int32_t basin) { return basin == 0 ? 0 : first + basin - 1; };
    for (const geom::Spill& spill : flooded.spills) spills.push_back({node(spill.a), node(spill.b), spill.height});
    for (int32_t rim = 0; rim < rim_size(layout_, tile); ++rim) {
      const int32_t cell = geom::rim_cell(rim, flooded.filled.width(), flooded.filled.height());
      rim_z[static_cast<size_t>(first + rim)] = flooded.filled.data()[cell];
      outside[static_cast<size_t>(first + rim)] = flooded.basins.data()[cell] == 0;
    }
  });
  for_each_border_pair(layout_, [&](const RimPlace& a, const RimPlace& b) {
    const auto one = static_cast<size_t>(node_of(a)), other = static_cast<size_t>(node_of(b));
    if (outside[one] && outside[other]) return;
    spills.push_back({outside[one] ? 0 : static_cast<int32_t>(one), outside[other] ? 0 : static_cast<int32_t>(other),
                      std::max(rim_z[one], rim_z[other])});
  });
  return spills;
}

void Drainage::fill_tiles(const std::vector<float>& levels, const RunContext& run) {
  each_tile(run, [&](int tile) {
    if (filled_->has(tile)) return;
    geom::Flooded flooded = geom::flood_piece(ground(tile), sea_m_, open_sides(layout_, tile), run_);
    const int32_t first = first_node_[static_cast<size_t>(tile)];
    for (size_t i = 0; i < flooded.filled.size(); ++i) {
      const int32_t basin = flooded.basins.data()[i];
      if (basin == 0) continue;
      float& z = flooded.filled.data()[i];
      z = std::max(z, levels[static_cast<size_t>(first + basin - 1)]);
    }
    filled_->write(tile, recipe::Value::of<recipe::kinds::Field>(std::move(flooded.filled)));
  });
}

void Drainage::fill(const RunContext& run) {
  if (filled_->complete()) return;
  find_hollows(run.part(0.0, 0.15));
  const std::vector<geom::Spill> spills = all_spills(run.part(0.15, 0.55));
  fill_tiles(geom::overflow_levels(first_node_.back(), spills), run.part(0.55, 1.0));
}

HeightField Drainage::filled_window(const Rect& rect) const { return filled_->read(rect).get<recipe::kinds::Field>(); }

}  // namespace seamount::tiles
