#include "seamount/ops/island/wind.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/current/stroke_field.h"
#include "seamount/geom/grid/sample_rows.h"
#include "seamount/geom/scalar/curve.h"
#include "seamount/model/same_size.h"
#include "seamount/ops/island/coordinate.h"
#include "seamount/ops/island/radial_strokes.h"

namespace seamount::island {
namespace {

constexpr double kSteepest = 0.9;  // of a step's gradient; below 1 the step is a bijection

/// The displacement that is left after resistance, in cells: (1 - rho(x~)) Phi per cell.
struct CellDisplacement {
  ScalarField columns;
  ScalarField rows;
};

SEAMOUNT_VECTORISED void give_way(const float* withheld, float per_cell, float* east, float* north, int count) {
  for (int i = 0; i < count; ++i) {
    const float give = (1.0F - withheld[i]) * per_cell;
    east[i] *= give;
    north[i] *= -give;
  }
}

CellDisplacement resisted(const geom::StrokeField& strokes, const GridFrame& frame, const ScalarField* coordinate,
                          const geom::CurveTable& resistance, const RunContext& run) {
  CellDisplacement out{ScalarField(frame), ScalarField(frame)};
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    geom::StrokeField::Rows rows(strokes);
    std::vector<float> withheld(static_cast<size_t>(frame.width), 0.0F);
    for (int y = begin; y < end; ++y) {
      rows.read(frame.x(0), frame.cell_m, frame.y(y), out.columns.row(y), out.rows.row(y));
      if (coordinate != nullptr) resistance.evaluate(coordinate->row(y), withheld);
      give_way(withheld.data(), static_cast<float>(1.0 / frame.cell_m), out.columns.row(y).data(),
               out.rows.row(y).data(), frame.width);
    }
  });
  return out;
}

/// Raises most[x] to the squared norm of the gradient at each place of a row.
SEAMOUNT_VECTORISED void raise_to_gradient(const float* c0, const float* c1, const float* r0, const float* r1,
                                           int count, float* __restrict most) {
  for (int x = 0; x < count; ++x) {
    const float cx = c0[x + 1] - c0[x], cy = c1[x] - c0[x];
    const float rx = r0[x + 1] - r0[x], ry = r1[x] - r0[x];
    const float norm = cx * cx + cy * cy + rx * rx + ry * ry;
    most[x] = norm > most[x] ? norm : most[x];
  }
}

double steepest(const CellDisplacement& field, const RunContext& run) {
  const ScalarField &c = field.columns, &r = field.rows;
  std::vector<float> rows(static_cast<size_t>(r.height()), 0.0F);
  parallel_rows(run, r.width(), r.height() - 1, [&](int begin, int end) {
    std::vector<float> most(static_cast<size_t>(r.width()), 0.0F);
    for (int y = begin; y < end; ++y) {
      raise_to_gradient(c.row(y).data(), c.row(y + 1).data(), r.row(y).data(), r.row(y + 1).data(), r.width() - 1,
                        most.data());
    }
    rows[static_cast<size_t>(begin)] = *std::max_element(most.begin(), most.end());
  });
  return std::sqrt(*std::max_element(rows.begin(), rows.end()));
}

SEAMOUNT_VECTORISED void step_back(const float* by, float share, float* position, int count) {
  for (int i = 0; i < count; ++i) position[i] -= share * by[i];
}

/// Where the cells of a row come from: fractional columns and rows of the unmoved terrain.
class Sources {
 public:
  Sources(const CellDisplacement& field, int steps)
      : columns(static_cast<size_t>(field.rows.width())),
        rows(columns.size()),
        field_(field),
        steps_(steps),
        by_column_(columns.size()),
        by_row_(columns.size()) {}

  void find(int y) {
    for (size_t i = 0; i < columns.size(); ++i) columns[i] = static_cast<float>(i);
    std::fill(rows.begin(), rows.end(), static_cast<float>(y));
    const float share = 1.0F / static_cast<float>(steps_);
    const auto count = static_cast<int>(columns.size());
    step_back(field_.columns.row(y).data(), share, columns.data(), count);
    step_back(field_.rows.row(y).data(), share, rows.data(), count);
    for (int step = 1; step < steps_; ++step) {
      geom::sample_bilinear_rows(field_.columns, columns, rows, by_column_);
      geom::sample_bilinear_rows(field_.rows, columns, rows, by_row_);
      step_back(by_column_.data(), share, columns.data(), count);
      step_back(by_row_.data(), share, rows.data(), count);
    }
  }

  std::vector<float> columns, rows;

 private:
  const CellDisplacement& field_;
  int steps_;
  std::vector<float> by_column_, by_row_;
};

void check_sizes(const HeightField& terrain, const LabelMap* labels, const ScalarField* coordinate) {
  if (labels != nullptr) check_same_size("labels", labels->frame(), terrain.frame());
  if (coordinate != nullptr) check_same_size("coordinate", coordinate->frame(), terrain.frame());
}

std::vector<Stroke> all_strokes(const WindParams& params, const GridFrame& frame, Seed seed) {
  std::vector<Stroke> strokes = params.strokes;
  const double reach = 0.5 * std::min(frame.width_m(), frame.height_m());
  for (Stroke& stroke : radial_strokes(params.radial_count, params.radial_width_m, params.radial_strength_m,
                                       params.centre, reach, seed)) {
    strokes.push_back(std::move(stroke));
  }
  return strokes;
}

}  // namespace

Warped wind(const HeightField& terrain, const LabelMap* labels, const ScalarField* coordinate, const WindParams& params,
            Seed seed, const RunContext& run) {
  check_params(params);
  check_sizes(terrain, labels, coordinate);
  run.check_cancelled();
  const GridFrame& frame = terrain.frame();
  ScalarField derived;
  if (coordinate == nullptr && labels != nullptr) {
    derived = coordinate_from_labels(*labels, run);
    coordinate = &derived;
  }
  const geom::StrokeField strokes(all_strokes(params, frame, seed), frame, run.part(0.0, 0.2));
  if (strokes.empty()) {
    return {terrain, labels == nullptr ? LabelMap() : *labels, coordinate == nullptr ? ScalarField() : *coordinate};
  }
  const geom::CurveTable resistance(
      geom::CurveFunction(params.resistance, geom::CurveKind::monotone_cubic, "resistance"), 0.0, 5.0);
  const CellDisplacement field = resisted(strokes, frame, coordinate, resistance, run.part(0.2, 0.4));
  const int steps = std::max(1, static_cast<int>(std::ceil(steepest(field, run) / kSteepest)));

  Warped out{HeightField(frame), labels == nullptr ? LabelMap() : LabelMap(frame),
             coordinate == nullptr ? ScalarField() : ScalarField(frame)};
  parallel_rows(run.part(0.4, 1.0), frame.width, frame.height, [&](int begin, int end) {
    Sources sources(field, steps);
    for (int y = begin; y < end; ++y) {
      sources.find(y);
      geom::sample_bicubic_rows(terrain, sources.columns, sources.rows, out.terrain.row(y));
      if (coordinate != nullptr)
        geom::sample_bilinear_rows(*coordinate, sources.columns, sources.rows, out.coordinate.row(y));
      if (labels == nullptr) continue;
      for (int x = 0; x < frame.width; ++x) {
        const auto i = static_cast<size_t>(x);
        out.labels(x, y) = labels->clamped(static_cast<int>(std::floor(sources.columns[i] + 0.5F)),
                                           static_cast<int>(std::floor(sources.rows[i] + 0.5F)));
      }
    }
  });
  return out;
}

}  // namespace seamount::island
