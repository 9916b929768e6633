#include "seamount/ops/contour/growth/probability.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/base/text.h"
#include "seamount/geom/scalar/noise_places.h"

namespace seamount::contour {
namespace {

constexpr int64_t kGrain = 4096;
constexpr double kMinNoise = 0.25;  ///< before it is raised: growth that all but stops leaves cliffs

/// Every cell, also where no node lies: a map with a bad cell is a mistake wherever that is.
void check_field(const ScalarField& field) {
  for (int y = 0; y < field.height(); ++y) {
    for (int x = 0; x < field.width(); ++x) {
      const float p = field(x, y);
      if (p >= 0.0F && p <= 1.0F) continue;
      throw IncompatibleInputs("probability: " + (std::isnan(p) ? "no value" : format_number(static_cast<double>(p))) +
                               " at (" + format_number(field.frame().x(x)) + ", " + format_number(field.frame().y(y)) +
                               ") m; probabilities are numbers in [0, 1]");
    }
  }
}

double bilinear(const ScalarField& field, Vec2 place) {
  const double column = std::clamp(field.frame().column(place.x), 0.0, field.width() - 1.0);
  const double row = std::clamp(field.frame().row(place.y), 0.0, field.height() - 1.0);
  const auto x = static_cast<int>(column);
  const auto y = static_cast<int>(row);
  const double u = column - x, v = row - y;
  const auto at = [&](int dx, int dy) { return static_cast<double>(field.clamped(x + dx, y + dy)); };
  return (1 - v) * ((1 - u) * at(0, 0) + u * at(1, 0)) + v * ((1 - u) * at(0, 1) + u * at(1, 1));
}

double raise(double p, double exponent) { return exponent == 1.0 ? p : std::pow(p, exponent); }

}  // namespace

std::vector<float> noise_probability(std::span<const Vec2> places, const geom::Fbm& shape, double exponent, Seed seed,
                                     const RunContext& run) {
  constexpr double kContrast = 0.75;  // noise has a deviation of about 0.35
  const double slowest = std::log(kMinNoise) * exponent;
  std::vector<float> probability(places.size());
  parallel_blocks(run, static_cast<int64_t>(places.size()), kGrain, [&](int64_t begin, int64_t end) {
    std::vector<double> noises(static_cast<size_t>(end - begin));
    geom::fbm_places(seed, shape, places.subspan(static_cast<size_t>(begin), noises.size()), noises);
    for (auto i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i) {
      const double noise = 0.5 + kContrast * noises[i - static_cast<size_t>(begin)];
      probability[i] = static_cast<float>(std::exp(slowest * (1.0 - std::clamp(noise, 0.0, 1.0))));
    }
  });
  return probability;
}

std::vector<float> field_probability(std::span<const Vec2> places, const ScalarField& field, double exponent,
                                     const RunContext& run) {
  check_field(field);
  std::vector<float> probability(places.size());
  parallel_blocks(run, static_cast<int64_t>(places.size()), kGrain, [&](int64_t begin, int64_t end) {
    for (auto i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i) {
      probability[i] = static_cast<float>(raise(bilinear(field, places[i]), exponent));
    }
  });
  return probability;
}

ScalarField painted_probability(const Image& picture, const GridFrame& domain) {
  // Square cells as fine as the picture's pixels are where they are finest, unless those would be far too many.
  constexpr double kMostCells = 4e6;
  const double wide = domain.width_m() / picture.width, high = domain.height_m() / picture.height;
  const double pixels = static_cast<double>(picture.width) * picture.height;
  const double least = std::sqrt(wide * high * pixels / std::max(kMostCells, pixels));
  GridFrame frame = domain;
  frame.width = std::max(1, static_cast<int>(std::lround(domain.width_m() / std::max(std::min(wide, high), least))));
  frame.cell_m = domain.width_m() / frame.width;
  frame.height = std::max(1, static_cast<int>(std::lround(domain.height_m() / frame.cell_m)));
  ScalarField field(frame);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const int column = static_cast<int>(int64_t{x} * picture.width / frame.width);
      const int row = static_cast<int>(int64_t{y} * picture.height / frame.height);
      const uint8_t* pixel = picture.pixel(column, row);
      field(x, y) = static_cast<float>(pixel[0] + pixel[1] + pixel[2]) / (3.0F * 255.0F);
    }
  }
  return field;
}

}  // namespace seamount::contour
