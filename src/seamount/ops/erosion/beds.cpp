#include "seamount/ops/erosion/beds.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/parallel.h"

namespace seamount::erosion {
namespace {}  // namespace

/// Heights and depths in one column.
struct Beds::Column {
  const BedSequence& beds;
  float datum, stretch;

  float depth(float height) const { return (datum - height) * stretch; }
  float height(float depth) const { return datum - depth / stretch; }
  Bed at(float height) const { return beds.at(depth(height)); }
  /// The bed that begins above a height: it takes part in a climb from there.
  Bed above(float height) const {
    const Bed bed = at(height);
    return this->height(bed.top) > height ? bed : beds.over(bed);
  }
  float period() const { return beds.period() / stretch; }
  /// Sequences in a height that are passed at once by their mean: all but the last two.
  float whole_periods(float height) const { return std::max(0.0F, std::floor(height / period()) - 2.0F); }
  /// Bound on the beds passed one by one, which only rounding far from the datum lets grow.
  int most_beds() const { return 8 * static_cast<int>(beds.count()); }
  /// How many cells wide rock is that rises from `low` to `high`, no more than `most`. Hardness 1 rises by `rise`.
  float width(float low, float high, float rise, float most) const;
  /// Where a slope that begins at `low` has got to after so many cells; no higher than `highest`.
  float climb(float low, float cells, float rise, float highest) const;
};

float Beds::Column::width(float low, float high, float rise, float most) const {
  float sum = 0.0F;
  Bed bed = above(low);
  for (int i = 0; i < most_beds() && low < high && sum < most; ++i) {
    const float top = std::min(high, height(bed.top));
    sum += std::max(0.0F, top - low) / (rise * std::sqrt(bed.hardness));
    low = std::max(low, top);
    bed = beds.over(bed);
    const float whole = bed.index + 1 == static_cast<int>(beds.count()) ? whole_periods(high - low) : 0.0F;
    if (whole > 0.0F) {
      sum += whole * period() * beds.mean_ease() / rise;
      low += whole * period();
      bed = above(low);
    }
  }
  return std::min(sum, most);
}

float Beds::Column::climb(float low, float cells, float rise, float highest) const {
  const float mean = rise / beds.mean_ease();
  Bed bed = above(low);
  for (int i = 0; i < most_beds() && low < highest; ++i) {
    const float own = rise * std::sqrt(bed.hardness), top = height(bed.top), reached = low + cells * own;
    if (reached <= top) return std::min(reached, highest);
    cells -= std::max(0.0F, top - low) / own;
    low = std::max(low, top);
    bed = beds.over(bed);
    const float whole = bed.index + 1 == static_cast<int>(beds.count()) ? whole_periods(cells * mean) : 0.0F;
    if (whole > 0.0F) {
      cells -= whole * period() / mean;
      low += whole * period();
      bed = above(low);
    }
  }
  return std::min(highest, low + std::max(0.0F, cells) * mean);
}

Beds::Beds(const Lithology& rock, const GridFrame& frame, const RunContext& run)
    : rock_(rock), datum_(frame), uniform_stretch_(static_cast<float>(rock.stretch(0, 0))) {
  if (!rock.stretch_varies()) return;
  stretch_ = ScalarField(frame);
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) rock_.stretch_row(frame, y, stretch_.row(y));
  });
}

void Beds::settle(const Layers& ground, const Maps& site, float risen_m, const RunContext& run) {
  if (settled_m_ == risen_m && !rock_.faults_dip()) return;
  settled_m_ = risen_m;
  const GridFrame& frame = datum_.frame();
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      rock_.datum_row(frame, y, datum_.row(y));
      const size_t first = static_cast<size_t>(y) * static_cast<size_t>(frame.width);
      for (int x = 0; x < frame.width; ++x) {
        const size_t cell = first + static_cast<size_t>(x);
        const float risen = site.rise(cell, risen_m);
        datum_.data()[cell] +=
            risen - static_cast<float>(rock_.thrown(frame.x(x), frame.y(y), ground.bedrock(cell) - risen));
      }
    }
  });
}

Beds::Column Beds::column(size_t cell) const {
  return {rock_.beds(), datum_.data()[cell], stretch_.empty() ? uniform_stretch_ : stretch_.data()[cell]};
}

BedSequence::Bed Beds::at(size_t cell, float height) const { return column(cell).at(height); }

float Beds::cut(size_t cell, float top, float base, float worn, float rate) const {
  const Column column = this->column(cell);
  const BedSequence& beds = column.beds;
  const auto reached_at = [&](float own) { return (top + own * (base + worn)) / (1.0F + own); };
  const auto go_down_to = [&](float floor, float own) {
    worn += std::max(0.0F, top - floor) / own;
    top = std::min(top, floor);
  };
  Bed bed = column.at(top);
  const float mean = rate / beds.mean_hardness();
  for (int i = 0; i < column.most_beds(); ++i) {
    const float own = rate / bed.hardness, reached = reached_at(own), floor = column.height(bed.bottom);
    if (reached >= floor) return reached;
    go_down_to(floor, own);
    bed = beds.under(bed);
    if (bed.index != 0) continue;
    const float whole = column.whole_periods(top - reached_at(mean));
    if (whole <= 0.0F) continue;
    go_down_to(top - whole * column.period(), mean);
    bed = column.at(top);
  }
  return std::max(base, reached_at(mean));
}

float Beds::stand(size_t cell, float low, float other, float here, float rise) const {
  const Column column = this->column(cell);
  const float softest = rise * rise * column.beds.softest(), above = here - low;
  if (above <= 0.0F || above * above <= 0.5F * softest) return here;
  const float apart = other < here ? column.width(low, other, rise, 1.0F) : 1.0F;
  const float cells = apart < 1.0F ? 0.5F * (apart + std::sqrt(2.0F - apart * apart)) : 1.0F;
  return column.climb(low, cells, rise, here);
}

float bedrock_hardness(const Layers& ground, const Maps& site, size_t cell) {
  const float map = value_or_one(site.hardness, cell);
  if (site.beds == nullptr) return map;
  return map * site.beds->hardness(cell, ground.bedrock(cell));
}

}  // namespace seamount::erosion
