#include "seamount/ops/classify/paint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/scalar/segment.h"

namespace seamount::classify {
namespace {

using ::testing::HasSubstr;

const GridFrame kFrame = GridFrame::centred(90, 70, 40.0);

Painted painted(std::vector<PaintStroke> strokes, const LabelMap* labels = nullptr,
                const ScalarField* subsidence = nullptr) {
  return paint(kFrame, labels, subsidence, {Region::abyss, std::move(strokes)}, {});
}

TEST(PaintRegions, AStraightStrokeIsACapsuleWithACrispEdge) {
  const Vec2 a{-700, -200}, b{800, 300};
  const Painted out = painted({RegionTool{Region::reef, {a, b}, 430}});
  for (int y = 0; y < kFrame.height; ++y) {
    for (int x = 0; x < kFrame.width; ++x) {
      const double d = std::sqrt(geom::squared_distance_to_segment({kFrame.x(x), kFrame.y(y)}, a, b));
      if (std::abs(d - 430) < 6) continue;  // ends are round to 1.5 % of the radius
      ASSERT_EQ(out.labels(x, y), d < 430 ? Region::reef : Region::abyss) << x << ", " << y;
      ASSERT_EQ(out.subsidence(x, y), 0.0F);
    }
  }
}

TEST(PaintRegions, LaterLiesOverEarlierAndEraseBringsBack) {
  const LabelMap before(kFrame, Region::lagoon);
  const ScalarField sunk(kFrame, 0.25F);
  const Polygon triangle{{{-907, -703}, {911, -711}, {7, 903}}, {}};
  const std::vector<PaintStroke> strokes = {AreaTool{Region::mountain, {triangle}},
                                            RegionTool{Region::beach, {{-1000, 0}, {1000, 0}}, 200},
                                            SinkTool{{{{0, -300}}, {}, 500, 0.5}, 0.9}};
  const Painted out = painted(strokes, &before, &sunk);
  EXPECT_EQ(out.labels(45, 50), Region::mountain);
  EXPECT_EQ(out.labels(45, 35), Region::beach);
  EXPECT_EQ(out.labels(2, 2), Region::lagoon);
  const Grid<uint8_t> inside = geom::rasterise({triangle}, kFrame);
  const Painted area = painted({strokes[0]});
  for (size_t i = 0; i < inside.size(); ++i)
    ASSERT_EQ(area.labels.cells()[i] == Region::mountain, inside.cells()[i] != 0);
  EXPECT_NEAR(out.subsidence(45, 42), 0.9, 1e-3);
  EXPECT_EQ(out.subsidence(2, 2), 0.25F);
  std::vector<PaintStroke> taken_back = strokes;
  taken_back.emplace_back(EraseTool{{{-2500, 0}, {2500, 0}}, 1900});
  const Painted back = painted(taken_back, &before, &sunk);
  EXPECT_EQ(back.labels, before);
  EXPECT_EQ(back.subsidence, sunk);
}

TEST(PaintRegions, AStrokeFinerThanCellsHasNoGap) {
  const Painted out = painted({RegionTool{Region::beach, {{-1500, -900}, {1500, 1000}}, 1}});
  for (int x = 10; x < 80; ++x) {
    int found = 0;
    for (int y = 0; y < kFrame.height; ++y) found += out.labels(x, y) == Region::beach ? 1 : 0;
    EXPECT_GE(found, 1) << x;
  }
}

TEST(PaintRegions, CoarseCellsAgreeWithFineOnes) {
  const std::vector<PaintStroke> strokes = {RegionTool{Region::reef, {{-900, -300}, {0, 500}, {800, 0}}, 500},
                                            RegionTool{Region::mountain, {{-500, 0}, {300, 100}}, 300},
                                            SinkTool{{{{0, 0}, {700, 300}}, {0.3, 1}, 400, 0}, 1}};
  const Painted fine = paint(GridFrame::centred(1024, 1024, 4), nullptr, nullptr, {Region::abyss, strokes}, {});
  const Painted coarse = paint(GridFrame::centred(256, 256, 16), nullptr, nullptr, {Region::abyss, strokes}, {});
  int differ = 0;
  for (int y = 0; y < 256; ++y) {
    for (int x = 0; x < 256; ++x) {
      differ += coarse.labels(x, y) != fine.labels(4 * x + 2, 4 * y + 2) ? 1 : 0;
      ASSERT_NEAR(coarse.subsidence(x, y), fine.subsidence(4 * x + 2, 4 * y + 2), 0.02);
    }
  }
  EXPECT_LT(differ, 100);  // of 65536: cells that an edge crosses
}

TEST(PaintRegions, MistakesAreNamed) {
  const auto error_of = [](const PaintStroke& stroke) -> std::string {
    try {
      painted({stroke});
    } catch (const InvalidArgument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(error_of(RegionTool{}), "strokes[0].points: has no point");
  EXPECT_EQ(error_of(AreaTool{}), "strokes[0].polygons: has no polygon");
  EXPECT_THAT(error_of(SinkTool{{{{0, 0}}, {}, 10, 0}, 1.5}), HasSubstr("strokes[0].subsidence: 1.5 is outside"));
  EXPECT_THAT(error_of(EraseTool{{{0, 0}}, 0}), HasSubstr("strokes[0].radius_m: 0 is outside"));
}

}  // namespace
}  // namespace seamount::classify
