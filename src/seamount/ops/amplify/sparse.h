// amplify.sparse: a terrain with two, four or eight times as many cells along each side, and the detail of real ground.
//
// Source: P1 sec. 6.2, after Guerin et al. 2016 (dictionary.h). Where we depart: a factor is reached by doublings, each
// of which sees the ground that the one before made; the nearest atom alone is taken, turned as the ground lies and
// scaled with its relief, never with a negative coefficient, which would make ridges of valleys; and detail is added to
// the terrain instead of taking its place.
//
//   d = blend of atoms,  result = d + halved(terrain - means of d)      (geom/grid/halve_cells.h)
//
// Laws, to float rounding:
//   - the mean of the result over each of the terrain's cells is that cell;
//   - the cells of a terrain without relief, or with strength 0 of a plane, lie on that plane;
//   - a cell that is as high as its eight neighbours, such as one of flat water, is that high all over;
//   - a cell that is on one side of sea level (land above 0 m, sea at it or below) as its eight neighbours are stays
//     there all over: coasts move within one cell, no island or pond of the sea appears elsewhere;
//   - unknown cells (NaN) stay unknown all over; the others know nothing of them but what fills a hole from its rim.
#pragma once

#include <array>
#include <string_view>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/model_file.h"
#include "seamount/ops/amplify/dictionary.h"

namespace seamount::amplify {

enum class Factor { x2, x4, x8 };

struct SparseParams {
  Factor factor = Factor::x4;
  ModelFile dictionary{"mountains"};
  double strength = 1.0;

  static constexpr auto fields() {
    using P = SparseParams;
    return std::tuple(
        field(&P::factor, "factor", "how many cells there are along each side for one: x2, x4, x8"),
        field(&P::dictionary, "dictionary",
              "ground whose detail it gets: mountains, hills, canyons, or a file of `seamount train dictionary`"),
        field(&P::strength, "strength", "", between(0, 2), "how strong the detail is; 0 refines without any"));
  }
};

/// The terrain on cells of a half, a quarter or an eighth of the size, over the same ground. `dictionary` is the one
/// that params name. Throws InvalidArgument for params out of range, an empty terrain, and more than 65536 cells a side
/// or 2^30 in all. Parallel; about 0.1 us per cell of the result for 2048 atoms and 10 bytes of memory.
HeightField sparse(const HeightField& terrain, const Dictionary& dictionary, const SparseParams& params,
                   const RunContext& run);

}  // namespace seamount::amplify

template <>
struct seamount::Choices<seamount::amplify::Factor> {
  static constexpr std::array<std::string_view, 3> names = {"x2", "x4", "x8"};
};
