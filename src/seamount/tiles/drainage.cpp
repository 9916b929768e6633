#include "seamount/tiles/drainage.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/geom/water/groups.h"
#include "seamount/geom/water/inland.h"
#include "seamount/recipe/kinds.h"
#include "seamount/tiles/spread.h"

namespace seamount::tiles {
namespace {

using recipe::kinds::Field, recipe::kinds::Labels, recipe::kinds::Terrain;

constexpr double kLargeWater = 0.01;     ///< of the terrain (geom/water/inland.h)
constexpr float kLowestDry_m = 1000.0F;  ///< deeper water is sea

const HeightField& heights_of(const recipe::Value& value) {
  return value.is<Terrain>() ? value.get<Terrain>() : value.get<Field>();
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
  flooded_ = raster("-flooded", Field::kind());
  basins_ = raster("-basins", Field::kind());   // rims have fewer than 2^24 cells: a float holds their numbers
  marked_ = raster("-marked", Labels::kind());  // a byte a cell
  directions_ = raster("-directions", Labels::kind());
  waters_ = notes("-waters");
  spills_ = notes("-spills");
  flats_ = notes("-rim_flats");
  walks_ = notes("-walks");
  rises_ = notes("-rises");
  exits_ = notes("-exits");
  ends_ = notes("-ends");
}

Drainage::Raster Drainage::raster(const std::string& name, const recipe::Kind& kind) const {
  return world_.on_disk_as({step_, name}, kind, frame_);
}

std::shared_ptr<const StoredNotes> Drainage::notes(const std::string& name) const {
  return std::make_shared<const StoredNotes>(world_.folder_of({step_, name}), layout_.count());
}

void Drainage::forget() const {
  remove_together(world_.ranks(), std::vector<Raster>{flooded_, basins_, marked_, directions_});
  remove_together(world_.ranks(), std::vector<Notes>{waters_, spills_, flats_, walks_, rises_, exits_, ends_});
}

/// Is something there on the disk? All ranks get the answer of the first.
bool Drainage::all_have(const std::function<bool()>& complete) const {
  return agreed(world_.ranks(), world_.ranks().first() && complete());
}

void Drainage::each_tile(const RunContext& run, const std::function<void(int tile)>& body) const {
  constexpr double kBytes = 48;  // of a cell, while its tile is flooded
  const int pieces = at_once(kBytes * layout_.size * layout_.size, world_.memory_bytes(), run);
  spread(world_.ranks(), run, layout_.count(), pieces, [&](int tile, const RunContext&) {
    body(tile);
    return true;
  });
}

HeightField Drainage::terrain(int tile) const { return heights_of(world_.window(terrain_, layout_.tile(tile))); }

HeightField Drainage::bed(const Rect& rect) const {
  HeightField piece = heights_of(world_.window(terrain_, rect));
  for (float& z : piece.cells())
    if (std::isnan(z)) z = geom::kUnknownGround;
  return piece;
}

HeightField Drainage::ground(int tile) const { return ground(tile, std::nextafter(sea_m_, INFINITY)); }

HeightField Drainage::ground(int tile, float hollow_m) const {
  HeightField piece = bed(layout_.tile(tile));
  if (hollows_.empty()) return piece;
  const auto& hollow = hollows_[static_cast<size_t>(tile)];
  if (std::find(hollow.begin(), hollow.end(), true) == hollow.end()) return piece;
  const geom::PieceWaters waters = geom::find_waters(piece, sea_m_, open_sides(layout_, tile), run_);
  for (size_t i = 0; i < piece.size(); ++i) {
    const int32_t water = waters.of.data()[i];
    if (water >= 0 && hollow[static_cast<size_t>(water)]) piece.data()[i] = hollow_m;
  }
  return piece;
}

bool Drainage::is_hollow(const geom::PieceWater& water) const {
  if (water.open) return false;
  const auto cells = static_cast<double>(water.cells);
  if (min_sea_m2_) return cells < *min_sea_m2_ / (frame_.cell_m * frame_.cell_m);
  if (cells >= kLargeWater * static_cast<double>(frame_.cells()))
    throw NeedsWhole{
        "a water below sea level without a way to the edge covers a hundredth of it or more; "
        "min_sea_m2 decides what such waters are"};
  return water.lowest >= sea_m_ - kLowestDry_m;
}

/// Waters of tiles that hang together over their borders, and which of them are no sea: geom::raise_inland().
void Drainage::find_hollows(const RunContext& run) {
  if (std::isinf(sea_m_)) return;
  each_tile(run, [&](int tile) {
    if (waters_->has(tile)) return;
    const geom::PieceWaters waters =
        geom::find_waters(bed(layout_.tile(tile)), sea_m_, open_sides(layout_, tile), run_);
    std::vector<int32_t> of_rim(static_cast<size_t>(rim_size(layout_, tile)));
    for (int32_t rim = 0; rim < static_cast<int32_t>(of_rim.size()); ++rim)
      of_rim[static_cast<size_t>(rim)] = waters.of.data()[geom::rim_cell(rim, waters.of.width(), waters.of.height())];
    waters_->write(tile, waters.all, of_rim);
  });
  std::vector<geom::PieceWater> all, own;
  std::vector<int32_t> first_water, of_rim, water_of(static_cast<size_t>(first_node_.back()), -1);
  for (int tile = 0; tile < layout_.count(); ++tile) {
    waters_->read(tile, own, of_rim);
    const auto first = static_cast<int32_t>(all.size());
    first_water.push_back(first);
    all.insert(all.end(), own.begin(), own.end());
    for (size_t rim = 0; rim < of_rim.size(); ++rim) {
      if (of_rim[rim] >= 0)
        water_of[static_cast<size_t>(node_of({tile, static_cast<int32_t>(rim)}))] = first + of_rim[rim];
    }
  }
  first_water.push_back(static_cast<int32_t>(all.size()));
  geom::Groups groups(static_cast<int32_t>(all.size()));
  for_each_border_pair(layout_, [&](const RimPlace& a, const RimPlace& b) {
    const int32_t one = water_of[static_cast<size_t>(node_of(a))], other = water_of[static_cast<size_t>(node_of(b))];
    if (one < 0 || other < 0) return;
    const int32_t x = groups.find(one), y = groups.find(other);
    if (x == y) return;
    groups.join(x, y);
    geom::PieceWater &low = all[static_cast<size_t>(std::min(x, y))], &high = all[static_cast<size_t>(std::max(x, y))];
    low = {low.cells + high.cells, std::min(low.lowest, high.lowest), low.open || high.open};
  });
  hollows_.assign(static_cast<size_t>(layout_.count()), {});
  for (int tile = 0; tile < layout_.count(); ++tile) {
    for (int32_t water = first_water[static_cast<size_t>(tile)]; water < first_water[static_cast<size_t>(tile) + 1];
         ++water)
      hollows_[static_cast<size_t>(tile)].push_back(is_hollow(all[static_cast<size_t>(groups.find(water))]));
  }
}

void Drainage::flood_tiles(const RunContext& run) {
  each_tile(run, [&](int tile) {
    if (spills_->has(tile) && flooded_->has(tile) && basins_->has(tile)) return;
    geom::Flooded flooded = geom::flood_piece(ground(tile), sea_m_, open_sides(layout_, tile), run_);
    const int32_t first = first_node_[static_cast<size_t>(tile)];
    const auto node = [&](int32_t basin) { return basin == 0 ? 0 : first + basin - 1; };
    for (geom::Spill& spill : flooded.spills) spill = {node(spill.a), node(spill.b), spill.height};
    std::vector<float> rim_z;
    std::vector<uint8_t> outside;
    for (int32_t rim = 0; rim < rim_size(layout_, tile); ++rim) {
      const int32_t cell = geom::rim_cell(rim, flooded.filled.width(), flooded.filled.height());
      rim_z.push_back(flooded.filled.data()[cell]);
      outside.push_back(flooded.basins.data()[cell] == 0 ? 1 : 0);
    }
    ScalarField basins(flooded.basins.frame());
    std::copy(flooded.basins.cells().begin(), flooded.basins.cells().end(), basins.cells().begin());
    flooded_->write(tile, recipe::Value::of<Field>(std::move(flooded.filled)));
    basins_->write(tile, recipe::Value::of<Field>(std::move(basins)));
    spills_->write(tile, flooded.spills, rim_z, outside);
  });
}

/// From what all tiles say of their spills, and the spills over their borders.
void Drainage::find_levels() {
  std::vector<geom::Spill> spills, own;
  std::vector<float> rim_z(static_cast<size_t>(first_node_.back())), z;
  std::vector<uint8_t> outside(rim_z.size(), 0), out;
  for (int tile = 0; tile < layout_.count(); ++tile) {
    run_.check_cancelled();
    spills_->read(tile, own, z, out);
    spills.insert(spills.end(), own.begin(), own.end());
    std::copy(z.begin(), z.end(), rim_z.begin() + first_node_[static_cast<size_t>(tile)]);
    std::copy(out.begin(), out.end(), outside.begin() + first_node_[static_cast<size_t>(tile)]);
  }
  for_each_border_pair(layout_, [&](const RimPlace& a, const RimPlace& b) {
    const auto one = static_cast<size_t>(node_of(a)), other = static_cast<size_t>(node_of(b));
    if (outside[one] != 0 && outside[other] != 0) return;
    spills.push_back({outside[one] != 0 ? 0 : static_cast<int32_t>(one),
                      outside[other] != 0 ? 0 : static_cast<int32_t>(other), std::max(rim_z[one], rim_z[other])});
  });
  levels_ = geom::overflow_levels(first_node_.back(), std::move(spills));
}

void Drainage::fill(const RunContext& run) {
  find_hollows(run.part(0.0, 0.2));
  flood_tiles(run.part(0.2, 1.0));
  find_levels();
}

HeightField Drainage::filled_window(const Rect& rect) const {
  HeightField z = flooded_->read(rect).get<Field>();
  const recipe::Value basins = basins_->read(rect);
  const float* basin = basins.get<Field>().data();
  for (int y = 0; y < rect.height; ++y) {
    const int row_of_tiles = (rect.row + y) / layout_.size * layout_.columns();
    for (int x = 0; x < rect.width;) {
      const int tile = row_of_tiles + (rect.column + x) / layout_.size;
      const int end = std::min(rect.width, ((rect.column + x) / layout_.size + 1) * layout_.size - rect.column);
      const float* levels = levels_.data() + first_node_[static_cast<size_t>(tile)] - 1;
      for (; x < end; ++x, ++basin) {
        if (*basin != 0.0F) z(x, y) = std::max(z(x, y), levels[static_cast<int32_t>(*basin)]);
      }
    }
  }
  return z;
}

}  // namespace seamount::tiles
