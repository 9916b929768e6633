#include "seamount/ops/render/map_objects.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "seamount/base/error.h"
#include "seamount/base/rng.h"
#include "seamount/ops/render/canvas.h"
#include "seamount/ops/render/map.h"
#include "seamount/ops/render/map_object_legend.h"

namespace seamount::render {
namespace {

constexpr Colour kRed{220, 40, 30};

ObjectClass make_class(std::string name, SkeletonKind kind, double size_m = 20.0, Colour colour = kRed) {
  ObjectClass made;
  made.name = std::move(name);
  made.skeleton = kind;
  made.shape.size_m = size_m;
  made.colour = colour;
  return made;
}

/// 1000 x 800 m of sea floor around (0, 0).
HeightField floor_of_sea() { return HeightField(GridFrame::centred(100, 80, 10.0), -30.0F); }

seamount::Scene scene_of(std::vector<ObjectClass> classes) {
  seamount::Scene scene;
  scene.catalogue.classes = std::move(classes);
  scene.frame = floor_of_sea().frame();
  return scene;
}

SceneObject& add(seamount::Scene& scene, int of_class, Polyline points, double size = 1.0) {
  SceneObject object;
  object.id = scene.next_id++;
  object.of_class = of_class;
  object.skeleton = {scene.catalogue.classes[static_cast<size_t>(of_class)].skeleton, std::move(points)};
  object.size = size;
  scene.objects.push_back(object);
  return scene.objects.back();
}

MapParams bare(int width_px) {
  MapParams params;
  params.width_px = width_px;
  params.legend = params.scale_bar = params.north_arrow = params.object_legend = false;
  return params;
}

Image drawn(const seamount::Scene* scene, const MapParams& params, const RunContext& run = {}) {
  return map(floor_of_sea(), nullptr, {.objects = scene}, params, run);
}

/// Pixels that differ, as their least box, and how many.
struct Difference {
  int x0 = 1 << 20, y0 = 1 << 20, x1 = -1, y1 = -1, count = 0;
};

Difference difference(const Image& a, const Image& b) {
  Difference found;
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.height, b.height);
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      if (a.colour(x, y) == b.colour(x, y)) continue;
      found = {std::min(found.x0, x), std::min(found.y0, y), std::max(found.x1, x), std::max(found.y1, y),
               found.count + 1};
    }
  }
  return found;
}

TEST(MapObjects, ASymbolLiesWhereItsObjectIs) {
  const Image none = drawn(nullptr, bare(500));  // 2 m a pixel
  for (const Symbol symbol : {Symbol::circle, Symbol::triangle, Symbol::square, Symbol::diamond, Symbol::star}) {
    std::vector<ObjectClass> classes;
    for (int i = 0; i <= static_cast<int>(symbol); ++i) classes.push_back(make_class("c", SkeletonKind::point, 16.0));
    for (const Vec2 place : {Vec2{0, 0}, {-311, 205}, {404.5, -333}}) {
      seamount::Scene scene = scene_of(classes);
      add(scene, static_cast<int>(symbol), {place});
      const Image image = drawn(&scene, bare(500));
      const double x = (place.x + 500.0) / 2.0, y = (400.0 - place.y) / 2.0;
      const Difference changed = difference(none, image);
      EXPECT_EQ(image.colour(static_cast<int>(x), static_cast<int>(y)), kRed);
      EXPECT_GT(changed.x0, x - 10.0);
      EXPECT_LT(changed.x1, x + 10.0);
      EXPECT_GT(changed.y0, y - 10.0);
      EXPECT_LT(changed.y1, y + 10.0);
      EXPECT_GT(changed.count, 50);  // a disc of 4 pixels' radius covers 50
      EXPECT_LT(changed.count, 140);
    }
  }
}

TEST(MapObjects, AllShapesCoverTheSameAreaAndDiffer) {
  std::vector<Image> images;
  for (const Symbol symbol : {Symbol::circle, Symbol::triangle, Symbol::square, Symbol::diamond, Symbol::star}) {
    Image image(60, 60, Colour{0, 0, 0});
    draw_symbol(image, {30.3, 29.6}, 9.0, symbol, Colour{200, 200, 200}, 0.0);
    double area = 0.0;
    for (size_t i = 0; i < image.rgb.size(); i += 3) area += image.rgb[i] / 200.0;
    EXPECT_NEAR(area, 254.5, 5.0);
    EXPECT_EQ(std::count(images.begin(), images.end(), image), 0);
    images.push_back(image);
  }
  EXPECT_EQ(symbol_of(4), Symbol::star);
  EXPECT_EQ(symbol_of(5), Symbol::circle);
  EXPECT_EQ(symbol_of(1000), Symbol::circle);
}

TEST(MapObjects, SymbolsAreAsLargeAsTheirObjectsWithinBounds) {
  const ObjectClass of_class = make_class("coral", SkeletonKind::point, 10.0);
  SceneObject object;
  EXPECT_EQ(symbol_radius(of_class, object, 1.0, 1.0), 5.0);
  object.size = 1.5;
  EXPECT_EQ(symbol_radius(of_class, object, 1.0, 1.0), 7.5);
  EXPECT_EQ(symbol_radius(of_class, object, 0.01, 1.0), 9.0);
  EXPECT_EQ(symbol_radius(of_class, object, 1000.0, 1.0), 2.0);
}

TEST(MapObjects, RegionsAreTintedAndCurvesAreLines) {
  const Image none = drawn(nullptr, bare(500));
  seamount::Scene region = scene_of({make_class("lagoon", SkeletonKind::region)});
  add(region, 0, {{-200, -100}, {200, -100}, {200, 100}, {-200, 100}});
  const Image tinted = drawn(&region, bare(500));
  EXPECT_NE(tinted.colour(250, 200), none.colour(250, 200));
  EXPECT_NE(tinted.colour(250, 200), kRed);
  EXPECT_EQ(tinted.colour(100, 200), none.colour(100, 200));
  EXPECT_GT(tinted.colour(250, 150).r, tinted.colour(250, 200).r + 40);  // its outline
  seamount::Scene curve = scene_of({make_class("reef", SkeletonKind::curve)});
  add(curve, 0, {{-300, 1}, {300, 1}});
  const Image lined = drawn(&curve, bare(500));
  EXPECT_EQ(lined.colour(250, 199), kRed);
  EXPECT_EQ(lined.colour(250, 190), none.colour(250, 190));
  EXPECT_EQ(lined.colour(40, 199), none.colour(40, 199));
}

TEST(MapObjects, RegionsLieUnderCurvesAndThoseUnderPoints) {
  const Colour blue{20, 30, 200}, white{250, 250, 250};
  seamount::Scene scene =
      scene_of({make_class("rock", SkeletonKind::point, 30.0, white),
                make_class("reef", SkeletonKind::curve, 1.0, blue), make_class("lagoon", SkeletonKind::region)});
  add(scene, 0, {{1, 1}});
  add(scene, 1, {{-300, 1}, {300, 1}});
  add(scene, 2, {{-200, -200}, {200, -200}, {200, 200}, {-200, 200}});
  const Image image = drawn(&scene, bare(500));
  EXPECT_EQ(image.colour(250, 199), white);
  EXPECT_EQ(image.colour(200, 199), blue);
  std::vector<std::string> order;
  for (const ShownClass& one : shown_classes(scene, floor_of_sea().frame())) order.push_back(one.of_class->name);
  EXPECT_EQ(order, (std::vector<std::string>{"lagoon", "reef", "rock"}));
}

TEST(MapObjects, WithoutObjectsOnTheMapThePictureIsTheSame) {
  const MapParams whole{.width_px = 400, .title = "Sea"};
  seamount::Scene scene = scene_of({make_class("coral", SkeletonKind::point), make_class("reef", SkeletonKind::curve),
                                    make_class("lagoon", SkeletonKind::region)});
  EXPECT_EQ(drawn(&scene, whole), drawn(nullptr, whole));
  add(scene, 0, {{500.5, 0}});
  add(scene, 0, {{0, -401}});
  add(scene, 1, {{-600, 300}, {-400, 900}, {1e9, 1e9}});
  add(scene, 2, {{501, -300}, {900, -300}, {900, 300}});
  add(scene, 2,
      {{-600, 420}, {-600, -600}, {600, -600}, {600, 420}, {590, 420}, {590, -590}, {-590, -590}, {-590, 420}});
  EXPECT_EQ(drawn(&scene, whole), drawn(nullptr, whole));
  EXPECT_NE(add(scene, 0, {{499, 0}}).id, 0);
  EXPECT_NE(drawn(&scene, whole), drawn(nullptr, whole));
}

TEST(MapObjects, WhatReachesOverTheEdgeIsCutOff) {
  seamount::Scene scene = scene_of({make_class("coral", SkeletonKind::point, 500.0),
                                    make_class("reef", SkeletonKind::curve), make_class("sea", SkeletonKind::region)});
  MapParams params{.width_px = 400, .title = "Sea", .object_legend = false};
  add(scene, 0, {{500, 0}});
  add(scene, 0, {{0, 400}});
  add(scene, 1, {{-1e12, -100}, {1e12, 100}});
  add(scene, 2, {{-1e7, -1e7}, {1e7, -1e7}, {1e7, 1e7}, {-1e7, 1e7}});
  const Image none = drawn(nullptr, params), image = drawn(&scene, params);
  const Difference changed = difference(none, image);
  EXPECT_GE(changed.x0, 10);        // the margin of 1.5 units
  EXPECT_LE(changed.x1, 400 - 46);  // that and the legend
  EXPECT_GE(changed.y0, 27);        // the title
  EXPECT_LE(changed.y1, none.height - 23);
  EXPECT_NE(image.colour(12, none.height / 2), none.colour(12, none.height / 2));
}

TEST(MapObjects, WhatGrewInAWindowIsShownWhereItLies) {
  seamount::Scene scene = scene_of({make_class("polyp", SkeletonKind::point, 0.1)});
  scene.windows.push_back({.frame = GridFrame::centred(40, 40, 0.5)});
  add(scene, 0, {{3, 3}}).window = 1;
  const Difference changed = difference(drawn(nullptr, bare(500)), drawn(&scene, bare(500)));
  EXPECT_GT(changed.count, 0);
  EXPECT_NEAR(changed.x0, 248, 1);
  EXPECT_NEAR(changed.x1, 254, 1);
  // And on a map of the window itself.
  const HeightField close(scene.windows[0].frame, -30.0F);
  const Difference there =
      difference(map(close, nullptr, {}, bare(500), {}), map(close, nullptr, {.objects = &scene}, bare(500), {}));
  EXPECT_NEAR(0.5 * (there.x0 + there.x1), (3.0 + 10.0) * 25.0, 1.0);
  EXPECT_NEAR(0.5 * (there.y0 + there.y1), (10.0 - 3.0) * 25.0, 1.0);
}

TEST(MapObjects, WhereSymbolsWouldCoverEachOtherTheyShrinkToDots) {
  for (const uint64_t seed : {1U, 2U, 3U}) {
    seamount::Scene scene =
        scene_of({make_class("rock", SkeletonKind::point, 30.0), make_class("pebble", SkeletonKind::point, 2.0),
                  make_class("tree", SkeletonKind::point, 30.0)});
    Rng rng(Seed{seed});
    const auto anywhere = [&] { return Vec2{rng.uniform(-500.0, 500.0), rng.uniform(-400.0, 400.0)}; };
    for (int i = 0; i < 4; ++i) add(scene, 0, {{-300.0 + 200.0 * i, 100.0}});
    for (int i = 0; i < 30000; ++i) add(scene, 1, {anywhere()});
    for (int i = 0; i < 100; ++i) add(scene, 2, {{-500.0 + 10.0 * i, -100.0}});
    std::vector<ShownClass> shown = shown_classes(scene, floor_of_sea().frame());
    fit_symbols(shown, 2.0, 1.0, {});
    ASSERT_EQ(shown.size(), 3U);
    EXPECT_EQ(shown[0].shrink, 1.0);  // among pebbles, but far from its like
    EXPECT_EQ(shown[0].dot_px, 0.0);
    EXPECT_GE(shown[1].dot_px, 1.0);
    EXPECT_LE(shown[1].dot_px, 2.0);
    EXPECT_NEAR(shown[2].shrink, 1.0 / 3.0, 1e-9);  // 10 m apart and 30 m wide
  }
}

TEST(MapObjects, PointsAtOnePlaceAndASingleOne) {
  seamount::Scene scene = scene_of({make_class("coral", SkeletonKind::point)});
  add(scene, 0, {{5, 5}});
  std::vector<ShownClass> one = shown_classes(scene, scene.frame);
  fit_symbols(one, 2.0, 1.0, {});
  EXPECT_EQ(one[0].shrink, 1.0);
  for (int i = 0; i < 500; ++i) add(scene, 0, {{5, 5}});
  std::vector<ShownClass> many = shown_classes(scene, scene.frame);
  fit_symbols(many, 2.0, 1.0, {});
  EXPECT_EQ(many[0].objects.size(), 501U);
  EXPECT_GT(many[0].dot_px, 0.0);
  EXPECT_EQ(difference(drawn(nullptr, bare(300)), drawn(&scene, bare(300))).x0, 150);
}

TEST(MapObjects, TheLegendCountsWhatIsOnTheMap) {
  seamount::Scene scene = scene_of({make_class("coral", SkeletonKind::point), make_class("empty", SkeletonKind::point),
                                    make_class("table_coral", SkeletonKind::point)});
  for (int i = 0; i < 7; ++i) add(scene, 0, {{-450.0 + 100.0 * i, 0.0}});
  for (int i = 0; i < 3; ++i) add(scene, 2, {{450.0 + 100.0 * i, 0.0}});
  const std::vector<ShownClass> shown = shown_classes(scene, scene.frame);
  ASSERT_EQ(shown.size(), 2U);
  EXPECT_EQ(shown[0].objects.size(), 7U);
  EXPECT_EQ(shown[1].objects.size(), 1U);
  EXPECT_EQ(shown[1].symbol, Symbol::square);  // the third class of points, whether the second has any or not
}

TEST(MapObjects, TheLegendStandsBelowAllElse) {
  seamount::Scene scene = scene_of({make_class("coral", SkeletonKind::point)});
  add(scene, 0, {{0, 0}});
  for (const int width : {16, 120, 900}) {
    MapParams params{.width_px = width, .title = "Sea"};
    const Image with = drawn(&scene, params);
    params.object_legend = false;
    const Image without = drawn(&scene, params);
    EXPECT_EQ(without.height, drawn(nullptr, params).height);
    ASSERT_GT(with.height, without.height);
    // What stands above it is the same to the last pixel.
    const auto rows = static_cast<std::ptrdiff_t>(3 * width * (without.height - width / 50 - 4));
    EXPECT_TRUE(
        std::equal(without.rgb.begin(), without.rgb.begin() + std::max<std::ptrdiff_t>(0, rows), with.rgb.begin()));
  }
}

TEST(MapObjects, AThousandClassesLeaveALegendThatFits) {
  std::vector<ObjectClass> classes;
  classes.reserve(1000);
  for (int i = 0; i < 1000; ++i)
    classes.push_back(make_class("class_" + std::string(static_cast<size_t>(i % 90), 'x') + std::to_string(i),
                                 static_cast<SkeletonKind>(i % 3)));
  seamount::Scene scene = scene_of(classes);
  for (int i = 0; i < 1000; ++i) {
    const Vec2 p{-450.0 + 0.9 * i, -350.0 + 0.7 * i};
    add(scene, i, {p, p + Vec2{20, 0}, p + Vec2{0, 20}});
  }
  const std::vector<ShownClass> shown = shown_classes(scene, scene.frame);
  const Font font;
  for (const double width : {1.0, 80.0, 300.0, 2000.0}) {
    const ObjectLegend legend = lay_out_object_legend(font, shown, width, 12.0);
    EXPECT_LE(legend.rows, 24);
    EXPECT_LE(legend.width, width);
    EXPECT_LT(legend.entries, 1000U);
    EXPECT_EQ(legend.entries + 1, static_cast<size_t>(legend.rows) * static_cast<size_t>(legend.columns));
    EXPECT_GE(legend.name, 0.0);
  }
  EXPECT_GT(drawn(&scene, {.width_px = 300}).height, 300);
}

TEST(MapObjects, AnotherCoordinateSystemIsRefused) {
  seamount::Scene scene = scene_of({make_class("coral", SkeletonKind::point)});
  scene.frame.crs = "EPSG:32606";
  GridFrame frame = floor_of_sea().frame();
  EXPECT_TRUE(shown_classes(scene, frame).empty());
  frame.crs = "EPSG:32605";
  EXPECT_THROW(shown_classes(scene, frame), IncompatibleInputs);
}

TEST(MapObjects, TheSameOnAnyNumberOfThreads) {
  seamount::Scene scene = scene_of({make_class("coral", SkeletonKind::point), make_class("tree", SkeletonKind::point)});
  Rng rng(Seed{4});
  for (int i = 0; i < 3000; ++i)
    add(scene, i % 2, {{rng.uniform(-500.0, 500.0), rng.uniform(-400.0, 400.0)}}, 0.5 + rng.uniform());
  EXPECT_EQ(drawn(&scene, {.width_px = 300}, {.threads = 1}), drawn(&scene, {.width_px = 300}, {.threads = 2}));
}

}  // namespace
}  // namespace seamount::render
