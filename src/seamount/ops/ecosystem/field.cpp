#include "seamount/ops/ecosystem/field.h"

#include <algorithm>

#include "seamount/ops/ecosystem/survey.h"

namespace seamount::ecosystem {
namespace {

geom::Expression expression_of(const Scene& scene, const Rules& rules, const FieldParams& params) {
  if (!params.fitness_of.empty())
    return rules.classes[class_named(scene.catalogue, params.fitness_of, "fitness_of")].fitness;
  try {
    return geom::Expression::parse(params.of, vocabulary_of(scene.catalogue));
  } catch (const geom::ExpressionError& error) {
    throw InvalidArgument("of", "column " + std::to_string(error.column()) + ": " + error.what());
  }
}

}  // namespace

ScalarField field_of(const Scene& scene, const Site& site, const FieldParams& params, const RunContext& run) {
  check_params(params);
  if (params.of.empty() == params.fitness_of.empty())
    throw InvalidArgument("of", "give either an expression or a class in 'fitness_of'");
  Rules rules = compile(scene.catalogue);
  const geom::Expression expression = expression_of(scene, rules, params);
  mark_screened(scene.catalogue, expression, rules);
  const Environment environment =
      make_environment(scene, rules, site, params.window, scene.iteration, run.part(0, 0.6));
  const Survey survey(scene, environment, run);
  ScalarField made(environment.frame);
  std::vector<Vec2> places(static_cast<size_t>(made.width()));
  std::vector<double> values(places.size());
  for (int y = 0; y < made.height(); ++y) {
    run.check_cancelled();
    for (int x = 0; x < made.width(); ++x) places[static_cast<size_t>(x)] = {made.frame().x(x), made.frame().y(y)};
    survey.ask(expression, {places}, values);
    std::transform(values.begin(), values.end(), made.row(y).begin(), [](double v) { return static_cast<float>(v); });
  }
  return made;
}

GroundAndCurrent height(const Scene& scene, const Site& site, const HeightParams& params, const RunContext& run) {
  check_params(params);
  const Rules rules = compile(scene.catalogue);
  Environment environment = make_environment(scene, rules, site, params.window, scene.iteration, run);
  const auto level = static_cast<float>(environment.water_level_m);
  for (float& z : environment.height.cells()) z += level;
  return {std::move(environment.height), std::move(environment.current)};
}

}  // namespace seamount::ecosystem
