#include "seamount/ops/amplify/atom_detail.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/halve_cells.h"

namespace seamount::amplify {
namespace {

constexpr int kMargin = 4;            ///< cells beyond the border that shapes reach
constexpr int kFineStep = 2 * kStep;  ///< fine cells from one core to the next
constexpr int64_t kRowsTogether = 4;

/// Shapes along a side of `cells`: each cell lies in two cores.
int shapes_along(int cells) { return (cells - 1) / kStep + 2; }

/// Where a row of an atom's detail lies in its numbers when turned: of ground cell (column, row) it is
/// first + column * step.
struct TurnedRow {
  int first, step;
  TurnedRow(Turn turn, int row) {
    const bool west = (turn & 1) != 0;
    const int r = (turn & 2) != 0 ? kDetail - 1 - row : row;
    step = (turn & 4) != 0 ? kDetail : 1;
    first = (turn & 4) != 0 ? r : kDetail * r;
    if (west) {
      first += step * (kDetail - 1);
      step = -step;
    }
  }
};

}  // namespace

AtomDetail::AtomDetail(const Dictionary& dictionary, double strength)
    : table_(dictionary.shapes), faded_(dictionary.details) {
  std::array<double, kDetail> fade;
  for (int i = 0; i < kDetail; ++i) fade[i] = std::pow(std::sin(std::numbers::pi * (i + 0.5) / kDetail), 2);
  for (Detail& detail : faded_) {
    for (int i = 0; i < kDetail * kDetail; ++i)
      detail[i] = static_cast<float>(strength * fade[i / kDetail] * fade[i % kDetail] * detail[i]);
  }
}

void AtomDetail::find_row(const Grid<float>& around, int row, std::span<Place> places) const {
  // A shape begins a cell before its core, which begins at 2 i - 2.
  constexpr int kFirst = kMargin - kStep - (kShape - kCore) / 2;
  std::vector<Features> shapes(places.size());
  for (size_t i = 0; i < places.size(); ++i) {
    const Shape shape =
        describe_shape(&around(kFirst + kStep * static_cast<int>(i), kFirst + kStep * row), around.width());
    shapes[i] = shape.features;
    places[i] = {0, shape.relief_m, shape.turn};
  }
  std::vector<AtomTable::Match> matches(places.size());
  table_.find(shapes, matches);
  for (size_t i = 0; i < places.size(); ++i) {
    places[i].atom = matches[i].atom;
    places[i].metres *= std::clamp(matches[i].cosine, 0.0F, 1.0F);
  }
}

void AtomDetail::add_row(std::span<const Place> places, int north, std::span<float> fine) const {
  const auto width = static_cast<int>(fine.size());
  for (size_t i = 0; i < places.size(); ++i) {
    const Place& place = places[i];
    const TurnedRow row(place.turn, north);
    const int west = kFineStep * (static_cast<int>(i) - 1);
    const float* numbers = faded_[place.atom].data() + row.first;
    for (int x = std::max(0, -west); x < std::min(kDetail, width - west); ++x)
      fine[west + x] += place.metres * numbers[x * row.step];
  }
}

Grid<float> AtomDetail::of(const Grid<float>& terrain, const RunContext& run) const {
  const int columns = shapes_along(terrain.width()), rows = shapes_along(terrain.height());
  std::vector<Place> places(static_cast<size_t>(columns) * rows);
  const auto row_of = [&](int row) {
    return std::span(places).subspan(static_cast<size_t>(row) * columns, static_cast<size_t>(columns));
  };
  const Grid<float> around = geom::with_reflected_margin(terrain, kMargin, run.part(0.0, 0.02));
  parallel_blocks(run.part(0.02, 0.9), rows, kRowsTogether, [&](int64_t begin, int64_t end) {
    for (int64_t row = begin; row < end; ++row) find_row(around, static_cast<int>(row), row_of(static_cast<int>(row)));
  });
  Grid<float> detail(geom::halved_frame(terrain.frame()), 0.0F);
  parallel_rows(run.part(0.9, 1.0), detail.width(), detail.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      // The cores of shapes in row r begin at fine row 4 (r - 1).
      const int band = y / kFineStep, within = y % kFineStep;
      add_row(row_of(band), kFineStep + within, detail.row(y));
      add_row(row_of(band + 1), within, detail.row(y));
    }
  });
  return detail;
}

}  // namespace seamount::amplify
