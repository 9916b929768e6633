#include "seamount/geom/water/flow_flats.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/water/groups.h"

namespace seamount::geom {
namespace {

constexpr size_t kCellsPerCheck = size_t{1} << 16;

/// Cells [begin, end) of one row, of one height and without descent. They never lie on the border.
struct Stretch {
  int32_t begin, end;
};

void add_stretches(const HeightField& terrain, const FlowDirections& directions, int y, std::vector<Stretch>& out) {
  const uint8_t* code = directions.data();
  const float* z = terrain.data();
  const auto row = static_cast<int32_t>(static_cast<int64_t>(y) * terrain.width());
  const int32_t stop = row + terrain.width();
  for (int32_t i = row; i < stop;) {
    const void* found = std::memchr(code + i, kPit, static_cast<size_t>(stop - i));
    if (found == nullptr) return;
    const auto begin = static_cast<int32_t>(static_cast<const uint8_t*>(found) - code);
    for (i = begin + 1; i < stop && code[i] == kPit && z[i] == z[begin];) ++i;
    out.push_back({begin, i});
  }
}

std::vector<Stretch> find_stretches(const HeightField& terrain, const FlowDirections& directions,
                                    const RunContext& run) {
  constexpr int kRows = 32;
  std::vector<std::vector<Stretch>> parts(static_cast<size_t>((terrain.height() + kRows - 1) / kRows));
  parallel_blocks(run, terrain.height(), kRows, [&](int64_t begin, int64_t end) {
    for (int64_t y = begin; y < end; ++y)
      add_stretches(terrain, directions, static_cast<int>(y), parts[static_cast<size_t>(begin / kRows)]);
  });
  std::vector<Stretch> all;
  for (std::vector<Stretch>& part : parts) {
    all.insert(all.end(), part.begin(), part.end());
    part = {};
  }
  return all;
}

/// Flats: stretches of one height that touch by sides or corners.
Groups join_stretches(const HeightField& terrain, const std::vector<Stretch>& stretches, const RunContext& run) {
  Groups flats(static_cast<int32_t>(stretches.size()));
  const float* z = terrain.data();
  const int64_t width = terrain.width();
  size_t above = 0;
  for (size_t i = 0; i < stretches.size(); ++i) {
    if (i % kCellsPerCheck == 0) run.check_cancelled();
    const Stretch& here = stretches[i];
    while (stretches[above].end + width < here.begin) ++above;
    for (size_t k = above; stretches[k].begin + width <= here.end; ++k) {
      if (z[stretches[k].begin] != z[here.begin]) continue;
      const int32_t a = flats.find(static_cast<int32_t>(i)), b = flats.find(static_cast<int32_t>(k));
      if (a != b) flats.join(a, b);
    }
  }
  return flats;
}

/// One flat after the other. What is kept of a cell stands where it was added; `place` of the whole raster leads there.
class FlatWalker {
 public:
  FlatWalker(const HeightField& terrain, FlowDirections& directions, Grid<int32_t>& place, const RunContext& run)
      : z_(terrain.data()),
        code_(directions.data()),
        place_(place.data()),
        steps_(flow_steps(terrain.width())),
        run_(run) {}

  void clear() {
    cells_.clear();
    around_.clear();
  }

  void add(const Stretch& stretch) {
    for (int32_t cell = stretch.begin; cell < stretch.end; ++cell) {
      place_[cell] = static_cast<int32_t>(cells_.size());
      cells_.push_back(cell);
    }
  }

  /// The cells that were added are a whole flat.
  void resolve() {
    look_around();
    if (drains_.empty()) return gather_in_first();
    measure_from_higher();
    measure_from_outlets();
    aim();
  }

 private:
  /// Neighbours of a cell by direction, as bits: in the flat, and level ground that drains already.
  struct Around {
    uint8_t flat = 0, outlets = 0;
  };

  void look_around() {
    queue_.clear();
    drains_.clear();
    around_.resize(cells_.size());
    for (size_t i = 0; i < cells_.size(); ++i) {
      check(i);
      bool higher = false;
      for (size_t k = 0; k < 8; ++k) {
        const int64_t other = cells_[i] + steps_[k];
        higher = higher || z_[other] > z_[cells_[i]];
        if (z_[other] != z_[cells_[i]]) continue;
        (code_[other] == kPit ? around_[i].flat : around_[i].outlets) |= static_cast<uint8_t>(1U << k);
      }
      if (higher) queue_.push_back(static_cast<int32_t>(i));
      if (around_[i].outlets != 0) drains_.push_back(static_cast<int32_t>(i));
    }
  }

  /// Calls visit(k, place of the neighbour) for the neighbours in the flat, by direction.
  template <class Visit>
  void for_each_neighbour(size_t i, const Visit& visit) const {
    for (unsigned bits = around_[i].flat; bits != 0; bits &= bits - 1) {
      const auto k = static_cast<size_t>(std::countr_zero(bits));
      visit(k, static_cast<size_t>(place_[cells_[i] + steps_[k]]));
    }
  }

  /// Breadth first from the cells in the queue; reach(i, distance) marks a cell, fresh(i) tells if it has no mark yet.
  template <class Fresh, class Reach>
  void spread(const Fresh& fresh, const Reach& reach) {
    for (const int32_t i : queue_) reach(static_cast<size_t>(i), 0);
    size_t next = 0;
    for (int32_t distance = 1; next < queue_.size(); ++distance) {
      for (const size_t level_end = queue_.size(); next < level_end; ++next) {
        check(next);
        for_each_neighbour(static_cast<size_t>(queue_[next]), [&](size_t, size_t other) {
          if (!fresh(other)) return;
          reach(other, distance);
          queue_.push_back(static_cast<int32_t>(other));
        });
      }
    }
  }

  /// key = distance from higher ground, 0 where there is none.
  void measure_from_higher() {
    key_.assign(cells_.size(), -1);
    spread([&](size_t i) { return key_[i] < 0; }, [&](size_t i, int32_t distance) { key_[i] = distance; });
    if (queue_.empty()) key_.assign(cells_.size(), 0);
  }

  /// key = 2 x distance from the outlet - distance from higher ground: falls along every shortest way to the outlet.
  void measure_from_outlets() {
    queue_.swap(drains_);
    done_.assign(cells_.size(), false);
    spread([&](size_t i) { return !done_[i]; },
           [&](size_t i, int32_t distance) {
             done_[i] = true;
             key_[i] = 2 * distance - key_[i];
           });
  }

  /// Out where an outlet is next door, else down the steepest way of the keys.
  void aim() {
    for (size_t i = 0; i < cells_.size(); ++i) {
      check(i);
      uint8_t& code = code_[cells_[i]];
      if (const unsigned out = around_[i].outlets; out != 0) {
        code = first_outlet(out);
        continue;
      }
      float best = 0.0F;
      for_each_neighbour(i, [&](size_t k, size_t other) {
        const float fall = static_cast<float>(key_[i] - key_[other]) / kFlowLength[k];
        if (fall <= best) return;
        best = fall;
        code = static_cast<uint8_t>(k);
      });
    }
  }

  void gather_in_first() {
    done_.assign(cells_.size(), false);
    done_[0] = true;
    queue_.assign(1, 0);
    for (size_t next = 0; next < queue_.size(); ++next) {
      check(next);
      for_each_neighbour(static_cast<size_t>(queue_[next]), [&](size_t k, size_t other) {
        if (done_[other]) return;
        done_[other] = true;
        code_[cells_[other]] = static_cast<uint8_t>((k + 4) % 8);
        queue_.push_back(static_cast<int32_t>(other));
      });
    }
  }

  void check(size_t i) const {
    if (i % kCellsPerCheck == kCellsPerCheck - 1) run_.check_cancelled();
  }

  const float* z_;
  uint8_t* code_;
  int32_t* place_;
  std::array<int64_t, 8> steps_;
  const RunContext& run_;
  std::vector<int32_t> cells_, queue_, drains_, key_;
  std::vector<Around> around_;
  std::vector<bool> done_;
};

}  // namespace

void drain_flats(const HeightField& terrain, FlowDirections& directions, const RunContext& run) {
  const std::vector<Stretch> stretches = find_stretches(terrain, directions, run);
  if (stretches.empty()) return;
  Groups flats = join_stretches(terrain, stretches, run);
  std::vector<int32_t> leaders;
  for (int32_t i = 0; i < static_cast<int32_t>(stretches.size()); ++i)
    if (flats.find(i) == i) leaders.push_back(i);
  Grid<int32_t> place(terrain.frame());
  constexpr int64_t kFlats = 256;
  parallel_blocks(run, static_cast<int64_t>(leaders.size()), kFlats, [&](int64_t begin, int64_t end) {
    FlatWalker walker(terrain, directions, place, run);
    for (int64_t i = begin; i < end; ++i) {
      walker.clear();
      flats.for_each_member(leaders[static_cast<size_t>(i)],
                            [&](int32_t k) { walker.add(stretches[static_cast<size_t>(k)]); });
      walker.resolve();
    }
  });
}

}  // namespace seamount::geom
