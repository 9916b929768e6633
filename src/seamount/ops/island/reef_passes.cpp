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
constexpr double kReefPerPass_m = 16000.0;

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

double squared_distance_to(const std::vector<Vec2>& places, Vec2 p) {
  double nearest = 1e300;
  for (const Vec2 place : places) nearest = std::min(nearest, dot(place - p, place - p));
  return nearest;
}

const Candidate& nearest_to(const std::vector<Candidate>& places, Vec2 p) {
  const Candidate* best = &places.front();
  for (const Candidate& place : places) {
    if (dot(place.place - p, place.place - p) < dot(best->place - p, best->place - p)) best = &place;
  }
  return *best;
}

/// Length of the reef along its middle: a step of length has 0.9 nodes whose right or lower neighbour lies across it,
/// directions averaged.
double reef_length(const std::vector<Candidate>& places, const GridFrame& frame) {
  const int step = std::max(1, std::max(frame.width, frame.height) / kLatticeSide);
  return static_cast<double>(places.size()) * step * frame.cell_m / 0.9;
}

}  // namespace

ReefPasses::ReefPasses(const ScalarField& coordinate, int count, double width_m, const std::vector<RiverMouth>& mouths,
                       Seed seed, const RunContext& run) {
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
  const double length_m = reef_length(places, coordinate.frame());
  if (count < 0) count = std::max(2, static_cast<int>(std::lround(length_m / kReefPerPass_m)));
  if (count == 0) return;

  Rng rng(seed.derive("island.passes"));
  std::vector<Vec2> chosen;
  const auto open = [&](const Candidate& at) {
    chosen.push_back(at.place);
    const double steep = std::hypot(at.gradient.x, at.gradient.y);
    const double length = 0.9 / steep;
    const Vec2 out = (1.0 / steep) * at.gradient;
    const double turn = rng.uniform(-0.5, 0.5);
    const Vec2 way{out.x * std::cos(turn) - out.y * std::sin(turn), out.x * std::sin(turn) + out.y * std::cos(turn)};
    passes_.push_back({at.place - length * way, at.place + length * way, 0.5 * width_m * rng.uniform(0.6, 1.4)});
  };
  const double apart = std::max(4.0 * width_m, 0.45 * length_m / count);
  for (const RiverMouth& mouth : mouths) {
    if (static_cast<int>(chosen.size()) >= count) break;
    const Candidate& off = nearest_to(places, mouth.place);
    if (squared_distance_to(chosen, off.place) > apart * apart) open(off);
  }
  constexpr int kTries = 12;  // best of twelve: spread out, but not evenly
  for (int k = static_cast<int>(chosen.size()); k < count; ++k) {
    const Candidate* best = nullptr;
    double best_distance = 16.0 * width_m * width_m;  // at least four widths apart
    for (int t = 0; t < kTries; ++t) {
      const Candidate& place = place_towards(places, middle, rng.uniform(0.0, 2.0 * std::numbers::pi));
      const double nearest = squared_distance_to(chosen, place.place);
      if (nearest < best_distance) continue;
      best = &place;
      best_distance = nearest;
    }
    if (best != nullptr) open(*best);
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
