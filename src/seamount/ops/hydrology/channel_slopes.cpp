#include "seamount/ops/hydrology/channel_slopes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace seamount::hydrology {
namespace {

constexpr int kBinsPerDecade = 4;

/// Of one bin of area.
struct Bin {
  double fall = 0.0, way = 0.0, log_area = 0.0;  ///< log_area: times way
};

class Reader {
 public:
  Reader(const HeightField& terrain, const HeightField& filled, const geom::FlowDirections& directions,
         const Grid<uint32_t>& cells, float sea_level_m)
      : terrain_(terrain),
        filled_(filled),
        directions_(directions),
        cells_(cells),
        sea_(sea_level_m),
        cell_m2_(terrain.cell_m() * terrain.cell_m()),
        steps_(geom::flow_steps(terrain.width())) {}

  ChannelSlopes read(const RunContext& run) {
    find_limits();
    for (int y = 0; y < terrain_.height(); ++y) {
      run.check_cancelled();
      for (int x = 0; x < terrain_.width(); ++x) {
        const int64_t cell = static_cast<int64_t>(y) * terrain_.width() + x;
        if (!flows(cell)) continue;
        if (area(cell) < from_m2_)
          add(fall(cell), way(cell), std::log10(area(cell)) * way(cell));
        else if (main_donor(cell) < 0)
          read_river(cell);
      }
    }
    return {curve(), concavity(), from_m2_};
  }

 private:
  bool flows(int64_t cell) const { return terrain_.data()[cell] > sea_ && directions_.data()[cell] < 8; }
  double area(int64_t cell) const { return static_cast<double>(cells_.data()[cell]) * cell_m2_; }
  int64_t down(int64_t cell) const { return cell + steps_[directions_.data()[cell]]; }
  double way(int64_t cell) const {
    return static_cast<double>(geom::kFlowLength[directions_.data()[cell]]) * terrain_.cell_m();
  }
  double fall(int64_t cell) const {
    return static_cast<double>(filled_.data()[cell]) - std::max<double>(sea_, filled_.data()[down(cell)]);
  }

  void find_limits() {
    constexpr double kRiver = 1e6, kDecade = 10.0, kFewestCells = 16.0, kFall = 20.0, kReliefPart = 50.0;
    double most = 0.0, low = std::numeric_limits<double>::infinity(), high = -low;
    for (int64_t i = 0; i < terrain_.frame().cells(); ++i) {
      if (!(terrain_.data()[i] > sea_)) continue;
      most = std::max(most, area(i));
      low = std::min<double>(low, terrain_.data()[i]);
      high = std::max<double>(high, terrain_.data()[i]);
    }
    from_m2_ = std::max(std::min(kRiver, most / kDecade), kFewestCells * cell_m2_);
    fall_m_ = std::min(kFall, (high - low) / kReliefPart);
  }

  /// The neighbour above from which most water comes, if it is a river.
  int64_t main_donor(int64_t cell) const {
    const int x = static_cast<int>(cell % terrain_.width()), y = static_cast<int>(cell / terrain_.width());
    int64_t best = -1;
    for (size_t k = 0; k < 8; ++k) {
      if (!terrain_.contains(x + geom::kFlowDx[k], y + geom::kFlowDy[k])) continue;
      const int64_t other = cell + steps_[k];
      if (directions_.data()[other] != (k + 4) % 8 || !flows(other) || area(other) < from_m2_) continue;
      if (best < 0 || cells_.data()[other] > cells_.data()[best]) best = other;
    }
    return best;
  }

  void read_river(int64_t cell) {
    double fallen = 0.0, gone = 0.0, log_area = 0.0;
    while (flows(cell)) {
      fallen += fall(cell);
      gone += way(cell);
      log_area += std::log10(area(cell)) * way(cell);
      const int64_t next = down(cell);
      const bool joins = !flows(next) || main_donor(next) != cell;
      if (fallen >= fall_m_ || joins) {
        add(fallen, gone, log_area);
        fallen = gone = log_area = 0.0;
      }
      if (joins) return;
      cell = next;
    }
  }

  void add(double fallen, double gone, double log_area) {
    const double bin = std::floor(std::max(0.0, log_area / gone) * kBinsPerDecade);
    Bin& sum = bins_[static_cast<size_t>(std::min(bin, static_cast<double>(bins_.size() - 1)))];
    sum.fall += fallen;
    sum.way += gone;
    sum.log_area += log_area;
  }

  bool counts(const Bin& bin) const {
    constexpr double kFewestCells = 8.0;
    return bin.way >= kFewestCells * terrain_.cell_m() && bin.fall > 0.0;
  }

  std::vector<SlopeOfArea> curve() const {
    std::vector<SlopeOfArea> line;
    for (const Bin& bin : bins_)
      if (counts(bin)) line.push_back({std::pow(10.0, bin.log_area / bin.way), bin.fall / bin.way});
    return line;
  }

  /// Least squares over the bins of rivers, each with the weight of its way.
  double concavity() const {
    constexpr int kFewestBins = 3;
    double weight = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    int count = 0;
    for (const Bin& bin : bins_) {
      if (!counts(bin) || bin.log_area / bin.way < std::log10(from_m2_)) continue;
      const double log_area = bin.log_area / bin.way, log_slope = std::log10(bin.fall / bin.way);
      weight += bin.way;
      x += bin.way * log_area;
      y += bin.way * log_slope;
      xx += bin.way * log_area * log_area;
      xy += bin.way * log_area * log_slope;
      ++count;
    }
    const double spread = weight * xx - x * x;
    return count >= kFewestBins && spread > 0.0 ? -(weight * xy - x * y) / spread
                                                : std::numeric_limits<double>::quiet_NaN();
  }

  const HeightField& terrain_;
  const HeightField& filled_;
  const geom::FlowDirections& directions_;
  const Grid<uint32_t>& cells_;
  float sea_;
  double cell_m2_, from_m2_ = 0.0, fall_m_ = 0.0;
  std::array<int64_t, 8> steps_;
  std::array<Bin, 16 * kBinsPerDecade> bins_ = {};
};

}  // namespace

ChannelSlopes channel_slopes(const HeightField& terrain, const HeightField& filled,
                             const geom::FlowDirections& directions, const Grid<uint32_t>& cells, float sea_level_m,
                             const RunContext& run) {
  return Reader(terrain, filled, directions, cells, sea_level_m).read(run);
}

}  // namespace seamount::hydrology
