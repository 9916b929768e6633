#include "seamount/ops/render/text.h"

#include <gtest/gtest.h>

#include <cmath>

namespace seamount::render {
namespace {

TEST(Text, WidthGrowsWithSizeAndText) {
  const Font font;
  EXPECT_GT(font.width("Lagoon", 20.0), font.width("Lago", 20.0));
  EXPECT_NEAR(font.width("Lagoon", 40.0), 2.0 * font.width("Lagoon", 20.0), 1.0);
  EXPECT_EQ(font.width("", 20.0), 0.0);
}

TEST(Text, InkLiesAroundTheAnchor) {
  const Font font;
  Image image(200, 40, Colour{255, 255, 255});
  font.draw(image, 100.0, 30.0, 20.0, "HHH", {}, Anchor::middle);
  double sum = 0.0, weighted = 0.0;
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 200; ++x) {
      const double ink = 255 - image.colour(x, y).r;
      sum += ink;
      weighted += ink * (x + 0.5);
      EXPECT_TRUE(y <= 31 || ink == 0.0);
    }
  }
  ASSERT_GT(sum, 0.0);
  EXPECT_NEAR(weighted / sum, 100.0, 0.6);
}

TEST(Text, AlongALineItIsTheSameTurned) {
  const Font font;
  Image level(80, 80, Colour{255, 255, 255}), upright = level;
  font.draw_along(level, {40, 40}, {1, 0}, 16.0, "1250", {});
  font.draw_along(upright, {40, 40}, {0, -1}, 16.0, "1250", {});
  double ink = 0.0, off = 0.0;
  for (int y = 0; y < 80; ++y) {
    for (int x = 0; x < 80; ++x) {
      ink += 255 - level.colour(x, y).r;
      off += std::abs(level.colour(x, y).r - upright.colour(y, 79 - x).r);
    }
  }
  EXPECT_GT(ink, 10000.0);
  EXPECT_LT(off, 0.3 * ink) << "but for fractions of a pixel";
}

TEST(Text, BrokenUtf8AndTextBeyondThePictureAreHarmless) {
  const Font font;
  Image image(20, 20);
  font.draw(image, -500.0, 5000.0, 18.0, "far \xff\xc3 \xe2\x82", {});
  font.draw(image, 15.0, 10.0, 18.0, "cut \xf0\x9f\x98\x80", {255, 255, 255});
  EXPECT_GT(font.width("\xc3", 10.0), 0.0);
}

}  // namespace
}  // namespace seamount::render
