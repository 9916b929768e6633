#include "seamount/ops/ecosystem/fitness.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/geom/polygon/polygon.h"
#include "seamount/ops/ecosystem/births.h"

namespace seamount::ecosystem {
namespace {

constexpr int kRaster = 8;

/// Objects of one class and all places that they are asked at.
struct Questions {
  std::vector<size_t> objects;  ///< positions in the caller's list
  std::vector<size_t> starts = {0};
  std::vector<Vec2> places;
  std::vector<int32_t> self;
  std::vector<double> age;
};

double answer(const Questions& questions, size_t k, const std::vector<double>& values,
              const std::vector<bool>& allowed) {
  const size_t first = questions.starts[k], last = questions.starts[k + 1];
  double sum = 0.0;
  size_t refused = 0;
  for (size_t i = first; i < last; ++i) {
    sum += values[i];
    refused += allowed[i] ? 0 : 1;
  }
  if (2 * refused > last - first) return -std::numeric_limits<double>::infinity();
  return sum / static_cast<double>(last - first);
}

}  // namespace

std::vector<Vec2> places_of(const Skeleton& skeleton) {
  if (skeleton.kind != SkeletonKind::region) return skeleton.points;
  const auto [low, high] = geom::bounding_box(skeleton.points);
  std::vector<Vec2> places;
  for (int row = 0; row < kRaster; ++row) {
    for (int column = 0; column < kRaster; ++column) {
      const Vec2 p{low.x + (column + 0.5) / kRaster * (high.x - low.x),
                   low.y + (row + 0.5) / kRaster * (high.y - low.y)};
      if (geom::contains(skeleton.points, p)) places.push_back(p);
    }
  }
  return places.empty() ? skeleton.points : places;
}

std::vector<double> fitness_of(const Scene& scene, const Rules& rules, const Environment& environment,
                               std::span<const size_t> objects, const RunContext& run) {
  std::vector<Questions> of_class(scene.catalogue.classes.size());
  for (size_t k = 0; k < objects.size(); ++k) {
    const SceneObject& object = scene.objects[objects[k]];
    Questions& questions = of_class[static_cast<size_t>(object.of_class)];
    for (const Vec2 p : places_of(object.skeleton)) {
      questions.places.push_back(p);
      questions.self.push_back(static_cast<int32_t>(objects[k]));
      questions.age.push_back(iterations_in(scene, object.window) - object.born);
    }
    questions.objects.push_back(k);
    questions.starts.push_back(questions.places.size());
  }
  std::vector<double> fitness(objects.size());
  for (size_t c = 0; c < of_class.size(); ++c) {
    const Questions& questions = of_class[c];
    if (questions.objects.empty()) continue;
    std::vector<double> values(questions.places.size());
    Survey(scene, environment, run)
        .ask(rules.classes[c].fitness, {questions.places, questions.self, questions.age}, values);
    const std::vector<bool> allowed = allowed_places(rules, environment, static_cast<int>(c), questions.places, run);
    for (size_t k = 0; k < questions.objects.size(); ++k)
      fitness[questions.objects[k]] = answer(questions, k, values, allowed);
  }
  return fitness;
}

}  // namespace seamount::ecosystem
