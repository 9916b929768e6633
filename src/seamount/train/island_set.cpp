#include "seamount/train/island_set.h"

#include <algorithm>

#include "seamount/geom/grid/painted_labels.h"
#include "seamount/io/file_digest.h"
#include "seamount/io/image_file.h"
#include "seamount/io/raster.h"
#include "seamount/train/sample_set.h"

namespace seamount::train {

std::vector<std::string> make_island_files(const IslandSetParams& params, IslandSample& sample, Seed seed,
                                           const std::string& folder, const RunContext& run) {
  IslandPair pair = make_island_pair(params, sample, seed, run);
  for (float& z : pair.terrain.cells())
    z = std::clamp(z, static_cast<float>(params.low_m), static_cast<float>(params.high_m));
  const std::string labels = sample_file(folder, sample.index, kIslandFiles[0]),
                    height = sample_file(folder, sample.index, kIslandFiles[1]);
  io::write_png(geom::encode_labels(pair.labels, sample.subsidence), labels);
  io::write_heights(pair.terrain, height,
                    {.range = io::HeightRange{params.low_m, params.high_m}, .sidecar = false, .provenance = {}});
  return {io::content_digest(labels).hex(), io::content_digest(height).hex()};
}

}  // namespace seamount::train
