#include "seamount/ops/render/contact_sheet.h"

#include <gtest/gtest.h>

#include "seamount/base/error.h"

namespace seamount::render {
namespace {

const Colour kRed{200, 30, 40};

/// Pixels of exactly this colour.
int count(const Image& image, Colour colour) {
  int found = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) found += image.colour(x, y) == colour;
  return found;
}

TEST(ContactSheet, ShowsEveryPictureWholeAtItsSize) {
  for (const int n : {1, 2, 3, 5, 7}) {
    for (const int columns : {1, 2, 3, 8}) {
      const Image sheet =
          contact_sheet(std::vector<SheetCell>(static_cast<size_t>(n), {Image(40, 30, kRed), ""}), columns);
      EXPECT_EQ(count(sheet, kRed), n * 40 * 30);
      const int used = std::min(n, columns);
      EXPECT_EQ(sheet.width, 12 + used * 52);
    }
  }
}

TEST(ContactSheet, MakesLargePicturesSmallerByTheirMean) {
  Image stripes(4000, 300);
  for (int y = 0; y < stripes.height; ++y)
    for (int x = 0; x < stripes.width; ++x)
      for (int c = 0; c < 3; ++c) stripes.pixel(x, y)[c] = x % 2 == 0 ? 100 : 60;
  const Image sheet = contact_sheet({{stripes, "a"}, {stripes, "b"}, {stripes, "c"}}, 3);
  EXPECT_LE(sheet.width, 2400);
  const Colour mean = sheet.colour(sheet.width / 2, 30);
  EXPECT_NEAR(mean.r, 80, 6);
}

TEST(ContactSheet, WritesTheCaptionUnderIt) {
  const Image without = contact_sheet({{Image(200, 50, kRed), ""}}, 1),
              with = contact_sheet({{Image(200, 50, kRed), "age=0.3"}}, 1);
  EXPECT_EQ(count(without, {255, 255, 255}), without.width * without.height - 200 * 50);
  EXPECT_LT(count(with, {255, 255, 255}), count(without, {255, 255, 255}) - 50);
  const Image crowded = contact_sheet({{Image(40, 30, kRed), std::string(300, 'm')}}, 1);
  for (int y = 0; y < crowded.height; ++y) EXPECT_EQ(crowded.colour(2, y), (Colour{255, 255, 255}));
}

TEST(ContactSheet, RefusesNothing) {
  EXPECT_THROW(contact_sheet({}, 2), IncompatibleInputs);
  EXPECT_THROW(contact_sheet({{Image(2, 2), ""}}, 0), InvalidArgument);
}

}  // namespace
}  // namespace seamount::render
