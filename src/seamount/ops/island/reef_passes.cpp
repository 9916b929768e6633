#include "seamount/ops/island/reef_passes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/geom/scalar/segment.h"

namespace seamount::island {
namespace {

/// A place on the middle of the reef and the way out of the lagoon there.
struct Candidate {
  Vec2 place;
  Vec2 gradient;  ///< of x~, per metre
};

constexpr float kMiddle = 3.6F;
constexpr int kLatticeSide = 512;

/// Places where x~ passes kMiddle, looked for at every few cells of a large raster.
std::vector<Candidate> places_on_reef(const ScalarField& coordinate) {
  const GridFrame& frame = coordinate.frame();
  const int step = std::max(1, std::max(frame.width, frame.height) / kLatticeSide);
  const double span = 2.0 * step * frame.cell_m;
  std::vector<Candidate> places;
  for (int y = step; y + step < frame.height; y += step) {
    for (int x = step; x + step < frame.width; x += step) {
      const bool inside = coordinate(x, y) < kMiddle;
      if (inside == (coordinate(x + step, y) < kMiddle) && inside == (coordinate(x, y + step) < kMiddle)) continue;
      const Vec2 gradient{(coordinate(x + step, y) - coordinate(x - step, y)) / span,
                          (coordinate(x, y - step) - coordinate(x, y + step)) / span};
      if (std::hypot(gradient.x, gradient.y) > 1e-9) places.push_back({{frame.x(x), frame.y(y)}, gradient});
    }
  }
  return places;
}

/// The place in a direction from the middle of them all: the same on rasters of any resolution.
const Candidate& place_towards(const std::vector<Candidate>& places, Vec2 middle, double angle) {
  const Vec2 direction{std::cos(angle), std::sin(angle)};
  const Candidate* best = &places.front();
  double best_cosine = -2.0;
  for (const Candidate& place : places) {
    const Vec2 d = place.place - middle;
    const double cosine = dot(d, direction) / std::max(1e-9, std::sqrt(dot(d, d)));
    if (cosine <= best_cosine) continue;
    best_cosine = cosine;
    best = &place;
  }
  return *best;
}

double squared_distance(Vec2 a, Vec2 b) { return dot(a - b, a - b); }

}  // namespace

ReefPasses::ReefPasses(const ScalarField& coordinate, int count, double width_m, Seed seed, const RunContext& run) {
  run.check_cancelled();
  const std::vector<Candidate> places = places_on_reef(coordinate);
  if (places.empty()) return;
  double steepness = 0;
  Vec2 middle;
  for (const Candidate& place : places) {
    steepness += std::hypot(place.gradient.x, place.gradient.y);
    middle = middle + (1.0 / static_cast<double>(places.size())) * place.place;
  }
  reef_width_m_ = static_cast<double>(places.size()) / steepness;

  Rng rng(seed.derive("island.passes"));
  std::vector<Candidate> chosen;
  constexpr int kTries = 12;  // best of twelve: spread out, but not evenly
  for (int k = 0; k < count; ++k) {
    const Candidate* best = nullptr;
    double best_distance = 16.0 * width_m * width_m;  // at least four widths apart
    for (int t = 0; t < kTries; ++t) {
      const Candidate& place = place_towards(places, middle, rng.uniform(0.0, 2.0 * std::numbers::pi));
      double nearest = 1e300;
      for (const Candidate& other : chosen) nearest = std::min(nearest, squared_distance(place.place, other.place));
      if (nearest < best_distance) continue;
      best = &place;
      best_distance = nearest;
    }
    if (best == nullptr) continue;
    chosen.push_back(*best);
    const double steep = std::hypot(best->gradient.x, best->gradient.y);
    const double length = 0.9 / steep;
    const Vec2 out = (1.0 / steep) * best->gradient;
    const double turn = rng.uniform(-0.5, 0.5);
    const Vec2 way{out.x * std::cos(turn) - out.y * std::sin(turn), out.x * std::sin(turn) + out.y * std::cos(turn)};
    passes_.push_back({best->place - length * way, best->place + length * way, 0.5 * width_m * rng.uniform(0.6, 1.4)});
  }
}

void ReefPasses::row(const GridFrame& frame, int y, std::span<float> out) const {
  std::fill(out.begin(), out.end(), 0.0F);
  const double py = frame.y(y);
  for (const Pass& pass : passes_) {
    const double reach = 1.6 * pass.half_width_m;
    if (py < std::min(pass.inner.y, pass.outer.y) - reach || py > std::max(pass.inner.y, pass.outer.y) + reach)
      continue;
    const double west = std::min(pass.inner.x, pass.outer.x) - reach;
    const double east = std::max(pass.inner.x, pass.outer.x) + reach;
    const int begin = std::clamp(static_cast<int>(frame.column(west)), 0, frame.width);
    const int end = std::clamp(static_cast<int>(frame.column(east)) + 2, 0, frame.width);
    for (int x = begin; x < end; ++x) {
      const Vec2 p{frame.x(x), py};
      const double d = std::sqrt(geom::squared_distance_to_segment(p, pass.inner, pass.outer)) / pass.half_width_m;
      const double weight = 1.0 / (1.0 + std::pow(d, 6.0));
      out[static_cast<size_t>(x)] = std::max(
          out[static_cast<size_t>(x)], static_cast<float>(d < 1.6 ? weight * (1.0 - std::pow(d / 1.6, 8.0)) : 0.0));
    }
  }
}

}  // namespace seamount::island
