#include "seamount/ops/learned/architecture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "seamount/base/error.h"
#include "seamount/ops/learned/network.h"
#include "seamount/ops/learned/test_network.h"

namespace seamount::learned {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// What is said of weights after a change, by those who read a network; empty if they take it.
std::string refusal(const std::function<void(Weights&)>& change) {
  Weights weights = random_weights({3, {8, 16, 24}});
  change(weights);
  try {
    const Network network(weights, Precision::f32);
    return "";
  } catch (const InvalidArgument& error) {
    return error.what();
  }
}

TEST(Architecture, IsReadAsItWasDescribed) {
  for (const Architecture& a :
       {Architecture{}, Architecture{1, {8, 512}}, Architecture{32, {8, 9, 10, 11, 12, 13, 14, 15}}})
    EXPECT_EQ(architecture_of(random_weights(a)), a);
}

TEST(Architecture, NamesItsConvolutionsInTheOrderOfEvaluation) {
  std::vector<std::string> names;
  for (const Convolution& c : convolutions({4, {16, 192, 32}})) {
    names.push_back(c.name + ":" + std::to_string(c.in) + ">" + std::to_string(c.out) + "/" + std::to_string(c.kernel) +
                    std::to_string(c.stride));
  }
  EXPECT_THAT(names, ElementsAre("input:16>16/31", "down1:16>192/32", "down2:192>32/32", "middle:32>32/31",
                                 "lift1:32>192/11", "join1:192>192/31", "deep1:192>192/31", "lift0:192>16/11",
                                 "join0:16>16/31", "thin:16>8/11", "inner:12>8/31", "outer:8>1/31"));
  EXPECT_EQ((Architecture{4, {16, 192, 32}}).stride(), 8);
}

TEST(Architecture, OfWeightsThatAreNoNetworkIsRefusedByName) {
  EXPECT_EQ(refusal([](Weights&) {}), "");
  EXPECT_EQ(refusal([](Weights& w) { w.tensors.erase("join1.weight"); }), "join1.weight: is missing");
  EXPECT_EQ(refusal([](Weights& w) { w.tensors.erase("outer.bias"); }), "outer.bias: is missing");
  EXPECT_EQ(refusal([](Weights& w) {
              w.tensors["lift0.weight"].shape = {8, 16, 1};
            }),
            "lift0.weight: has another shape than the network needs");
  EXPECT_EQ(refusal([](Weights& w) { w.tensors["thin.bias"].values.pop_back(); }),
            "thin.bias: has fewer or more numbers than its shape");
  EXPECT_EQ(refusal([](Weights& w) { w.tensors["thin.bias"].values[3] = std::numeric_limits<float>::infinity(); }),
            "thin.bias: holds a number that is not finite");
  EXPECT_EQ(refusal([](Weights& w) { w.about["widths"] = "8,16,32"; }),
            "down2.weight: has another shape than the network needs");
  EXPECT_EQ(refusal([](Weights& w) { w.tensors["more"] = {{1}, {1}}; }), "");
}

TEST(Architecture, ThatIsNotSaidOrOutOfRangeIsRefused) {
  EXPECT_THAT(refusal([](Weights& w) { w.about.erase("planes"); }), HasSubstr("planes: is not said"));
  EXPECT_THAT(refusal([](Weights& w) { w.about.erase("widths"); }), HasSubstr("widths: is not said"));
  EXPECT_EQ(refusal([](Weights& w) { w.about["planes"] = "33"; }), "planes: \"33\" is no number in [1, 32]");
  for (const char* wrong : {"", "8", "8,", ",8", "8,16,x", "8,16,24 ", "8,7", "8,513", "8,8,8,8,8,8,8,8,8", "8,,8",
                            "99999999999999,8", "-8,8"})
    EXPECT_THAT(refusal([&](Weights& w) { w.about["widths"] = wrong; }), HasSubstr("widths: ")) << wrong;
}

}  // namespace
}  // namespace seamount::learned
