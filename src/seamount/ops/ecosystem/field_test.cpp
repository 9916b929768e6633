#include "seamount/ops/ecosystem/field.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "seamount/base/error.h"
#include "seamount/ops/ecosystem/test_scene.h"
#include "seamount/ops/ecosystem/words.h"

namespace seamount::ecosystem {
namespace {

/// An island, a line and a coral in still water on a slope.
Scene small_scene(const HeightField& ground) {
  Scene scene = still_scene(ground.frame());
  scene.catalogue.materials = {material("sand")};
  scene.catalogue.classes = {region("island", "1"), curve("line", "1"), point("coral", "1"), point("nobody", "1")};
  scene.catalogue.classes[2].deposits = {{"sand", 1.0, 20.0}};
  scene.surroundings.water_level_m = 2.0;
  add_object(scene, 0, {{-100, -100}, {0, -100}, {0, 0}, {-100, 0}});
  add_object(scene, 1, {{-100, 100}, {100, 100}});
  add_object(scene, 2, {{100, 0}});
  return scene;
}

HeightField slope() {
  HeightField ground(GridFrame::centred(40, 30, 10.0));
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x) ground(x, y) = static_cast<float>(0.1 * ground.frame().x(x));
  return ground;
}

ScalarField of(const std::string& expression, const Scene& scene, const HeightField& ground) {
  return field_of(scene, {ground}, {expression, ""}, {});
}

TEST(SceneField, EveryWordHasItsMeaning) {
  const HeightField ground = slope();
  const Scene scene = small_scene(ground);
  const GridFrame& frame = ground.frame();
  const double diagonal = std::hypot(frame.width_m(), frame.height_m());
  const auto expect = [&](const std::string& expression, auto value, double tolerance) {
    const ScalarField field = of(expression, scene, ground);
    for (int y = 1; y + 1 < frame.height; ++y)
      for (int x = 1; x + 1 < frame.width; ++x)
        ASSERT_NEAR(field(x, y), value(frame.x(x), frame.y(y)), tolerance) << expression;
  };
  expect(
      "height", [](double x, double) { return 0.1 * x - 2; }, 1e-4);
  expect(
      "depth", [](double x, double) { return 2 - 0.1 * x; }, 1e-4);
  expect(
      "ground", [](double x, double) { return 0.1 * x; }, 1e-4);
  expect(
      "water_level", [](double, double) { return 2.0; }, 0);
  expect(
      "slope_deg", [](double, double) { return std::atan(0.1) * 180 / M_PI; }, 1e-3);
  expect(
      "gradient_x", [](double, double) { return 0.1; }, 1e-5);
  expect(
      "gradient_y", [](double, double) { return 0.0; }, 1e-5);
  expect(
      "current + current_x + current_y", [](double, double) { return 0.0; }, 1e-6);
  expect(
      "x - y", [](double x, double y) { return x - y; }, 1e-4);
  expect(
      "age + iteration", [](double, double) { return 0.0; }, 0);
  expect(
      "distance(coral)", [](double x, double y) { return std::hypot(x - 100, y); }, 1e-4);
  expect(
      "distance(island)",
      [](double x, double y) {
        return std::hypot(std::max({0.0, -100 - x, x}), std::max({0.0, -100 - y, y}));
      },
      1e-4);
  expect(
      "inside(island)", [](double x, double y) { return x > -100 && x < 0 && y > -100 && y < 0 ? 1.0 : 0.0; }, 0);
  expect(
      "border(island) - distance(island)",
      [](double x, double y) {
        const double deep = std::min({x + 100, -x, y + 100, -y});
        return std::max(0.0, deep);
      },
      1e-4);
  expect(
      "normal_x(coral) * distance(coral)", [](double x, double) { return x - 100; }, 1e-3);
  expect(
      "abs(normal_y(line)) * distance(line)",
      [](double x, double y) { return std::abs(x) < 100 ? std::abs(y - 100) : std::abs(y - 100); }, 1e-3);
  expect(
      "curvature(line)", [](double, double) { return 0.0; }, 0);
  expect(
      "distance(nobody)", [&](double, double) { return diagonal; }, 1e-3);
  expect(
      "border(nobody)", [&](double, double) { return diagonal; }, 1e-3);
  expect(
      "inside(nobody) + normal_x(nobody) + normal_y(nobody) + curvature(nobody)", [](double, double) { return 0.0; },
      0);
  expect(
      "abs(noise(80)) < 1.5", [](double, double) { return 1.0; }, 0);
}

TEST(SceneField, IsFiniteForEveryWordAndNaNWhereAnExpressionHasNoValue) {
  const HeightField ground = slope();
  const Scene scene = small_scene(ground);
  std::vector<std::string> words(kPlaceWords.begin(), kPlaceWords.end());
  words.emplace_back("sand");
  for (const std::string_view word : kClassWords)
    for (const char* of_class : {"island", "line", "coral", "nobody"})
      words.push_back(std::string(word) + "(" + of_class + ")");
  words.emplace_back("noise(0)");
  for (const std::string& word : words) {
    const ScalarField field = of(word, scene, ground);
    for (const float v : field.cells()) ASSERT_TRUE(std::isfinite(v)) << word;
  }
  const ScalarField logarithm = of("log(x)", scene, ground);
  EXPECT_TRUE(std::isnan(logarithm(0, 0)));
  EXPECT_TRUE(std::isfinite(logarithm(39, 0)));
}

TEST(SceneField, TellsScreenedDistancesNearTheExactOnes) {
  const HeightField ground = slope();
  const Scene scene = small_scene(ground);
  const ScalarField exact = of("distance(line)", scene, ground);
  const ScalarField screened = of("screened(line)", scene, ground);
  for (size_t i = 0; i < exact.size(); ++i)
    EXPECT_NEAR(screened.cells()[i], exact.cells()[i], 1.5 * ground.cell_m() + 0.3 * exact.cells()[i]) << i;
}

TEST(SceneField, IsTheFitnessOfAClass) {
  const HeightField ground = slope();
  Scene scene = small_scene(ground);
  scene.catalogue.classes[3].fitness = "2 * x";
  EXPECT_EQ(field_of(scene, {ground}, {"", "nobody"}, {}), of("2 * x", scene, ground));
}

TEST(SceneField, RefusesWhatItCannotAnswer) {
  const HeightField ground = slope();
  const Scene scene = small_scene(ground);
  const auto refused = [&](const FieldParams& params, const char* message) {
    EXPECT_THAT([&] { field_of(scene, {ground}, params, {}); },
                testing::ThrowsMessage<InvalidArgument>(testing::HasSubstr(message)));
  };
  refused({}, "of: give either an expression or a class");
  refused({"x", "coral"}, "of: give either");
  refused({"sand + snad", ""}, "of: column 8: unknown name 'snad', did you mean 'sand'?");
  refused({"", "corals"}, "fitness_of: unknown class 'corals', did you mean 'coral'?");
  refused({"x", "", 1}, "window");
}

}  // namespace
}  // namespace seamount::ecosystem
