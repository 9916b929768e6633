#include "seamount/ops/classify/paint.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "seamount/geom/brush/brush_replay.h"
#include "seamount/model/same_size.h"

namespace seamount::classify {
namespace {

constexpr float kEdge = 0.5F;  // weight of a cell whose centre lies on the edge of an area

class Session {
 public:
  Session(const Painted& before, const std::vector<PaintStroke>& strokes, const RunContext& run, const GridFrame& whole)
      : before_(before), now_(before), strokes_(strokes), run_(run), whole_(whole) {}

  Painted replay() {
    std::vector<const Brush*> brushes;
    brushes.reserve(strokes_.size());
    for (const PaintStroke& stroke : strokes_)
      brushes.push_back(std::visit([&](const auto& tool) { return brush_of(tool); }, stroke));
    paths_ = geom::brush_paths(brushes, whole_, "strokes", run_.part(0.0, 0.2));
    size_t done = 0;
    for (size_t next = 0; next < strokes_.size(); ++next) {
      const auto* area = std::get_if<AreaTool>(&strokes_[next]);
      if (area == nullptr) continue;
      apply(done, next);
      fill(*area, next);
      done = next;
    }
    apply(done, strokes_.size());
    return std::move(now_);
  }

 private:
  const Brush* brush_of(const SinkTool& tool) { return &tool; }
  const Brush* brush_of(const AreaTool&) { return nullptr; }
  template <class Tool>
  const Brush* brush_of(const Tool& tool) {
    return &crisp_.emplace_back(Brush{tool.points, {}, tool.radius_m, 0.0});
  }

  /// Those of the strokes [begin, end) that are brushes; others have no path.
  void apply(size_t begin, size_t end) {
    const auto share = [&](size_t i) {
      return 0.2 + 0.8 * static_cast<double>(i) / static_cast<double>(strokes_.size());
    };
    geom::replay(paths_, begin, end, before_.labels.frame(), run_.part(share(begin), share(end)),
                 [&](size_t i, int y, int x, std::span<const float> weights) {
                   std::visit([&](const auto& tool) { draw(tool, x, y, weights); }, strokes_[i]);
                 });
  }

  void draw(const RegionTool& tool, int x, int y, std::span<const float> weights) {
    Region* labels = &now_.labels(x, y);
    for (size_t i = 0; i < weights.size(); ++i) labels[i] = weights[i] > 0.0F ? tool.region : labels[i];
  }

  void draw(const AreaTool&, int, int, std::span<const float>) {}

  void draw(const SinkTool& tool, int x, int y, std::span<const float> weights) {
    float* sunk = &now_.subsidence(x, y);
    const auto to = static_cast<float>(tool.subsidence);
    for (size_t i = 0; i < weights.size(); ++i) {
      const float w = std::min(weights[i], 1.0F);
      sunk[i] = w < 1.0F ? sunk[i] + w * (to - sunk[i]) : to;
    }
  }

  void draw(const EraseTool&, int x, int y, std::span<const float> weights) {
    for (size_t i = 0; i < weights.size(); ++i) {
      if (!(weights[i] > 0.0F)) continue;
      const int column = x + static_cast<int>(i);
      now_.labels(column, y) = before_.labels(column, y);
      now_.subsidence(column, y) = before_.subsidence(column, y);
    }
  }

  void fill(const AreaTool& area, size_t i) {
    const geom::AreaWeights under =
        geom::area_weights(area.polygons, 0.0, before_.labels.frame(), "strokes[" + std::to_string(i) + "].polygons",
                           {run_.threads, {}, run_.cancelled, {}});
    for (int y = under.window.top; y < under.window.bottom; ++y) {
      for (int x = under.window.left; x < under.window.right; ++x)
        if (under.weights(x - under.window.left, y - under.window.top) >= kEdge) now_.labels(x, y) = area.region;
    }
  }

  const Painted& before_;
  Painted now_;
  const std::vector<PaintStroke>& strokes_;
  const RunContext& run_;
  const GridFrame& whole_;
  std::deque<Brush> crisp_;  ///< brushes of strokes that have no softness of their own
  std::vector<geom::BrushPath> paths_;
};

}  // namespace

Painted paint(const GridFrame& frame, const LabelMap* labels, const ScalarField* subsidence, const PaintParams& params,
              const RunContext& run, const GridFrame* whole) {
  check_params(params);
  run.check_cancelled();
  if (labels != nullptr) check_same_size("labels", labels->frame(), frame, "result");
  if (subsidence != nullptr) check_same_size("subsidence", subsidence->frame(), frame, "result");
  Painted before{labels != nullptr ? *labels : LabelMap(frame, params.base),
                 subsidence != nullptr ? *subsidence : ScalarField(frame, 0.0F)};
  for (float& s : before.subsidence.cells()) s = std::clamp(s, 0.0F, 1.0F);
  return Session(before, params.strokes, run, whole != nullptr ? *whole : frame).replay();
}

}  // namespace seamount::classify
