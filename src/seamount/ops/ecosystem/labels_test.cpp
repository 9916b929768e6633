#include "seamount/ops/ecosystem/labels.h"

#include <gtest/gtest.h>

#include "seamount/base/error.h"
#include "seamount/ops/ecosystem/test_scene.h"

namespace seamount::ecosystem {
namespace {

Polyline square(double half) { return {{-half, -half}, {half, -half}, {half, half}, {-half, half}}; }

TEST(SceneLabels, NestInTheOrderOfP0) {
  Scene scene = still_scene(GridFrame::centred(80, 80, 10.0));
  auto& classes = scene.catalogue.classes;
  classes = {region("abyss_thing", "1"), region("lagoon", "1"), region("island", "1"), curve("reef", "1"),
             curve("beach", "1"),        point("rock", "1"),    region("nothing", "1")};
  classes[1].label.region = LabelChoice::lagoon;
  classes[2].label.region = LabelChoice::mountain;
  classes[3].label = {LabelChoice::reef, 40.0};
  classes[4].label = {LabelChoice::beach, 60.0};
  classes[5].label = {LabelChoice::mountain, 50.0};
  // Given in an order that is not that of the regions.
  add_object(scene, 2, square(100));
  add_object(scene, 1, square(300));
  add_object(scene, 4, {{100, -100}, {100, 100}});
  add_object(scene, 3, {{-300, 300}, {300, 300}, {300, 0}, {100, 0}});
  add_object(scene, 5, {{-350, -350}});
  add_object(scene, 6, square(390));
  const LabelMap made = labels(scene, {}, {});
  const auto at = [&](double x, double y) {
    return made(static_cast<int>(made.frame().column(x)), static_cast<int>(made.frame().row(y)));
  };
  EXPECT_EQ(at(0, 0), Region::mountain);
  EXPECT_EQ(at(95, 50), Region::mountain) << "over the beach";
  EXPECT_EQ(at(115, 50), Region::beach) << "half its breadth beyond its line";
  EXPECT_EQ(at(115, 5), Region::beach) << "over the reef";
  EXPECT_EQ(at(200, 5), Region::reef) << "over the lagoon";
  EXPECT_EQ(at(0, 310), Region::reef) << "beyond it";
  EXPECT_EQ(at(0, -200), Region::lagoon);
  EXPECT_EQ(at(-345, -345), Region::mountain) << "a point as broad as it says";
  EXPECT_EQ(at(-320, 0), Region::abyss);
  EXPECT_THROW(labels(scene, {1}, {}), InvalidArgument);
}

}  // namespace
}  // namespace seamount::ecosystem
