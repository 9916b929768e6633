#include "seamount/geom/contour/lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "seamount/base/error.h"

namespace seamount::geom {
namespace {

Ring square(double half) { return {{-half, -half}, {half, -half}, {half, half}, {-half, half}}; }

ContourSet hill() {
  ContourSet set;
  set.frame = GridFrame::centred(100, 100, 10);
  set.contours = {{10.0, square(400), -1}, {20.5, square(200), 0}};
  return set;
}

TEST(ContourLines, ComeBackAsTheyWere) {
  EXPECT_EQ(contours_from_lines(to_lines(hill()), hill().frame, "contours"), hill());
  EXPECT_TRUE(to_lines(hill()).heights);
}

TEST(ContourLines, RunWithHigherGroundOnTheirLeft) {
  Drawing drawing = to_lines(hill());
  std::reverse(drawing.lines[0].points.begin(), drawing.lines[0].points.end());
  drawing.lines[1].value = 5.0;  // a basin
  const ContourSet set = contours_from_lines(drawing, hill().frame, "contours");
  EXPECT_GT(cross(set.contours[0].ring[1] - set.contours[0].ring[0], set.contours[0].ring[2] - set.contours[0].ring[1]),
            0);
  EXPECT_LT(cross(set.contours[1].ring[1] - set.contours[1].ring[0], set.contours[1].ring[2] - set.contours[1].ring[1]),
            0);
}

TEST(ContourLines, FarFromTheDomainHaveAFrameOfTheirOwn) {
  Drawing drawing = to_lines(hill());
  for (ValuedLine& line : drawing.lines)
    for (Vec2& p : line.points) p = p + Vec2{500000, 4000000};
  const GridFrame frame = contours_from_lines(drawing, hill().frame, "contours").frame;
  EXPECT_EQ(frame.width, 100);
  EXPECT_NEAR(frame.west_m, 499600, 1e-6);
  EXPECT_NEAR(frame.north_m, 4000400, 1e-6);
}

TEST(ContourLines, SayWhatIsWrongAndWhere) {
  const auto message = [](const Drawing& drawing) -> std::string {
    try {
      contours_from_lines(drawing, hill().frame, "contours");
    } catch (const InvalidArgument& error) {
      return error.what();
    }
    return "nothing";
  };
  Drawing open = to_lines(hill());
  open.lines[1].closed = false;
  EXPECT_THAT(message(open),
              ::testing::HasSubstr("the line of 20.5 m from (-200, -200) to (-200, 200) ends inside the sheet, at"));
  Drawing crossing = to_lines(hill());
  for (Vec2& p : crossing.lines[1].points) p.x += 300;
  EXPECT_THAT(message(crossing), ::testing::HasSubstr("line 0 (10 m) meets line 1 (20.5 m) at"));
  EXPECT_THAT(message({}), ::testing::HasSubstr("no lines"));
}

}  // namespace
}  // namespace seamount::geom
