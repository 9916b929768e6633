#include <algorithm>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/water/flow.h"

namespace seamount::geom {
namespace {

constexpr float kDiagonal = 0.70710678F;

/// Steepest descent of the cells [1, count - 1) of a row; kPit where no neighbour is lower.
SEAMOUNT_VECTORISED void steepest_row(const float* north, const float* here, const float* south, float sea,
                                      uint8_t* out, int count) {
  for (int i = 1; i < count - 1; ++i) {
    const float z = here[i];
    const float drop[8] = {
        z - here[i + 1], (z - north[i + 1]) * kDiagonal, z - north[i], (z - north[i - 1]) * kDiagonal,
        z - here[i - 1], (z - south[i - 1]) * kDiagonal, z - south[i], (z - south[i + 1]) * kDiagonal};
    float best = 0.0F;
    int32_t code = kPit;
    for (int32_t k = 0; k < 8; ++k) {
      code = drop[k] > best ? k : code;
      best = drop[k] > best ? drop[k] : best;
    }
    out[i] = static_cast<uint8_t>(z <= sea ? kOutlet : code);
  }
}

/// A row with the sea at its surface.
SEAMOUNT_VECTORISED void clamp_row(const float* row, float sea, float* out, int count) {
  for (int i = 0; i < count; ++i) out[i] = row[i] > sea ? row[i] : sea;
}

void steepest_rows(const HeightField& terrain, float sea, FlowDirections& out, int begin, int end) {
  const int width = terrain.width();
  std::vector<float> surface(3 * static_cast<size_t>(width));
  const auto row_of = [&](int y) { return surface.data() + static_cast<size_t>(y % 3) * static_cast<size_t>(width); };
  for (int y = std::max(0, begin - 1); y < std::min(begin + 1, terrain.height()); ++y)
    clamp_row(terrain.row(y).data(), sea, row_of(y), width);
  for (int y = begin; y < end; ++y) {
    const auto row = out.row(y);
    if (y == 0 || y == terrain.height() - 1) {
      std::fill(row.begin(), row.end(), kOutlet);
      if (y + 1 < terrain.height()) clamp_row(terrain.row(y + 1).data(), sea, row_of(y + 1), width);
      continue;
    }
    clamp_row(terrain.row(y + 1).data(), sea, row_of(y + 1), width);
    steepest_row(row_of(y - 1), row_of(y), row_of(y + 1), sea, row.data(), width);
    row.front() = row.back() = kOutlet;
  }
}

/// Gives the cells of flats their directions. A flat is what steepest_row left as kPit; such cells never lie on the
/// border, so all their neighbours exist, and never at sea.
class Flats {
 public:
  Flats(const HeightField& terrain, FlowDirections& directions)
      : z_(terrain.data()), codes_(directions.data()), key_(terrain.frame()), steps_(flow_steps(terrain.width())) {}

  void resolve(const std::vector<int32_t>& stuck, const RunContext& run) {
    gather(stuck);
    if (flat_.empty()) return;
    run.check_cancelled();
    run_from_higher(run);
    run_from_outlets(run);
    run.check_cancelled();
    aim();
    run.check_cancelled();
    gather_in_pits(run);
  }

 private:
  static constexpr uint8_t kFromHigher = 10;  // no direction yet; knows its distance from higher ground
  static constexpr uint8_t kFromOutlet = 11;  // and its distance from the outlet
  static constexpr size_t kCellsPerCheck = size_t{1} << 16;

  bool level(int32_t a, int64_t b) const { return z_[a] == z_[b]; }

  /// Lone pits need nothing; the others are flats.
  void gather(const std::vector<int32_t>& stuck) {
    for (const int32_t cell : stuck) {
      bool alone = true;
      for (const int64_t step : steps_) alone = alone && !level(cell, cell + step);
      if (alone) continue;
      flat_.push_back(cell);
      key_.data()[cell] = 0;
    }
  }

  bool drains(int32_t cell, int64_t other) const { return codes_[other] <= kOutlet && level(cell, other); }

  /// Queues the flat cells that have a neighbour of this kind, as the places that distances are counted from.
  template <class Kind>
  void start(uint8_t mark, const Kind& has) {
    queue_.clear();
    for (const int32_t cell : flat_) {
      if (std::any_of(steps_.begin(), steps_.end(), [&](int64_t step) { return has(cell, cell + step); }))
        queue_.push_back(cell);
    }
    for (const int32_t cell : queue_) codes_[cell] = mark;
    distance_.assign(queue_.size(), 0);
  }

  /// Breadth first over level cells without direction that do not have this mark yet.
  void spread(uint8_t mark, const RunContext& run) {
    for (size_t next = 0; next < queue_.size(); ++next) {
      if (next % kCellsPerCheck == 0) run.check_cancelled();
      const int32_t cell = queue_[next];
      for (const int64_t step : steps_) {
        const auto other = static_cast<int32_t>(cell + step);
        if (codes_[other] < kPit || codes_[other] >= mark || !level(cell, other)) continue;
        codes_[other] = mark;
        queue_.push_back(other);
        distance_.push_back(distance_[next] + 1);
      }
    }
  }

  /// key = distance from higher ground.
  void run_from_higher(const RunContext& run) {
    start(kFromHigher, [&](int32_t cell, int64_t other) { return z_[other] > z_[cell]; });
    spread(kFromHigher, run);
    for (size_t i = 0; i < queue_.size(); ++i) key_.data()[queue_[i]] = distance_[i];
  }

  /// key = 2 x distance from the outlet - distance from higher ground: falls along every shortest way to the outlet.
  void run_from_outlets(const RunContext& run) {
    start(kFromOutlet, [&](int32_t cell, int64_t other) { return drains(cell, other); });
    spread(kFromOutlet, run);
    for (size_t i = 0; i < queue_.size(); ++i) {
      int32_t& key = key_.data()[queue_[i]];
      key = 2 * distance_[i] - key;
    }
  }

  /// Down the steepest way of key_, or out where the outlet is next door.
  void aim() {
    std::vector<uint8_t> aims(queue_.size());
    for (size_t i = 0; i < queue_.size(); ++i) {
      const int32_t cell = queue_[i];
      float best = 0.0F;
      for (uint8_t k = 0; k < 8; ++k) {
        const int64_t other = cell + steps_[k];
        if (!level(cell, other)) continue;
        float fall = 0.0F;
        if (codes_[other] <= kOutlet)
          fall = 1e9F;
        else if (codes_[other] == kFromOutlet)
          fall = static_cast<float>(key_.data()[cell] - key_.data()[other]);
        fall /= kFlowLength[k];
        if (fall <= best) continue;
        best = fall;
        aims[i] = k;
      }
    }
    for (size_t i = 0; i < queue_.size(); ++i) codes_[queue_[i]] = aims[i];
    queue_.clear();
  }

  /// A flat without outlet drains to its first cell.
  void gather_in_pits(const RunContext& run) {
    for (const int32_t first : flat_) {
      run.check_cancelled();
      if (codes_[first] <= kOutlet) continue;
      codes_[first] = kOutlet;  // shut while its flat is walked
      queue_.assign(1, first);
      for (size_t next = 0; next < queue_.size(); ++next) {
        const int32_t cell = queue_[next];
        for (uint8_t k = 0; k < 8; ++k) {
          const auto other = static_cast<int32_t>(cell + steps_[k]);
          if (codes_[other] <= kOutlet || !level(cell, other)) continue;
          codes_[other] = static_cast<uint8_t>((k + 4) % 8);
          queue_.push_back(other);
        }
      }
      closed_.push_back(first);
    }
    for (const int32_t first : closed_) codes_[first] = kPit;
  }

  const float* z_;
  uint8_t* codes_;
  Grid<int32_t> key_;
  std::array<int64_t, 8> steps_;
  std::vector<int32_t> flat_, queue_, distance_, closed_;
};

}  // namespace

FlowDirections flow_directions(const HeightField& terrain, float sea_level_m, const RunContext& run) {
  const GridFrame& frame = terrain.frame();
  FlowDirections directions(frame);
  constexpr int kRows = 32;
  std::vector<std::vector<int32_t>> stuck_in(static_cast<size_t>((frame.height + kRows - 1) / kRows));
  parallel_blocks(run, frame.height, kRows, [&](int64_t begin, int64_t end) {
    steepest_rows(terrain, sea_level_m, directions, static_cast<int>(begin), static_cast<int>(end));
    std::vector<int32_t>& stuck = stuck_in[static_cast<size_t>(begin / kRows)];
    for (int64_t i = begin * frame.width; i < end * frame.width; ++i) {
      if (directions.data()[i] == kPit) stuck.push_back(static_cast<int32_t>(i));
    }
  });
  std::vector<int32_t> stuck;
  for (std::vector<int32_t>& part : stuck_in) {
    stuck.insert(stuck.end(), part.begin(), part.end());
    part = {};
  }
  Flats(terrain, directions).resolve(stuck, run);
  return directions;
}

int64_t count_pits(const FlowDirections& directions) {
  return std::count(directions.cells().begin(), directions.cells().end(), kPit);
}

}  // namespace seamount::geom
