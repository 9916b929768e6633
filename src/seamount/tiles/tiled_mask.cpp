#include "seamount/tiles/tiled_mask.h"

#include <algorithm>
#include <map>

#include "seamount/ops/terrain/mask.h"
#include "seamount/recipe/kinds.h"
#include "seamount/tiles/chain.h"
#include "seamount/tiles/drainage.h"
#include "seamount/tiles/tiled_ways.h"
#include "seamount/tiles/windows.h"

namespace seamount::tiles {
namespace {

constexpr float kLand_m = 9000.0F;  ///< of hollows, as terrain.mask has them

terrain::MaskParams params_of(const recipe::Step& step) {
  recipe::Diagnostics none;
  return recipe::read_params<terrain::MaskParams>(step.params, {"", none});
}

template <class By>
bool selects(const terrain::MaskParams& params) {
  return std::any_of(params.criteria.begin(), params.criteria.end(),
                     [](const terrain::Criterion& one) { return std::holds_alternative<By>(one); });
}

/// The same selection where the input `values` says how high the ground is over the sea.
terrain::MaskParams by_values(terrain::MaskParams params) {
  const auto negative = [](std::optional<double> depth) { return depth ? std::optional(-*depth) : std::nullopt; };
  for (terrain::Criterion& one : params.criteria) {
    if (const auto* by = std::get_if<terrain::ByDepth>(&one)) {
      const terrain::ByValue value{negative(by->high_m), negative(by->low_m), by->falloff_m, by->invert};
      one = value;
    }
  }
  return params;
}

/// The terrain with land in the place of its hollows.
std::shared_ptr<const StoredRaster> over_the_sea(const World& world, const OutputOf& name, const OutputOf& terrain,
                                                 const RunContext& run) {
  const auto stored = world.on_disk_as(name, recipe::kinds::Field::kind(), world.frame(terrain));
  Drainage water(world, name.first, terrain, 0.0F, {}, run);
  try {
    water.find_hollows(run);
  } catch (const NeedsWhole&) {
    throw NeedsWhole{
        "an enclosed water below sea level covers a hundredth of it or more; whether it is sea, only the whole tells"};
  }
  for (int tile = 0; tile < stored->layout().count(); ++tile) {
    run.check_cancelled();
    if (has_unknown(world.window(terrain, stored->layout().tile(tile))))
      throw NeedsWhole{"some heights are unknown, which are filled first"};
    if (!stored->has(tile)) stored->write(tile, recipe::Value::of<recipe::kinds::Field>(water.ground(tile, kLand_m)));
  }
  return stored;
}

LocalStep step_by_values(const World& world, size_t index, const OutputOf& values, const RunContext& run) {
  const auto frame_of = [&world](const OutputOf& output) -> const GridFrame& { return world.frame(output); };
  auto found = locality(world, index, frame_of);
  if (!found) throw NeedsWhole{"what goes with it lies on other cells"};
  const recipe::Step& step = world.step(index);
  found->inputs.push_back({step.op->find_in("values"), values});
  const recipe::Json params = recipe::write_params(by_values(params_of(step)));
  auto local = local_step(world, index, *found, frame_of, run, &params);
  if (!local) throw NeedsWhole{"another criterion looks further than the raster is large"};
  return *local;
}

}  // namespace

std::string mask_refusal(const recipe::Step& step, const recipe::PlannedStep&) {
  const terrain::MaskParams params = params_of(step);
  if (!selects<terrain::ByDepth>(params)) return "some heights are unknown";
  if (step.in.contains("values") || selects<terrain::ByValue>(params))
    return "depth together with value; a mask of its own for each of them goes over borders";
  return step.in.at("terrain").from_file() ? "its terrain comes from a file" : "";
}

void run_tiled_mask(World& world, size_t step, const RunContext& run) {
  const OutputOf terrain = world.output_of(world.step(step).in.at("terrain")), values{step, "-over-sea"};
  world.keep_tiles(values, over_the_sea(world, values, terrain, run.part(0.0, 0.4)));
  const std::map<size_t, LocalStep> alone{{step, step_by_values(world, step, values, run)}};
  std::map<std::string, int> said;
  Chain chain(world, alone, {{step, "mask"}});
  try {
    chain.run([&](size_t, const std::string& line) { ++said[line]; }, run.part(0.4, 1.0));
  } catch (const MeetsUnknown&) {
    throw NeedsWhole{"some cells beside the heights are unknown"};
  }
  const int tiles = Layout(world.frame(terrain), world.tile_size()).count();
  for (const auto& [line, count] : said)
    if (count == tiles) run.say(line);
}

}  // namespace seamount::tiles
