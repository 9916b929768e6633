#include "seamount/ops/render/canvas.h"

#include <gtest/gtest.h>

namespace seamount::render {
namespace {

constexpr Colour kWhite{255, 255, 255};

int covered(const Image& image) {
  int sum = 0;
  for (const uint8_t v : image.rgb) sum += 255 - v;
  return sum / 3;
}

TEST(Canvas, ABoxCoversItsArea) {
  Image image(20, 10, kWhite);
  fill_box(image, 2.5, 1.25, 10.0, 6.0, {});
  EXPECT_NEAR(covered(image) / 255.0, 7.5 * 4.75, 0.3);
  fill_box(image, -50.0, -50.0, -1.0, 99.0, {});  // outside: nothing
  EXPECT_EQ(image.colour(0, 0), kWhite);
}

TEST(Canvas, APolygonCoversItsArea) {
  Image image(40, 40, kWhite);
  fill_polygon(image, {{5, 5}, {35, 5}, {5, 35}}, {});
  EXPECT_NEAR(covered(image) / 255.0, 450.0, 10.0);
}

TEST(Canvas, CrossingLinesOfOneLayerAreNotDrawnTwice) {
  LineLayer layer(30, 30);
  layer.add({{0, 15}, {30, 15}}, 3.0);
  layer.add({{15, 0}, {15, 30}}, 3.0);
  Image image(30, 30, kWhite);
  layer.draw(image, 0, 0, {}, 0.5F);
  EXPECT_EQ(image.colour(15, 15), image.colour(5, 15));
  EXPECT_NEAR(image.colour(5, 14).r, 128, 1);
  EXPECT_EQ(image.colour(5, 5), kWhite);
}

}  // namespace
}  // namespace seamount::render
