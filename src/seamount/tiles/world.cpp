#include "seamount/tiles/world.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <sstream>

#include "seamount/base/machine.h"
#include "seamount/recipe/frame_bytes.h"
#include "seamount/recipe/step_work.h"
#include "seamount/recipe/value_bytes.h"
#include "seamount/tiles/windows.h"

namespace seamount::tiles {
namespace {

constexpr double kGigabyte = 1e9;
/// Taken for the machine's memory where that cannot be found out.
constexpr double kUsualMemory = 8e9;

Rect all_of(const GridFrame& frame) { return {0, 0, frame.width, frame.height}; }

/// The least that a rank has: what fits is the same for all of them.
double memory_of(const TileOptions& options, Ranks& ranks) {
  const uint64_t machine = machine_memory();
  const double mine = 0.5 * (machine > 0 ? static_cast<double>(machine) : kUsualMemory) / ranks.on_this_machine();
  const double may_be = options.memory_bytes > 0 ? static_cast<double>(options.memory_bytes) : mine;
  return static_cast<double>(lowest(ranks, static_cast<int64_t>(may_be)));
}

std::string size_text(double bytes) {
  return bytes < 0.1 * kGigabyte ? fmt::format("{:.1f} MB", 1e3 * bytes / kGigabyte)
                                 : fmt::format("{:.1f} GB", bytes / kGigabyte);
}

}  // namespace

World::World(const recipe::Plan& plan, std::string folder, const TileOptions& options, Ranks& ranks)
    : plan_(plan),
      folder_(std::move(folder)),
      options_(options),
      ranks_(&ranks),
      memory_bytes_(memory_of(options, *ranks_)) {}

const GridFrame& World::frame(const OutputOf& output) const {
  const auto value = values_.find(output);
  return value != values_.end() ? *value->second.frame() : rasters_.at(output)->frame();
}

recipe::Value World::window(const OutputOf& output, const Rect& rect) const {
  const auto value = values_.find(output);
  return value != values_.end() ? window_of(value->second, rect) : rasters_.at(output)->read(rect);
}

recipe::Value World::whole(const OutputOf& output) const {
  const auto value = values_.find(output);
  if (value != values_.end()) return value->second;
  const StoredRaster& raster = *rasters_.at(output);
  check_fits(static_cast<double>(raster.frame().cells()) * static_cast<double>(cell_bytes(raster.kind())),
             recipe::step_name(step(output.first)), "is needed as a whole", raster.frame());
  return raster.read(all_of(raster.frame()));
}

void World::rows(const OutputOf& output, int first, int count, void* cells) const {
  const Rect rect{0, first, frame(output).width, count};
  const auto raster = rasters_.find(output);
  if (raster != rasters_.end()) return raster->second->read_to(rect, cells);
  const recipe::Value& value = values_.at(output);
  const size_t row_bytes = static_cast<size_t>(rect.width) * cell_bytes(value.kind());
  std::memcpy(cells, static_cast<const std::byte*>(cells_of(value)) + static_cast<size_t>(first) * row_bytes,
              static_cast<size_t>(count) * row_bytes);
}

void World::keep(const OutputOf& output, const recipe::Value& value) {
  const auto one_tile = int64_t{options_.tile} * options_.tile;
  if (!is_raster(value.kind()) || value.frame()->cells() <= one_tile) {
    values_.insert_or_assign(output, value);
    return;
  }
  const auto raster = on_disk(output, *value.frame());
  for (int tile = 0; tile < raster->layout().count(); ++tile) {
    if (!raster->has(tile)) raster->write(tile, window_of(value, raster->layout().tile(tile)));
  }
  keep_tiles(output, raster);
}

std::shared_ptr<const StoredRaster> World::on_disk(const OutputOf& output, const GridFrame& frame) const {
  return on_disk_as(output, *step(output.first).op->find_out(output.second)->kind, frame);
}

std::shared_ptr<const StoredRaster> World::on_disk_as(const OutputOf& name, const recipe::Kind& kind,
                                                      const GridFrame& frame) const {
  return std::make_shared<const StoredRaster>(folder_of(name), kind, frame, options_.tile);
}

std::string World::folder_of(const OutputOf& name) const {
  const std::string folder = fmt::format("{}.{}.{}", plan_.steps[name.first].key.hex(), name.second, options_.tile);
  return (std::filesystem::path(folder_) / folder).string();
}

void World::keep_tiles(const OutputOf& output, std::shared_ptr<const StoredRaster> tiles) {
  rasters_.insert_or_assign(output, std::move(tiles));
}

bool World::fits(double bytes, const GridFrame& frame) const {
  return bytes <= memory_bytes_ && frame.cells() <= recipe::kMostCells;
}

bool World::fit(const std::vector<OutputOf>& outputs) const {
  return std::all_of(outputs.begin(), outputs.end(), [this](const OutputOf& output) {
    const auto raster = rasters_.find(output);
    if (raster == rasters_.end()) return true;
    const GridFrame& all = raster->second->frame();
    return fits(static_cast<double>(all.cells()) * static_cast<double>(cell_bytes(raster->second->kind())), all);
  });
}

void World::check_fits(double bytes, const std::string& who, const std::string& why, const GridFrame& frame) const {
  if (fits(bytes, frame)) return;
  throw Error(
      fmt::format("{} {}: {} x {} cells take about {}, of which {} may be used. Give more with "
                  "--memory, take larger cells, or run it on a coarse domain of its own and resample what it "
                  "makes",
                  who, why, frame.width, frame.height, size_text(bytes), size_text(memory_bytes_)));
}

void World::share_kept(size_t step) {
  std::ostringstream told;
  recipe::Values small;
  recipe::Writer writer(told);
  if (ranks_->first()) {
    for (const std::string& port : plan_.steps[step].ports) {
      const auto raster = rasters_.find({step, port});
      if (raster == rasters_.end()) {
        small.emplace(port, values_.at({step, port}));
      } else {
        writer.text(port);
        recipe::write_frame(writer, raster->second->frame());
      }
    }
  }
  const std::string large = ranks_->share(told.str());
  std::ostringstream bytes;
  if (ranks_->first()) recipe::write_values(bytes, small);
  std::istringstream shared(ranks_->share(bytes.str()));
  if (ranks_->first()) return;
  std::istringstream frames(large);
  recipe::Reader reader(frames);
  while (reader.left() > 0) {
    const std::string port = reader.text();
    keep_tiles({step, port}, on_disk({step, port}, recipe::read_frame(reader)));
  }
  const auto values = recipe::read_values(shared, *recipe().registry);
  if (!values) throw Error(recipe::step_name(this->step(step)) + ": what it made has not arrived whole");
  for (const auto& [port, value] : *values) values_.insert_or_assign(OutputOf{step, port}, value);
}

void World::forget_tiles() const {
  std::vector<std::shared_ptr<const StoredRaster>> all;
  for (const auto& [output, raster] : rasters_) all.push_back(raster);
  remove_together(*ranks_, all);
}

}  // namespace seamount::tiles
