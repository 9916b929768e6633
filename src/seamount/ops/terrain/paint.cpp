#include "seamount/ops/terrain/paint.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/parallel.h"
#include "seamount/geom/brush/brush_replay.h"
#include "seamount/model/same_size.h"

namespace seamount::terrain {
namespace {

/// Lays values(i) over a row, weights[i] times as much as opacity says.
template <class Value>
void lay_over(std::span<const float> weights, double opacity, float* row, Value&& value) {
  constexpr float kHalf = 0.5F;
  const auto most = static_cast<float>(opacity);
  if (most == 0.0F) return;
  for (size_t i = 0; i < weights.size(); ++i) {
    const float to = value(i), weight = std::min(weights[i], 1.0F), w = most * weight;
    if (w == 0.0F) continue;
    const bool mixes = w < 1.0F && !std::isnan(row[i]) && !std::isnan(to);
    if (mixes) {
      row[i] += w * (to - row[i]);
    } else if (weight >= kHalf) {
      row[i] = to;
    }
  }
}

class Session {
 public:
  Session(ScalarField before, const std::vector<PaintStroke>& strokes, const RunContext& run, const GridFrame& whole)
      : before_(std::move(before)), field_(before_), strokes_(strokes), run_(run), whole_(whole) {}

  ScalarField replay() {
    std::vector<const Brush*> brushes;
    brushes.reserve(strokes_.size());
    for (const PaintStroke& stroke : strokes_) {
      const auto* brush = std::get_if<PaintBrush>(&stroke);
      brushes.push_back(brush != nullptr ? brush : static_cast<const Brush*>(std::get_if<PaintErase>(&stroke)));
    }
    paths_ = geom::brush_paths(brushes, whole_, "strokes", run_.part(0.0, 0.2));
    size_t done = 0;
    for (size_t next = 0; next < strokes_.size(); ++next) {
      const auto* area = std::get_if<PaintArea>(&strokes_[next]);
      if (area == nullptr) continue;
      apply(done, next);
      fill(*area, next);
      done = next;
    }
    apply(done, strokes_.size());
    return std::move(field_);
  }

 private:
  /// Those of the strokes [begin, end) that are brushes; others have no path.
  void apply(size_t begin, size_t end) {
    const auto share = [&](size_t i) {
      return 0.2 + 0.8 * static_cast<double>(i) / static_cast<double>(strokes_.size());
    };
    geom::replay(paths_, begin, end, before_.frame(), run_.part(share(begin), share(end)),
                 [&](size_t i, int y, int x, std::span<const float> weights) {
                   if (const auto* brush = std::get_if<PaintBrush>(&strokes_[i])) {
                     const auto value = static_cast<float>(brush->value);
                     lay_over(weights, brush->opacity, &field_(x, y), [=](size_t) { return value; });
                   } else if (const auto* erase = std::get_if<PaintErase>(&strokes_[i])) {
                     const float* before = &before_(x, y);
                     lay_over(weights, erase->opacity, &field_(x, y), [=](size_t k) { return before[k]; });
                   }
                 });
  }

  void fill(const PaintArea& area, size_t i) {
    const RunContext quiet{run_.threads, {}, run_.cancelled, {}};
    const geom::AreaWeights under = geom::area_weights(area.polygons, area.feather_m, before_.frame(),
                                                       "strokes[" + std::to_string(i) + "].polygons", quiet);
    if (under.window.empty()) return;
    const auto value = static_cast<float>(area.value);
    parallel_rows(quiet, under.weights.width(), under.weights.height(), [&](int begin, int end) {
      for (int y = begin; y < end; ++y)
        lay_over(under.weights.row(y), area.opacity, &field_(under.window.left, under.window.top + y),
                 [=](size_t) { return value; });
    });
  }

  ScalarField before_;
  ScalarField field_;
  const std::vector<PaintStroke>& strokes_;
  const RunContext& run_;
  const GridFrame& whole_;
  std::vector<geom::BrushPath> paths_;
};

}  // namespace

ScalarField paint(const GridFrame& frame, const ScalarField* values, const PaintParams& params, const RunContext& run,
                  const GridFrame* whole) {
  check_params(params);
  const GridFrame& all = whole != nullptr ? *whole : frame;
  run.check_cancelled();
  if (values != nullptr) {
    check_same_size("values", values->frame(), frame, "result");
    if (params.unknown) run.say("unknown says nothing here: what is not painted is what the input 'values' says");
    return Session(*values, params.strokes, run, all).replay();
  }
  const float base = params.unknown ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(params.base);
  return Session(ScalarField(frame, base), params.strokes, run, all).replay();
}

}  // namespace seamount::terrain
