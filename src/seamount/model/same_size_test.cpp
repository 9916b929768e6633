#include "seamount/model/same_size.h"

#include <gtest/gtest.h>

namespace seamount {
namespace {

TEST(SameSize, IsAboutColumnsAndRowsAlone) {
  const GridFrame frame{4, 3, 10, 100, 200, {}};
  EXPECT_TRUE(same_size(frame, GridFrame{4, 3}));
  EXPECT_FALSE(same_size(frame, GridFrame{3, 4}));
  EXPECT_NO_THROW(check_same_size("labels", GridFrame{4, 3}, frame));
}

TEST(SameSize, TheErrorNamesBothSizes) {
  const auto message = [](auto... how) {
    try {
      check_same_size(how...);
    } catch (const IncompatibleInputs& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message("labels", GridFrame{3, 4}, GridFrame{4, 3}),
            "labels: 3 x 4 cells do not match the terrain's 4 x 3");
  EXPECT_EQ(message("b", GridFrame{3, 4}, GridFrame{4, 3}, "first terrain", "; resample it"),
            "b: 3 x 4 cells do not match the first terrain's 4 x 3; resample it");
}

}  // namespace
}  // namespace seamount
