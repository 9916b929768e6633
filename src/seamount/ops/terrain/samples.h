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

/// square: a square; whole: the whole terrain, as long as it is; tiles: the whole terrain as whole tiles that share
/// their border samples.
enum class SampleLayout { square, whole, tiles };

/// How a terrain that is longer than wide becomes a square: the middle of it, or all of it between repeated edges.
enum class SquareFit { crop, pad };

struct SamplesParams {
  SampleLayout layout = SampleLayout::square;
  int samples = 0;
  std::vector<int> choices;
  SquareFit fit = SquareFit::crop;

  static constexpr auto fields() {
    using P = SamplesParams;
    return std::tuple(
        field(
            &P::layout, "layout",
            "square; whole: all of the terrain, as long as it is; tiles: all of it with its own cells, as whole tiles "
            "that share their border samples, the last ones padded with its edge"),
        field(
            &P::samples, "samples", "", between(0, 16385),
            "samples of a square's side, of the longer side of the whole, or of one tile; 0: the largest of `choices` "
            "that the terrain fills, the smallest if it fills none; without choices as many as it has"),
        field(&P::choices, "choices", "", between(2, 16385), "numbers to choose from where `samples` is 0"),
        field(&P::fit, "fit",
              "square, of a terrain that is none: crop takes the middle, pad keeps all and repeats its edge"));
  }
};

/// The frame of size x size samples whose outer samples are the outer samples of the largest centred square of
/// `source`. Throws InvalidArgument{"samples"} for fewer than two samples a side of either.
GridFrame square_frame(const GridFrame& source, int size);

/// The frame of `size` samples along the longer side, from outer sample to outer sample of `source`, and as many square
/// cells down the other as cover it: up to one cell more than there is. Throws as square_frame.
GridFrame whole_frame(const GridFrame& source, int size);

/// `source` with rows and columns added in the south and east until its samples are whole tiles of tile_size, shared
/// borders counted once. REQUIRES: tile_size >= 2.
GridFrame tiled_frame(const GridFrame& source, int tile_size);

/// The frame of samples() in the layouts square and whole. Throws as square_frame.
GridFrame samples_frame(const GridFrame& source, const SamplesParams& params);

/// The terrain on such a frame; as it is where it lies there already. Says how much was cut off or added, in metres,
/// and how much coarser it became. What is added repeats the terrain's edge. Throws InvalidArgument for params out of
/// range and what square_frame throws. Parallel; about 10 ns per cell of the larger of both grids.
HeightField samples(const HeightField& terrain, const SamplesParams& params, const RunContext& run);

}  // namespace seamount::terrain

template <>
struct seamount::Choices<seamount::terrain::SampleLayout> {
  static constexpr std::array<std::string_view, 3> names = {"square", "whole", "tiles"};
};

template <>
struct seamount::Choices<seamount::terrain::SquareFit> {
  static constexpr std::array<std::string_view, 2> names = {"crop", "pad"};
};
