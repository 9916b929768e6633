#include "seamount/ops/amplify/dictionary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "seamount/base/error.h"
#include "seamount/ops/amplify/test_dictionary.h"

namespace seamount::amplify {
namespace {

using ::testing::HasSubstr;

TEST(AtomTable, FindsWhatLookingAtEachAtomFinds) {
  for (const int atoms : {1, 15, 16, 17, 300}) {
    const Dictionary dictionary = random_dictionary(atoms, 1);
    const std::vector<Features> shapes = random_dictionary(37, 2).shapes;
    std::vector<AtomTable::Match> matches(shapes.size());
    AtomTable(dictionary.shapes).find(shapes, matches);
    for (size_t i = 0; i < shapes.size(); ++i) {
      int best = 0;
      float most = -2.0F;
      for (int a = 0; a < atoms; ++a) {
        float product = 0.0F;
        for (int f = 0; f < kFeatures; ++f) product += shapes[i][f] * dictionary.shapes[a][f];
        if (product > most) {
          most = product;
          best = a;
        }
      }
      EXPECT_EQ(matches[i].atom, best);
      EXPECT_EQ(matches[i].cosine, most);
    }
  }
}

TEST(AtomTable, TakesTheFirstOfEquals) {
  Dictionary dictionary = random_dictionary(40, 3);
  for (const int twin : {9, 21, 39}) dictionary.shapes[twin] = dictionary.shapes[5];
  std::vector<AtomTable::Match> matches(1);
  AtomTable(dictionary.shapes).find(std::span(dictionary.shapes).subspan(21, 1), matches);
  EXPECT_EQ(matches[0].atom, 5);
}

TEST(Shape, IsTheSameWhicheverWayTheGroundIsTurned) {
  Rng rng(Seed{4}.derive("ground"));
  for (int tries = 0; tries < 50; ++tries) {
    std::array<float, kShape * kShape> ground, turned;
    for (float& z : ground) z = static_cast<float>(500.0 + 40.0 * rng.normal());
    const Shape shape = describe_shape(ground.data(), kShape);
    for (Turn turn = 0; turn < 8; ++turn) {
      for (int y = 0; y < kShape; ++y) {
        for (int x = 0; x < kShape; ++x) {
          const auto [east, south] = on_ground(turn, x, y, kShape);
          turned[kShape * y + x] = ground[kShape * south + east];
        }
      }
      const Shape other = describe_shape(turned.data(), kShape);
      EXPECT_NEAR(other.relief_m, shape.relief_m, 1e-3);
      for (int f = 0; f < kFeatures; ++f) EXPECT_NEAR(other.features[f], shape.features[f], 1e-4) << int{turn};
    }
  }
}

TEST(Shape, KnowsNothingOfHeightAndScalesWithRelief) {
  std::array<float, kShape * kShape> ground, other;
  for (int i = 0; i < kShape * kShape; ++i) {
    ground[i] = static_cast<float>((i * 37) % 50);
    other[i] = 3.0F * ground[i] + 2000.0F;
  }
  const Shape one = describe_shape(ground.data(), kShape), three = describe_shape(other.data(), kShape);
  EXPECT_NEAR(three.relief_m, 3.0F * one.relief_m, 1e-2);
  for (int f = 0; f < kFeatures; ++f) EXPECT_NEAR(one.features[f], three.features[f], 1e-4);
  ground.fill(812.0F);
  EXPECT_EQ(describe_shape(ground.data(), kShape).relief_m, 0.0F);
}

TEST(Dictionary, ComesBackFromItsWeights) {
  const Dictionary dictionary = random_dictionary(20, 7);
  const Dictionary again = dictionary_of(weights_of(dictionary));
  EXPECT_EQ(again.shapes, dictionary.shapes);
  EXPECT_EQ(again.details, dictionary.details);
}

TEST(Dictionary, RefusesWhatIsNone) {
  const auto why = [](const std::function<void(Weights&)>& spoil) -> std::string {
    Weights weights = weights_of(random_dictionary(20, 7));
    spoil(weights);
    try {
      dictionary_of(weights);
    } catch (const Error& error) {
      return error.what();
    }
    return "taken";
  };
  EXPECT_EQ(why([](Weights&) {}), "taken");
  EXPECT_THAT(why([](Weights& w) { w.about.clear(); }), HasSubstr("does not say"));
  EXPECT_THAT(why([](Weights& w) { w.about["kind"] = "sketch"; }), HasSubstr("another kind: 'sketch'"));
  EXPECT_THAT(why([](Weights& w) { w.tensors.erase("details"); }), HasSubstr("'details' is missing"));
  EXPECT_THAT(why([](Weights& w) { w.tensors["more"] = {{1}, {0.0F}}; }), HasSubstr("no dictionary has"));
  EXPECT_THAT(why([](Weights& w) {
                w.tensors["shapes"] = {{20, 4}, std::vector<float>(80)};
              }),
              HasSubstr("'shapes' is 20 x 4, expected atoms x 16"));
  EXPECT_THAT(why([](Weights& w) { w.tensors["details"].shape = {20, 64}; }), HasSubstr("expected atoms x 8 x 8"));
  EXPECT_THAT(why([](Weights& w) { w.tensors["shapes"] = weights_of(random_dictionary(19, 1)).tensors["shapes"]; }),
              HasSubstr("19 shapes and 20 details"));
  EXPECT_THAT(why([](Weights& w) { w.tensors["shapes"].values[3] += 0.5F; }), HasSubstr("atom 0 is not of length 1"));
  EXPECT_THAT(why([](Weights& w) { w.tensors["details"].values[130] = 1e9F; }), HasSubstr("detail of atom 2"));
  EXPECT_THAT(why([](Weights& w) { w.tensors["details"].values[130] = NAN; }), HasSubstr("detail of atom 2"));
  const auto many = static_cast<size_t>(kMostAtoms) + 1;
  EXPECT_THAT(why([&](Weights& w) {
                w.tensors["shapes"] = {{static_cast<int64_t>(many), kFeatures}, std::vector<float>(many * kFeatures)};
              }),
              HasSubstr("at most 32768"));
}

}  // namespace
}  // namespace seamount::amplify
