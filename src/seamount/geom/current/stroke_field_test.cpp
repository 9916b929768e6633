#include "seamount/geom/current/stroke_field.h"

#include <cmath>

#include <gtest/gtest.h>

#include "seamount/base/error.h"

namespace seamount::geom {
namespace {

TEST(StrokeCurrent, FlowsAlongTheStrokeAndFadesBesideIt) {
  const GridFrame frame = GridFrame::centred(81, 81, 10.0);
  VectorField current{ScalarField(frame, 0.1F), ScalarField(frame, 0.0F)};
  add_strokes({{{{-2000, 0}, {2000, 0}}, 60.0, 1.5}}, current, {});
  EXPECT_NEAR(current.x(40, 40), 1.6F, 0.01F);
  EXPECT_NEAR(current.x(40, 34), 0.1 + 1.5 * std::exp(-0.5), 0.01);  // one width beside it
  EXPECT_NEAR(current.x(40, 5), 0.1F, 0.001F);
  EXPECT_NEAR(current.y(40, 36), 0.0F, 1e-4F);
}

TEST(StrokeCurrent, NamesTheStrokeThatIsWrong) {
  const GridFrame frame = GridFrame::centred(8, 8, 10.0);
  VectorField current{ScalarField(frame, 0.0F), ScalarField(frame, 0.0F)};
  const Stroke good{{{0, 0}, {10, 0}}, 5.0, 1.0};
  try {
    add_strokes({good, {{{0, 0}}, 5.0, 1.0}}, current, {});
    FAIL();
  } catch (const InvalidArgument& e) {
    EXPECT_EQ(e.field(), "strokes[1]");
  }
  EXPECT_THROW(add_strokes({{{{0, 0}, {10, 0}}, 0.0, 1.0}}, current, {}), InvalidArgument);
  EXPECT_THROW(add_strokes({{{{0, 0}, {std::nan(""), 0}}, 5.0, 1.0}}, current, {}), InvalidArgument);
}

}  // namespace
}  // namespace seamount::geom
