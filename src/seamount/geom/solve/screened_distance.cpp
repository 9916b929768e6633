#include "seamount/geom/solve/screened_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/text.h"

namespace seamount::geom {
namespace {

/// Concentrations in double precision: their logarithm is wanted far from where they are large.
class Screened {
 public:
  Screened(const Grid<uint8_t>& inside, double length_m)
      : inside_(inside), decay_(inside.cell_m() * inside.cell_m() / (length_m * length_m)), c_(inside.size()) {
    for (size_t i = 0; i < c_.size(); ++i) c_[i] = inside.cells()[i] != 0 ? 1.0 : 0.0;
  }

  /// Cell after cell, from the west (or east) and north (or south); the largest share by which one grew.
  double sweep(bool east, bool south) {
    const int width = inside_.width(), height = inside_.height();
    double most = 0.0;
    for (int j = 0; j < height; ++j) {
      const int y = south ? j : height - 1 - j;
      for (int i = 0; i < width; ++i) {
        const int x = east ? i : width - 1 - i;
        const size_t k = static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
        if (inside_.cells()[k] != 0) continue;
        double sum = 0.0, links = decay_;
        const auto add = [&](bool there, size_t neighbour) {
          if (!there) return;
          sum += c_[neighbour];
          links += 1.0;
        };
        add(x > 0, k - 1);
        add(x + 1 < width, k + 1);
        add(y > 0, k - static_cast<size_t>(width));
        add(y + 1 < height, k + static_cast<size_t>(width));
        const double value = sum / links;
        if (value > kNothing) most = std::max(most, (value - c_[k]) / value);
        c_[k] = value;
      }
    }
    return most;
  }

  double value(size_t i) const { return c_[i]; }

  static constexpr double kNothing = 1e-300;

 private:
  const Grid<uint8_t>& inside_;
  double decay_;
  std::vector<double> c_;
};

}  // namespace

ScalarField screened_distance(const Grid<uint8_t>& inside, double length_m, const RunContext& run) {
  if (!(length_m > 0.0) || !std::isfinite(length_m))
    throw InvalidArgument("length_m", format_number(length_m) + " is not a length above 0");
  ScalarField out(inside.frame(), std::numeric_limits<float>::infinity());
  if (std::none_of(inside.cells().begin(), inside.cells().end(), [](uint8_t v) { return v != 0; })) return out;
  constexpr int kMostRounds = 2000;
  constexpr double kGrowth = 1e-5;  // a round: concentrations only grow, by less and less
  Screened screened(inside, length_m);
  bool still = false;
  for (int n = 0; n < kMostRounds && !still; ++n) {
    run.check_cancelled();
    double most = 0.0;
    for (const bool south : {true, false})
      for (const bool east : {true, false}) most = std::max(most, screened.sweep(east, south));
    still = most < kGrowth;
  }
  if (!still) run.say("screened distance: not settled after " + std::to_string(kMostRounds) + " rounds of sweeps");
  for (size_t i = 0; i < out.size(); ++i) {
    const double c = screened.value(i);
    if (c > Screened::kNothing) out.cells()[i] = static_cast<float>(std::max(0.0, -length_m * std::log(c)));
  }
  return out;
}

}  // namespace seamount::geom
