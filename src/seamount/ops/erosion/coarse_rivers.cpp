#include "seamount/ops/erosion/coarse_rivers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/water/flow_flats.h"

namespace seamount::erosion {
namespace {

constexpr double kSecondsOfYear = 3.156e7;
constexpr double kWidthOfFlow = 5.0;  ///< m of width per root of m3/s: alluvial rivers, Leopold and Maddock 1953

struct Place {
  double x = 0.0, y = 0.0, z = 0.0;
};

Place middle(const Place& a, const Place& b) { return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y), 0.5 * (a.z + b.z)}; }

/// A quadratic Bezier curve, and the width of the river.
struct Course {
  Place from, by, to;
  double width_m = 0.0;

  Place at(double t) const {
    const double a = (1 - t) * (1 - t), b = 2 * t * (1 - t), c = t * t;
    return {a * from.x + b * by.x + c * to.x, a * from.y + b * by.y + c * to.y, a * from.z + b * by.z + c * to.z};
  }
};

/// The coarse cells within [left, right) x [top, bottom) as a raster of their own; their positions are the whole's.
struct Part {
  int left, top, right, bottom;

  Part(const GridFrame& fine, const GridFrame& coarse) {
    constexpr int kMargin = 5;
    const auto within = [](double at, int size) { return std::clamp(static_cast<int>(std::floor(at)), 0, size - 1); };
    left = std::max(0, within(coarse.column(fine.x(-1)), coarse.width) - kMargin);
    right = std::min(coarse.width, within(coarse.column(fine.x(fine.width)), coarse.width) + kMargin + 2);
    top = std::max(0, within(coarse.row(fine.y(-1)), coarse.height) - kMargin);
    bottom = std::min(coarse.height, within(coarse.row(fine.y(fine.height)), coarse.height) + kMargin + 2);
  }

  Grid<float> cut(const Grid<float>& whole) const {
    Grid<float> made(whole.frame().window(left, top, right - left, bottom - top));
    for (int y = 0; y < made.height(); ++y) {
      const auto from = whole.row(top + y).subspan(static_cast<size_t>(left), static_cast<size_t>(made.width()));
      std::copy(from.begin(), from.end(), made.row(y).begin());
    }
    return made;
  }
};

class CoarseRivers {
 public:
  CoarseRivers(HeightField worn, ScalarField flow, const RiverCourses& courses, Seed seed, const RunContext& run)
      : seed_(seed),
        worn_(std::move(worn)),
        flow_(std::move(flow)),
        courses_(courses),
        directions_(geom::steepest_directions(worn_, courses.sea_m, run)) {}

  std::vector<Course> all() const {
    std::vector<Course> made;
    for (int y = 0; y < worn_.height(); ++y)
      for (int x = 0; x < worn_.width(); ++x) add(x, y, made);
    return made;
  }

 private:
  bool is_river(int x, int y) const { return directions_(x, y) < geom::kOutlet && flow_(x, y) >= courses_.least_flow; }

  Place place(int x, int y) const {
    const GridFrame& frame = worn_.frame();
    const auto column = static_cast<uint64_t>(frame.first_column() + x),
               row = static_cast<uint64_t>(frame.first_row() + y);
    Rng rng(seed_.derive("course", column << 32 | row));
    const double bend = courses_.bend;
    const double dx = rng.uniform(-bend, bend), dy = rng.uniform(-bend, bend);
    return {frame.x(x + dx), frame.y(y + dy), std::max(worn_(x, y), courses_.sea_m)};
  }

  /// The courses through a cell: from each river that enters it, or from its own middle.
  void add(int x, int y, std::vector<Course>& made) const {
    if (!is_river(x, y)) return;
    const uint8_t code = directions_(x, y);
    const Place here = place(x, y), end = middle(here, place(x + geom::kFlowDx[code], y + geom::kFlowDy[code]));
    const double width = kWidthOfFlow * std::sqrt(static_cast<double>(flow_(x, y)) / kSecondsOfYear);
    bool entered = false;
    for (size_t k = 0; k < 8; ++k) {
      const int nx = x + geom::kFlowDx[k], ny = y + geom::kFlowDy[k];
      if (nx < 0 || ny < 0 || nx >= worn_.width() || ny >= worn_.height() || !is_river(nx, ny)) continue;
      if (directions_(nx, ny) != (k + 4) % 8) continue;
      made.push_back({middle(place(nx, ny), here), here, end, width});
      entered = true;
    }
    if (!entered) made.push_back({here, middle(here, end), end, width});
  }

  Seed seed_;
  HeightField worn_;
  ScalarField flow_;
  RiverCourses courses_;
  geom::FlowDirections directions_;
};

/// Lowers the ground around one place of a river.
class Stamp {
 public:
  Stamp(RiverGround& ground, const GridFrame& fine, double reach_m, double slope)
      : ground_(ground), fine_(fine), reach_m_(reach_m), slope_(slope) {}

  void put(const Place& at, double width_m) {
    const double half = std::min(std::max(0.5 * width_m, 0.71 * fine_.cell_m), reach_m_), reach = reach_m_;
    const int x0 = first(fine_.column(at.x - reach), fine_.width), x1 = last(fine_.column(at.x + reach), fine_.width);
    const int y0 = first(fine_.row(at.y + reach), fine_.height), y1 = last(fine_.row(at.y - reach), fine_.height);
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        const double dx = fine_.x(x) - at.x, dy = fine_.y(y) - at.y, distance = std::sqrt(dx * dx + dy * dy);
        if (distance > reach) continue;
        const double beside = std::max(0.0, distance - half);
        float &highest = ground_.highest(x, y), &nearest = ground_.distance(x, y);
        highest = std::min(highest, static_cast<float>(at.z + slope_ * beside));
        nearest = std::min(nearest, static_cast<float>(beside));
      }
    }
  }

 private:
  static int first(double at, int size) { return std::clamp(static_cast<int>(std::ceil(at)), 0, size); }
  static int last(double at, int size) { return std::clamp(static_cast<int>(std::floor(at)), -1, size - 1); }

  RiverGround& ground_;
  const GridFrame& fine_;
  double reach_m_, slope_;
};

}  // namespace

RiverGround river_ground(const GridFrame& fine, const HeightField& worn, const ScalarField& flow,
                         const RiverCourses& courses, Seed seed, const RunContext& run) {
  RiverGround ground{ScalarField(fine, std::numeric_limits<float>::infinity()),
                     ScalarField(fine, static_cast<float>(worn.cell_m()))};
  const Part part(fine, worn.frame());
  const std::vector<Course> all = CoarseRivers(part.cut(worn), part.cut(flow), courses, seed, run).all();
  const double coarse_m = worn.cell_m();
  Stamp stamp(ground, fine, coarse_m, courses.side_slope);
  const int steps = 3 * static_cast<int>(std::ceil(coarse_m / fine.cell_m));  // a curve is shorter than 1.5 cells
  for (const Course& course : all) {
    run.check_cancelled();
    for (int i = 0; i <= steps; ++i) stamp.put(course.at(static_cast<double>(i) / steps), course.width_m);
  }
  return ground;
}

}  // namespace seamount::erosion
