#include "seamount/tiles/tiled_water.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>

#include "seamount/ops/hydrology/fill.h"
#include "seamount/ops/hydrology/flow.h"
#include "seamount/recipe/kinds.h"
#include "seamount/tiles/drainage.h"
#include "seamount/tiles/step_params.h"
#include "seamount/tiles/traced_water.h"
#include "seamount/tiles/windows.h"

namespace seamount::tiles {
namespace {

using recipe::Value;
namespace kinds = recipe::kinds;

/// Outputs that are read, tile by tile.
class Outputs {
 public:
  Outputs(World& world, size_t step, const GridFrame& frame) : world_(world), step_(step) {
    for (const std::string& port : world.plan().steps[step].ports) {
      if (!world.has({step, port}) && is_raster(*world.step(step).op->find_out(port)->kind))
        stored_[port] = world.on_disk({step, port}, frame);
    }
  }

  bool wants(const std::string& port) const { return stored_.contains(port); }
  /// REQUIRES: wants it.
  std::shared_ptr<const StoredRaster> raster(const std::string& port) const { return stored_.at(port); }
  /// As rank 0 sees it.
  bool complete() const {
    const bool all =
        std::all_of(stored_.begin(), stored_.end(), [](const auto& item) { return item.second->complete(); });
    return agreed(world_.ranks(), all);
  }
  bool has(int tile) const {
    return std::all_of(stored_.begin(), stored_.end(), [&](const auto& item) { return item.second->has(tile); });
  }
  void write(const std::string& port, int tile, Grid<float> cells) const {
    const auto& raster = stored_.at(port);
    raster->write(tile, &raster->kind() == &kinds::Terrain::kind() ? Value::of<kinds::Terrain>(std::move(cells))
                                                                   : Value::of<kinds::Field>(std::move(cells)));
  }
  void keep() {
    for (const auto& [port, raster] : stored_) world_.keep_tiles({step_, port}, raster);
  }

 private:
  World& world_;
  size_t step_;
  std::map<std::string, std::shared_ptr<const StoredRaster>> stored_;
};

template <class Function>
ScalarField of_cells(const GridFrame& frame, const Function& function) {
  ScalarField made(frame);
  for (size_t i = 0; i < made.size(); ++i) made.data()[i] = function(i);
  return made;
}

float bearing_deg(uint8_t code) {
  if (code >= 8) return -1.0F;
  const float bearing = 90.0F - 45.0F * static_cast<float>(code);
  return bearing < 0.0F ? bearing + 360.0F : bearing;
}

void write_fill(const Drainage& water, const Outputs& outputs, int tile) {
  HeightField filled = water.filled(tile);
  if (outputs.wants("change")) {
    const HeightField before = water.terrain(tile);
    outputs.write("change", tile,
                  of_cells(filled.frame(), [&](size_t i) { return filled.data()[i] - before.data()[i]; }));
  }
  geom::forget_unknown(filled);
  if (outputs.wants("terrain")) outputs.write("terrain", tile, std::move(filled));
}

void write_flow(const Drainage& water, const Outputs& outputs, int tile) {
  HeightField filled = water.filled(tile);
  const GridFrame frame = filled.frame();
  geom::forget_unknown(filled);
  const auto known = [&](size_t i, float value) {
    return std::isnan(filled.data()[i]) ? std::numeric_limits<float>::quiet_NaN() : value;
  };
  if (outputs.wants("cells") || outputs.wants("area")) {
    const Grid<uint64_t> cells = water.cells(tile);
    const auto cell_m2 = static_cast<float>(frame.cell_m * frame.cell_m);
    const auto count = [&](size_t i) { return known(i, static_cast<float>(cells.data()[i])); };
    if (outputs.wants("cells")) outputs.write("cells", tile, of_cells(frame, count));
    if (outputs.wants("area"))
      outputs.write("area", tile, of_cells(frame, [&](size_t i) { return count(i) * cell_m2; }));
  }
  if (outputs.wants("basins")) {
    const Grid<int32_t> basins = water.basins(tile);
    outputs.write("basins", tile,
                  of_cells(frame, [&](size_t i) { return known(i, static_cast<float>(basins.data()[i])); }));
  }
  if (outputs.wants("direction")) {
    const geom::FlowDirections codes = water.directions(tile);
    outputs.write("direction", tile, of_cells(frame, [&](size_t i) { return known(i, bearing_deg(codes.data()[i])); }));
  }
  if (outputs.wants("terrain")) outputs.write("terrain", tile, std::move(filled));
}

using WriteTile = void (*)(const Drainage& water, const Outputs& outputs, int tile);

void write_all(const Drainage& water, const Outputs& outputs, WriteTile write, const RunContext& run) {
  water.each_tile(run, [&](int tile) {
    if (!outputs.has(tile)) write(water, outputs, tile);
  });
}

RunContext quiet(const RunContext& run) { return {run.threads, {}, run.cancelled, run.note}; }

/// What was traced is rank 0's, which gives it to the others.
void keep_drawing(World& world, const OutputOf& output, Drawing drawing) {
  if (world.ranks().first()) world.keep(output, Value::of<kinds::Drawing>(std::move(drawing)));
}

void fill_or_forget(Drainage& water, const RunContext& run) {
  try {
    water.fill(run);
  } catch (const NeedsWhole&) {  // so do all ranks
    water.forget();
    throw;
  }
}

/// Numbers of catchments, as they are written out or beside that.
std::shared_ptr<const StoredRaster> numbers_on_disk(const World& world, size_t step, const Drainage& water,
                                                    const Outputs& outputs, const RunContext& run) {
  if (outputs.wants("basins")) return outputs.raster("basins");
  auto stored = world.on_disk_as({step, "-numbers"}, kinds::Field::kind(), water.frame());
  water.each_tile(run, [&](int tile) {
    if (stored->has(tile)) return;
    const Grid<int32_t> basins = water.basins(tile);
    stored->write(tile, Value::of<kinds::Field>(
                            of_cells(basins.frame(), [&](size_t i) { return static_cast<float>(basins.data()[i]); })));
  });
  return stored;
}

/// Once the catchments are numbered.
void keep_catchments(World& world, size_t step, const Drainage& water, const Outputs& outputs, const RunContext& run) {
  const double least =
      hydrology::least_catchment_m2(step_params<hydrology::FlowParams>(world.step(step)), water.frame());
  const auto numbers = numbers_on_disk(world, step, water, outputs, run);
  keep_drawing(world, {step, "catchments"}, trace_tiled_catchments(world, water, *numbers, least, run));
  if (!outputs.wants("basins")) remove_together(world.ranks(), std::vector{numbers});
}

}  // namespace

std::string fill_refusal(const recipe::Step& step, const recipe::PlannedStep&) {
  if (step.in.at("terrain").from_file()) return "its terrain comes from a file";
  return step_params<hydrology::FillParams>(step).depressions == hydrology::Depressions::breach
             ? "breaching looks at everything; depressions fill does not"
             : "";
}

std::string flow_refusal(const recipe::Step& step, const recipe::PlannedStep&) {
  if (step.in.at("terrain").from_file()) return "its terrain comes from a file";
  if (step.in.contains("sinks")) return "sinks are looked at from everything";
  return step_params<hydrology::FlowParams>(step).method != hydrology::FlowMethod::d8
             ? "only the method d8 is run in tiles"
             : "";
}

void run_tiled_fill(World& world, size_t step, const RunContext& run) {
  const auto params = step_params<hydrology::FillParams>(world.step(step));
  const OutputOf terrain = world.output_of(world.step(step).in.at("terrain"));
  Outputs outputs(world, step, world.frame(terrain));
  Drainage water(world, step, terrain, params.sea ? 0.0F : geom::kNoSea, params.min_sea_m2, run);
  const bool lakes = world.plan().steps[step].ports.contains("lakes");
  if (lakes || !outputs.complete()) {
    fill_or_forget(water, run.part(0.0, 0.4));
    if (lakes) keep_drawing(world, {step, "lakes"}, trace_tiled_lakes(world, water, params.min_lake_m2, quiet(run)));
    if (params.descend) water.direct(run.part(0.4, 0.6));
    if (params.descend) water.tilt(run.part(0.6, 0.8));
    write_all(water, outputs, write_fill, run.part(0.8, 1.0));
  }
  outputs.keep();
  if (lakes) world.share_kept(step);
  water.forget();
}

void run_tiled_flow(World& world, size_t step, const RunContext& run) {
  const auto params = step_params<hydrology::FlowParams>(world.step(step));
  const OutputOf terrain = world.output_of(world.step(step).in.at("terrain"));
  Outputs outputs(world, step, world.frame(terrain));
  Drainage water(world, step, terrain, params.sea ? 0.0F : geom::kNoSea, params.min_sea_m2, run);
  const bool catchments = world.plan().steps[step].ports.contains("catchments");
  if (catchments || !outputs.complete()) {
    fill_or_forget(water, run.part(0.0, 0.4));
    water.direct(run.part(0.4, 0.6));
    const bool basins = catchments || outputs.wants("basins");
    if (basins || outputs.wants("cells") || outputs.wants("area")) water.gather(run.part(0.6, 0.7));
    if (basins) water.number_basins(run.part(0.7, 0.8));
    write_all(water, outputs, write_flow, run.part(0.8, 1.0));
    if (catchments) keep_catchments(world, step, water, outputs, quiet(run));
  }
  outputs.keep();
  if (catchments) world.share_kept(step);
  water.forget();
}

}  // namespace seamount::tiles
