#include "seamount/train/sketch_set.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "seamount/base/error.h"
#include "seamount/io/file_digest.h"
#include "seamount/io/image_file.h"
#include "seamount/io/raster.h"
#include "seamount/ops/sketch/extract.h"
#include "seamount/ops/sketch/levelset.h"
#include "seamount/train/sample_set.h"
#include "seamount/train/sketch_crop.h"
#include "seamount/train/sketch_task.h"

namespace seamount::train {
namespace {

struct Found {
  const GroundTile& tile;
  Crop crop;
};

Found find_example(const std::vector<GroundTile>& tiles, const SketchSetParams& params, Rng& rng) {
  constexpr int kTiles = 100;
  for (int i = 0; i < kTiles; ++i) {
    const GroundTile& tile = tiles[choose_tile(tiles, rng)];
    if (std::optional<Crop> crop = find_crop(tile.heights, params.size, 1.0 - params.unknown, rng))
      return {tile, std::move(*crop)};
  }
  throw InvalidArgument("--dem", "hardly any square of " + std::to_string(params.size) +
                                     " cells (--size) is ground with relief, without more voids, lakes and sea than "
                                     "--unknown allows");
}

sketch::Sketch draw_lines(const HeightField& heights, SketchDraw& draw, Seed seed, const RunContext& run) {
  sketch::Sketch made = sketch::extract(heights, extract_params(draw.detail, draw.cell_m), seed, run);
  draw.lowest_cue_m = made.lowest_cue_m;
  draw.highest_cue_m = made.highest_cue_m;
  return made;
}

sketch::Levelset draw_levelset(const HeightField& heights, SketchDraw& draw, const RunContext& run) {
  sketch::LevelsetParams params;
  params.percentile = draw.percentile;
  params.blur_m = draw.blur_m;
  params.sea = false;
  sketch::Levelset made = sketch::levelset(heights, params, run);
  draw.level_m = made.level_m;
  return made;
}

}  // namespace

std::vector<GroundTile> read_sketch_ground(const std::string& folder, const SketchSetParams& params,
                                           const RunContext& run) {
  check_params(params);
  std::vector<GroundTile> tiles = read_ground(folder, params.held_out, run);
  std::erase_if(tiles, [&](const GroundTile& tile) {
    return std::min(tile.heights.width(), tile.heights.height()) < params.size;
  });
  if (tiles.empty()) {
    throw InvalidArgument("--size",
                          "no elevation model of " + folder + " has " + std::to_string(params.size) + " cells a side");
  }
  return tiles;
}

Digest ground_digest(const std::vector<GroundTile>& tiles) {
  Hasher hasher;
  for (const GroundTile& tile : tiles) {
    hasher.text(tile.name).number(static_cast<uint64_t>(tile.heights.width()));
    hasher.bytes(std::as_bytes(std::span(tile.heights.cells())));
  }
  return hasher.digest();
}

SketchExample make_sketch_files(const std::vector<GroundTile>& tiles, const SketchSetParams& params, uint64_t index,
                                Seed seed, const std::string& folder, const RunContext& run) {
  Rng rng(seed.derive("example", index));
  const auto [tile, crop] = find_example(tiles, params, rng);
  const auto [low, high] = std::minmax_element(crop.heights.cells().begin(), crop.heights.cells().end());
  SketchExample example{tile.name, {}, {}};
  SketchDraw& draw = example.draw;
  draw.cell_m = tile.heights.cell_m();
  draw.left = crop.left;
  draw.top = crop.top;
  draw.flip_x = crop.flip_x;
  draw.flip_y = crop.flip_y;
  draw.transpose = crop.transpose;
  draw.low_m = static_cast<double>(*low);
  draw.high_m = static_cast<double>(*high);
  draw.detail = rng.integer(0, kSketchDetails - 1);
  draw.percentile = std::round(rng.uniform(30, 85));
  draw.blur_m = std::round(rng.uniform(3, 10) * draw.cell_m);
  const sketch::Sketch lines = draw_lines(crop.heights, draw, seed.derive("sketch", index), run);
  const sketch::Levelset levelset = draw_levelset(crop.heights, draw, run);

  std::vector<std::string> files;
  for (const char* kind : kSketchFiles) files.push_back(sample_file(folder, index, kind));
  io::write_heights(crop.heights, files[0],
                    {.range = io::HeightRange{draw.low_m, draw.high_m}, .sidecar = false, .provenance = {}});
  io::write_png(lines.image, files[1]);
  io::write_png(levelset.image, files[2]);
  for (const std::string& file : files) example.digests.push_back(io::content_digest(file, run).hex());
  return example;
}

}  // namespace seamount::train
