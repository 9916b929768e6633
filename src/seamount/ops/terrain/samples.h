// terrain.samples: a terrain as the samples that game engines and tiles of terrain want. Their outer samples lie ON the
// terrain's edge, so n samples are (n - 1) cells wide.
#pragma once

#include <array>
#include <string_view>
#include <tuple>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::terrain {

/// square: the largest centred square; tiles: the whole terrain as whole tiles that share their border samples.
enum class SampleLayout { square, tiles };

struct SamplesParams {
  SampleLayout layout = SampleLayout::square;
  int samples = 0;
  std::vector<int> choices;

  static constexpr auto fields() {
    using P = SamplesParams;
    return std::tuple(
        field(&P::layout, "layout",
              "square: the largest centred square; tiles: whole tiles that share their border samples"),
        field(&P::samples, "samples", "", between(0, 16385),
              "samples a side of the square, or of one tile; 0: the largest of `choices` that the terrain fills, the "
              "smallest if it fills none; without choices as many as it has"),
        field(&P::choices, "choices", "", between(2, 16385), "numbers to choose from where `samples` is 0"));
  }
};

/// The frame of size x size samples whose outer samples are the outer samples of the largest centred square of
/// `source`. Throws InvalidArgument{"samples"} for fewer than two samples a side of either.
GridFrame square_frame(const GridFrame& source, int size);

/// The frame of the least stretching whose samples are whole tiles of tile_size, shared borders counted once: the
/// source's width in full, its height down to whole tiles. `source` itself if it is so. REQUIRES: tile_size >= 2.
GridFrame tiled_frame(const GridFrame& source, int tile_size);

/// The terrain on such a frame; as it is where it lies there already. Throws InvalidArgument for params out of range
/// and what square_frame throws. Parallel; about 10 ns per cell of the larger of both grids.
HeightField samples(const HeightField& terrain, const SamplesParams& params, const RunContext& run);

}  // namespace seamount::terrain

template <>
struct seamount::Choices<seamount::terrain::SampleLayout> {
  static constexpr std::array<std::string_view, 2> names = {"square", "tiles"};
};
