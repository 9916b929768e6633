// Currents as values of recipes: through the cache, with unknown cells, on other cells.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>
#include <string>

#include "seamount/io/current_file.h"
#include "seamount/recipe/executor.h"
#include "seamount/recipe/kinds.h"
#include "seamount/recipe/value_bytes.h"

namespace seamount::recipe {
namespace {

VectorField swirl(const GridFrame& frame) {
  VectorField current{ScalarField(frame), ScalarField(frame)};
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      current.x(x, y) = static_cast<float>(std::sin(0.1 * y));
      current.y(x, y) = static_cast<float>(std::cos(0.07 * x));
    }
  }
  return current;
}

TEST(CurrentKind, ComesBackFromItsBytesAndNotFromDamagedOnes) {
  const VectorField current = swirl(GridFrame::centred(31, 17, 20.0));
  std::ostringstream out;
  write_values(out, {{"current", Value::of<kinds::Current>(current)}});
  std::istringstream in(out.str());
  const std::optional<Values> back = read_values(in, standard_registry());
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->at("current").get<kinds::Current>(), current);
  std::istringstream cut(out.str().substr(0, out.str().size() / 2));
  EXPECT_FALSE(read_values(cut, standard_registry()).has_value());
}

TEST(CurrentKind, NothingFlowsWhereNothingIsKnown) {
  VectorField current = swirl(GridFrame::centred(9, 9, 20.0));
  current.x(2, 3) = std::numeric_limits<float>::quiet_NaN();
  std::string said;
  RunContext run;
  run.note = [&](const std::string& line) { said = line; };
  const Value filled = Value::of<kinds::Current>(current).without_voids("current", run);
  EXPECT_EQ(filled.get<kinds::Current>().x(2, 3), 0.0F);
  EXPECT_EQ(filled.get<kinds::Current>().y(2, 3), 0.0F);
  EXPECT_EQ(filled.get<kinds::Current>().y(3, 3), current.y(3, 3));
  EXPECT_EQ(said, "current: 1 of 81 cells have no value and are taken to be still");
}

TEST(CurrentKind, IsBroughtToTheCellsOfAFrame) {
  const VectorField current{ScalarField(GridFrame::centred(40, 40, 10.0), 0.25F),
                            ScalarField(GridFrame::centred(40, 40, 10.0), -0.5F)};
  const GridFrame other = GridFrame::centred(11, 7, 25.0);
  const Value brought = Value::of<kinds::Current>(current).brought({other, true, {}});
  ASSERT_EQ(brought.get<kinds::Current>().frame(), other);
  EXPECT_EQ(brought.get<kinds::Current>().x(5, 3), 0.25F);
  EXPECT_EQ(brought.get<kinds::Current>().y(0, 6), -0.5F);
}

}  // namespace
}  // namespace seamount::recipe
