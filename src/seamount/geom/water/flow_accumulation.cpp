#include <algorithm>
#include <atomic>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/water/flow.h"

namespace seamount::geom {
namespace {

constexpr uint8_t opposite(int k) { return static_cast<uint8_t>((k + 4) % 8); }

/// out[i] = donors of the cells [1, count - 1) of a row, in both halves of the byte.
SEAMOUNT_VECTORISED void donors_row(const uint8_t* north, const uint8_t* here, const uint8_t* south, uint8_t* out,
                                    int count) {
  for (int i = 1; i < count - 1; ++i) {
    const int donors = (here[i + 1] == 4) + (north[i + 1] == 5) + (north[i] == 6) + (north[i - 1] == 7) +
                       (here[i - 1] == 0) + (south[i - 1] == 1) + (south[i] == 2) + (south[i + 1] == 3);
    out[i] = static_cast<uint8_t>(donors * 17);
  }
}

/// Visits cells downstream in parallel, every cell after all of its donors: a thread starts where there is no donor and
/// goes on while it is the last to arrive. A byte per cell counts donors (high half) and those still missing (low).
class Downstream {
 public:
  Downstream(const FlowDirections& directions, const RunContext& run)
      : codes_(directions), waiting_(directions.frame()), steps_(flow_steps(directions.width())) {
    const std::vector<uint8_t> nothing(static_cast<size_t>(codes_.width()), kOutlet);
    parallel_rows(run, codes_.width(), codes_.height(), [&](int begin, int end) {
      for (int y = begin; y < end; ++y) {
        const uint8_t* north = y > 0 ? codes_.row(y - 1).data() : nothing.data();
        const uint8_t* south = y + 1 < codes_.height() ? codes_.row(y + 1).data() : nothing.data();
        donors_row(north, codes_.row(y).data(), south, waiting_.row(y).data(), codes_.width());
        waiting_(0, y) = count_donors(0, y);
        waiting_(codes_.width() - 1, y) = count_donors(codes_.width() - 1, y);
      }
    });
  }

  /// Calls visit(cell, from): from is the only donor, -1 without donors, -2 with several.
  template <class Visit>
  void for_each(const RunContext& run, const Visit& visit) {
    const uint8_t* code = codes_.data();
    uint8_t* waiting = waiting_.data();
    parallel_rows(run, codes_.width(), codes_.height(), [&](int begin, int end) {
      const int64_t stop = static_cast<int64_t>(end) * codes_.width();
      for (int64_t i = static_cast<int64_t>(begin) * codes_.width(); i < stop; ++i) {
        if (std::atomic_ref(waiting[i]).load(std::memory_order_relaxed) >> 4 != 0) continue;
        visit(i, int64_t{-1});
        for (int64_t from = i; code[from] < 8;) {
          const int64_t to = from + steps_[code[from]];
          const uint8_t before = std::atomic_ref(waiting[to]).fetch_sub(1, std::memory_order_acq_rel);
          if ((before & 15) != 1) break;
          visit(to, before >> 4 == 1 ? from : int64_t{-2});
          from = to;
        }
      }
    });
  }

  /// Calls visit(donor) for the donors of a cell, in the order of directions.
  template <class Visit>
  void for_each_donor(int64_t cell, const Visit& visit) const {
    const int x = static_cast<int>(cell % codes_.width()), y = static_cast<int>(cell / codes_.width());
    for (int k = 0; k < 8; ++k) {
      const size_t i = static_cast<size_t>(k);
      if (codes_.contains(x + kFlowDx[i], y + kFlowDy[i]) && codes_.data()[cell + steps_[i]] == opposite(k))
        visit(cell + steps_[i]);
    }
  }

 private:
  uint8_t count_donors(int x, int y) const {
    int donors = 0;
    for_each_donor(static_cast<int64_t>(y) * codes_.width() + x, [&](int64_t) { ++donors; });
    return static_cast<uint8_t>(donors * 17);
  }

  const FlowDirections& codes_;
  Grid<uint8_t> waiting_;
  std::array<int64_t, 8> steps_;
};

}  // namespace

Grid<uint32_t> flow_accumulation(const FlowDirections& directions, const RunContext& run) {
  Grid<uint32_t> cells(directions.frame());
  Downstream downstream(directions, run.part(0.0, 0.1));
  uint32_t* sum = cells.data();
  downstream.for_each(run.part(0.1, 1.0), [&](int64_t cell, int64_t from) {
    uint32_t total = 1;
    if (from >= 0) total += sum[from];
    if (from == -2) downstream.for_each_donor(cell, [&](int64_t donor) { total += sum[donor]; });
    sum[cell] = total;
  });
  return cells;
}

ScalarField flow_accumulation(const FlowDirections& directions, const ScalarField& weights, const RunContext& run) {
  ScalarField sums(directions.frame());
  Downstream downstream(directions, run.part(0.0, 0.1));
  downstream.for_each(run.part(0.1, 1.0), [&](int64_t cell, int64_t from) {
    double total = weights.data()[cell];
    if (from >= 0) total += sums.data()[from];
    if (from == -2) downstream.for_each_donor(cell, [&](int64_t donor) { total += sums.data()[donor]; });
    sums.data()[cell] = static_cast<float>(total);
  });
  return sums;
}

void label_upstream(const FlowDirections& directions, Grid<int32_t>& labels, const RunContext& run) {
  const std::array<int64_t, 8> steps = flow_steps(directions.width());
  const uint8_t* code = directions.data();
  const int64_t width = directions.width();
  // Until it has its label, a cell holds the one that it drains to, as ~cell.
  parallel_rows(run.part(0.0, 0.2), directions.width(), directions.height(), [&](int begin, int end) {
    for (int64_t i = begin * width; i < end * width; ++i)
      if (labels.data()[i] < 0) labels.data()[i] = ~static_cast<int32_t>(i + steps[code[i]]);
  });
  const auto at = [&](int32_t i) { return std::atomic_ref(labels.data()[i]); };
  parallel_rows(run.part(0.2, 1.0), directions.width(), directions.height(), [&](int begin, int end) {
    for (auto i = static_cast<int32_t>(begin * width); i < static_cast<int32_t>(end * width); ++i) {
      int32_t label = at(i).load(std::memory_order_relaxed);
      if (label >= 0) continue;
      while (label < 0) label = at(~label).load(std::memory_order_relaxed);
      // Who finds a label on its way leaves the rest to the thread that wrote it.
      for (int32_t cell = i, next; (next = at(cell).load(std::memory_order_relaxed)) < 0; cell = ~next)
        at(cell).store(label, std::memory_order_relaxed);
    }
  });
}

}  // namespace seamount::geom
