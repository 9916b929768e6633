#include "seamount/tiles/tiled_mask.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <sstream>

#include "seamount/ops/terrain/mask.h"
#include "seamount/recipe/kinds.h"
#include "seamount/recipe/value_stream.h"
#include "seamount/tiles/chain.h"
#include "seamount/tiles/drainage.h"
#include "seamount/tiles/step_params.h"
#include "seamount/tiles/tiled_ways.h"
#include "seamount/tiles/windows.h"

namespace seamount::tiles {
namespace {

template <class By>
bool selects(const terrain::MaskParams& params) {
  return std::any_of(params.criteria.begin(), params.criteria.end(),
                     [](const terrain::Criterion& one) { return std::holds_alternative<By>(one); });
}

/// The same selection where the input `values` says how high the ground is over the sea.
terrain::MaskParams by_values(terrain::MaskParams params) {
  for (terrain::Criterion& one : params.criteria) {
    if (const auto* by = std::get_if<terrain::ByDepth>(&one)) one = terrain::over_the_sea(*by);
  }
  return params;
}

/// Writes the terrain with land in the place of its hollows. Why it cannot, the same on all ranks; empty: it has.
std::string write_over_the_sea(Drainage& water, Ranks& ranks, const StoredRaster& to, const RunContext& run) {
  try {
    water.find_hollows(run);
  } catch (const NeedsWhole&) {
    return "an enclosed water below sea level covers a hundredth of it or more; whether it is sea, only the whole "
           "tells";
  }
  std::atomic<bool> unknown{false};
  water.each_tile(run, [&](int tile) {
    if (has_unknown(recipe::Value::of<recipe::kinds::Terrain>(water.terrain(tile))))
      unknown = true;
    else if (!to.has(tile))
      to.write(tile, recipe::Value::of<recipe::kinds::Field>(water.ground(tile, terrain::kDryGround_m)));
  });
  return lowest(ranks, unknown ? 0 : 1) == 0 ? "some heights are unknown, which are filled first" : "";
}

std::shared_ptr<const StoredRaster> over_the_sea(const World& world, const OutputOf& name, const OutputOf& terrain,
                                                 const RunContext& run) {
  const auto stored = world.on_disk_as(name, recipe::kinds::Field::kind(), world.frame(terrain));
  Ranks& ranks = world.ranks();
  Drainage water(world, name.first, terrain, 0.0F, {}, run);
  std::string why;
  if (!agreed(ranks, ranks.first() && stored->complete())) why = write_over_the_sea(water, ranks, *stored, run);
  water.forget();
  if (why.empty()) return stored;
  remove_together(ranks, std::vector{stored});
  throw NeedsWhole{why};
}

LocalStep step_by_values(const World& world, size_t index, const OutputOf& values, const RunContext& run) {
  const auto frame_of = [&world](const OutputOf& output) -> const GridFrame& { return world.frame(output); };
  auto found = locality(world, index, frame_of);
  if (!found) throw NeedsWhole{"what goes with it lies on other cells"};
  const recipe::Step& step = world.step(index);
  found->inputs.push_back({step.op->find_in("values"), values});
  const recipe::Json params = recipe::write_params(by_values(step_params<terrain::MaskParams>(step)));
  auto local = local_step(world, index, *found, frame_of, run, &params);
  if (!local) throw NeedsWhole{"another criterion looks further than the raster is large"};
  return *local;
}

/// What tiles say while many threads make them.
class TileNotes {
 public:
  void add(const std::string& line) {
    const std::lock_guard lock(mutex_);
    ++said_[line];
  }
  /// At rank 0: what each of `tiles` has said.
  void say_what_all_have_said(int tiles, Ranks& ranks, const RunContext& run) const {
    std::ostringstream mine;
    recipe::Writer writer(mine);
    for (const auto& [line, count] : said_) {
      writer.text(line);
      writer.plain(int32_t{count});
    }
    std::map<std::string, int> all;
    for (const std::string& of_rank : ranks.gather(mine.str())) {
      std::istringstream bytes(of_rank);
      recipe::Reader reader(bytes);
      while (reader.left() > 0) {
        const std::string line = reader.text();
        all[line] += reader.plain<int32_t>();
      }
    }
    for (const auto& [line, count] : all)
      if (count == tiles) run.say(line);
  }

 private:
  std::mutex mutex_;
  std::map<std::string, int> said_;
};

}  // namespace

std::string mask_refusal(const recipe::Step& step, const recipe::PlannedStep&) {
  const terrain::MaskParams params = step_params<terrain::MaskParams>(step);
  if (!selects<terrain::ByDepth>(params)) return "some heights are unknown";
  if (step.in.contains("values") || selects<terrain::ByValue>(params))
    return "depth together with value; a mask of its own for each of them goes over borders";
  return step.in.at("terrain").from_file() ? "its terrain comes from a file" : "";
}

void run_tiled_mask(World& world, size_t step, const RunContext& run) {
  const OutputOf terrain = world.output_of(world.step(step).in.at("terrain")), values{step, "-over-sea"};
  world.keep_tiles(values, over_the_sea(world, values, terrain, run.part(0.0, 0.4)));
  const std::map<size_t, LocalStep> alone{{step, step_by_values(world, step, values, run)}};
  TileNotes notes;
  Chain chain(world, alone, {{step, "mask"}});
  try {
    chain.run([&](size_t, const std::string& line) { notes.add(line); }, run.part(0.4, 1.0));
  } catch (const MeetsUnknown&) {
    throw NeedsWhole{"some cells beside the heights are unknown"};
  }
  notes.say_what_all_have_said(Layout(world.frame(terrain), world.tile_size()).count(), world.ranks(), run);
}

}  // namespace seamount::tiles
