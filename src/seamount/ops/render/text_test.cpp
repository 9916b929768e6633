#include "seamount/ops/render/text.h"

#include <gtest/gtest.h>

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

TEST(Text, BrokenUtf8AndTextBeyondThePictureAreHarmless) {
  const Font font;
  Image image(20, 20);
  font.draw(image, -500.0, 5000.0, 18.0, "far \xff\xc3 \xe2\x82", {});
  font.draw(image, 15.0, 10.0, 18.0, "cut \xf0\x9f\x98\x80", {255, 255, 255});
  EXPECT_GT(font.width("\xc3", 10.0), 0.0);
}

}  // namespace
}  // namespace seamount::render
