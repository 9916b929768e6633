#include "seamount/geom/current/diverted_current.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/base/text.h"
#include "seamount/geom/grid/surface.h"

namespace seamount::geom {
namespace {

void check(const HeightField& height, const DiversionOptions& options) {
  const auto at_least_0 = [](const std::string& name, double value) {
    if (!(value >= 0.0) || !std::isfinite(value))
      throw InvalidArgument(name, format_number(value) + " is not a number of 0 or more");
  };
  if (!std::isfinite(options.base_m_s.x) || !std::isfinite(options.base_m_s.y))
    throw InvalidArgument("base_m_s", "is no number");
  at_least_0("venturi_per_m", options.venturi_per_m);
  at_least_0("shallows_m", options.shallows_m);
  if (!(options.most_gain > 0.0)) throw InvalidArgument("most_gain", "is not above 0");
  for (size_t i = 0; i < options.scales.size(); ++i) {
    const std::string name = "scales[" + std::to_string(i) + "].";
    at_least_0(name + "sigma_m", options.scales[i].sigma_m);
    at_least_0(name + "weight", options.scales[i].weight);
    at_least_0(name + "deviation", options.scales[i].deviation);
  }
  for (const float z : height.cells())
    if (!std::isfinite(z)) throw InvalidArgument("height", "has cells that are no numbers");
}

/// The current beside a slope: eq. 1.53.
Vec2 diverted(Vec2 v, Vec2 gradient, const DiversionScale& scale, double most_gain) {
  constexpr double kTurn = 0.2;  // sine of the angle to the line of fall within which no side is chosen
  const double slope = std::sqrt(dot(gradient, gradient)), speed = std::sqrt(dot(v, v));
  if (slope < 1e-9 || speed < 1e-12) return v;
  const Vec2 contour = (1.0 / slope) * Vec2{-gradient.y, gradient.x};
  const double side = std::clamp(dot(contour, v) / (kTurn * speed), -1.0, 1.0);
  const double alpha = std::min(1.0, slope);
  return (1.0 - alpha) * v + (alpha * speed * std::min(scale.deviation * slope, most_gain) * side) * contour;
}

/// 0 on dry land, 1 from the depth shallows_m on.
double water_share(double height, double shallows_m) {
  if (shallows_m <= 0.0) return 1.0;
  const double t = std::clamp(-height / shallows_m, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace

VectorField diverted_current(const HeightField& height_above_water, const DiversionOptions& options,
                             const RunContext& run) {
  check(height_above_water, options);
  const GridFrame& frame = height_above_water.frame();
  VectorField current{ScalarField(frame, 0.0F), ScalarField(frame, 0.0F)};
  const size_t count = options.scales.size();
  for (size_t k = 0; k < count; ++k) {
    const DiversionScale& scale = options.scales[k];
    const RunContext part = run.part(static_cast<double>(k) / static_cast<double>(count),
                                     static_cast<double>(k + 1) / static_cast<double>(count));
    const HeightField smooth = at_scale(height_above_water, 2.0 * scale.sigma_m, part.part(0.0, 0.7));
    parallel_rows(part.part(0.7, 1.0), frame.width, frame.height, [&](int begin, int end) {
      for (int y = begin; y < end; ++y) {
        const int up = std::max(y - 1, 0), down = std::min(y + 1, frame.height - 1);
        for (int x = 0; x < frame.width; ++x) {
          const int left = std::max(x - 1, 0), right = std::min(x + 1, frame.width - 1);
          const auto slope = [&](float from, float to, int steps) {
            return steps > 0 ? static_cast<double>(to - from) / (steps * frame.cell_m) : 0.0;
          };
          const Vec2 gradient{slope(smooth(left, y), smooth(right, y), right - left),
                              slope(smooth(x, down), smooth(x, up), down - up)};
          const auto height = static_cast<double>(height_above_water(x, y));
          const Vec2 v = (1.0 + options.venturi_per_m * std::abs(height)) * options.base_m_s;
          const Vec2 w = (scale.weight * water_share(height, options.shallows_m)) *
                         diverted(v, gradient, scale, options.most_gain);
          current.x(x, y) += static_cast<float>(w.x);
          current.y(x, y) += static_cast<float>(w.y);
        }
      }
    });
  }
  return current;
}

}  // namespace seamount::geom
