#include "seamount/tiles/reduced_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "seamount/recipe/kinds.h"
#include "seamount/recipe/step_work.h"
#include "seamount/tiles/tiled_resample.h"
#include "seamount/tiles/windows.h"

namespace seamount::tiles {
namespace {

namespace kinds = recipe::kinds;

/// Pixels along the longer side that a step of the family render is asked for.
int pixels_of(const recipe::Json& params) {
  int most = 0;
  for (const char* name : {"size_px", "width_px", "height_px"}) {
    const auto found = params.find(name);
    if (found != params.end() && found->is_number()) most = std::max(most, found->get<int>());
  }
  return most;
}

/// Every `factor` cells of a frame as one; the last ones may reach beyond it.
GridFrame reduced_frame(const GridFrame& frame, int factor) {
  const auto parts = [&](int cells) { return (cells + factor - 1) / factor; };
  return {parts(frame.width), parts(frame.height), frame.cell_m * factor, frame.west_m, frame.north_m, frame.crs};
}

/// The smallest number of cells that are taken together so that the rest fits and is not much finer than the picture.
int factor_of(const World& world, const recipe::Step& step, const GridFrame& frame) {
  constexpr double kBytesACell = 10 * sizeof(float);  // rasters, and what drawing takes besides
  constexpr int kFinest = 4096;
  const int finest = std::max(kFinest, 2 * pixels_of(step.params));
  int factor = 2;
  for (;; ++factor) {
    const GridFrame reduced = reduced_frame(frame, factor);
    if (reduced.cells() == 1) return factor;
    if (std::max(reduced.width, reduced.height) <= finest &&
        world.fits(kBytesACell * static_cast<double>(reduced.cells()), reduced))
      return factor;
  }
}

LabelMap reduced_labels(const World& world, const OutputOf& from, const GridFrame& frame, const GridFrame& target,
                        int factor) {
  LabelMap labels(target);
  std::vector<Region> row(static_cast<size_t>(frame.width));
  const auto middle = [&](int i, int cells) { return std::min(i * factor + factor / 2, cells - 1); };
  for (int y = 0; y < target.height; ++y) {
    world.rows(from, middle(y, frame.height), 1, row.data());
    for (int x = 0; x < target.width; ++x) labels(x, y) = row[static_cast<size_t>(middle(x, frame.width))];
  }
  return labels;
}

}  // namespace

std::string picture_refusal(const recipe::Step& step, const recipe::PlannedStep&) {
  for (const auto& [port, source] : step.in) {
    if (source.from_file() && is_raster(*step.op->find_in(port)->kind)) return "its " + port + " comes from a file";
  }
  return "";
}

void run_reduced_picture(World& world, size_t index, const RunContext& run) {
  const recipe::Step& step = world.step(index);
  const GridFrame frame = world.frame(world.output_of(step.in.at("terrain")));
  const int factor = factor_of(world, step, frame);
  const GridFrame target = reduced_frame(frame, factor);
  recipe::Values in;
  for (const auto& [port, source] : step.in) {
    if (source.from_file()) continue;  // run_step() reads it
    const OutputOf from = world.output_of(source);
    const recipe::Kind& kind = *step.op->find_in(port)->kind;
    if (!is_raster(kind) || !(world.frame(from) == frame)) {
      in[port] = world.whole(from);
    } else if (&kind == &kinds::Labels::kind()) {
      in[port] = recipe::Value::of<kinds::Labels>(reduced_labels(world, from, frame, target, factor));
    } else {
      HeightField means = resample_by_rows(world, from, frame, target, {run.threads, {}, run.cancelled, {}});
      in[port] = &kind == &kinds::Field::kind() ? recipe::Value::of<kinds::Field>(std::move(means))
                                                : recipe::Value::of<kinds::Terrain>(std::move(means));
    }
  }
  run.say(fmt::format("{} x {} cells do not fit: the picture is made from means over {} x {} of them", frame.width,
                      frame.height, factor, factor));
  for (auto& [port, value] : recipe::run_step(world.recipe(), step, std::move(in), run))
    world.keep({index, port}, value);
}

}  // namespace seamount::tiles
