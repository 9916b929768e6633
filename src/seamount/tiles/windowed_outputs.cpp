#include "seamount/tiles/windowed_outputs.h"

#include "seamount/tiles/windows.h"

namespace seamount::tiles {

bool write_by_windows(const World& world, const recipe::Output& output, const std::string& path,
                      const io::Provenance& provenance,
                      const std::function<const recipe::Value&(const recipe::Source&)>& prepared,
                      const RunContext& run) {
  const OutputOf from = world.output_of(output.from);
  const recipe::Kind& kind = *world.step(from.first).op->find_out(from.second)->kind;
  if (!output.format->write_windows || !is_raster(kind)) return false;
  recipe::Values others;
  for (const auto& [name, source] : output.prepared) others[name] = prepared(source);
  const auto window = [&](int column, int row, int width, int height) {
    return world.window(from, {column, row, width, height});
  };
  return output.format->write_windows(output.params, {kind, world.frame(from), window, others, path, provenance, run});
}

}  // namespace seamount::tiles
