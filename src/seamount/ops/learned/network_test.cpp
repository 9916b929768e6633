#include "seamount/ops/learned/network.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <tuple>

#include "seamount/ops/learned/convolver.h"
#include "seamount/ops/learned/test_network.h"

namespace seamount::learned {
namespace {

/// A layer of the oracle: planes first.
struct Layer {
  int width = 0, height = 0, count = 0;
  std::vector<float> values;

  Layer(int w, int h, int n) : width(w), height(h), count(n), values(static_cast<size_t>(w) * h * n) {}
  float& at(int x, int y, int c) { return values[(static_cast<size_t>(c) * height + y) * width + x]; }
  float at(int x, int y, int c) const { return const_cast<Layer*>(this)->at(x, y, c); }
  float padded(int x, int y, int c) const { return x < 0 || y < 0 || x >= width || y >= height ? 0.0F : at(x, y, c); }
  float clamped(int x, int y, int c) const { return at(std::clamp(x, 0, width - 1), std::clamp(y, 0, height - 1), c); }
};

/// The network as architecture.h says it.
class Oracle {
 public:
  explicit Oracle(const Weights& weights) : weights_(weights), architecture_(architecture_of(weights)) {}

  ScalarField evaluate(int width, int height) const {
    const int stride = architecture_.stride(), last = architecture_.levels() - 1;
    Layer x((width + stride - 1) / stride * stride, (height + stride - 1) / stride * stride, architecture_.planes);
    for (int c = 0; c < x.count; ++c)
      for (int v = 0; v < x.height; ++v)
        for (int u = 0; u < x.width; ++u)
          x.at(u, v, c) = plane_value(std::min(u, width - 1), std::min(v, height - 1), c);
    std::vector<Layer> e = {relu(convolve("input", halves(x), 1))};
    for (int k = 1; k <= last; ++k) e.push_back(relu(convolve("down" + std::to_string(k), e.back(), 2)));
    Layer d = relu(sum(e[last], convolve("middle", e[last], 1)));
    for (int k = last - 1; k >= 0; --k) {
      const std::string n = std::to_string(k);
      d = relu(convolve("join" + n, relu(sum(up2(convolve("lift" + n, d, 1)), e[k])), 1));
      if (architecture_.widths[k] >= kDeepWidth) d = relu(sum(d, convolve("deep" + n, d, 1)));
    }
    const Layer y = convolve("outer", relu(convolve("inner", concat(up2(convolve("thin", d, 1)), x), 1)), 1);
    ScalarField out(GridFrame::centred(width, height, 1.0));
    for (int v = 0; v < height; ++v)
      for (int u = 0; u < width; ++u) out(u, v) = y.at(u, v, 0);
    return out;
  }

 private:
  static Layer relu(Layer a) {
    for (float& value : a.values) value = std::max(0.0F, value);
    return a;
  }
  static Layer sum(Layer a, const Layer& b) {
    for (size_t i = 0; i < a.values.size(); ++i) a.values[i] += b.values[i];
    return a;
  }
  static Layer halves(const Layer& a) {
    Layer out(a.width / 2, a.height / 2, 4 * a.count);
    for (int c = 0; c < out.count; ++c)
      for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) out.at(x, y, c) = a.at(2 * x + c % 2, 2 * y + c % 4 / 2, c / 4);
    return out;
  }
  static Layer up2(const Layer& a) {
    Layer out(2 * a.width, 2 * a.height, a.count);
    for (int c = 0; c < a.count; ++c) {
      for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
          const int left = (x + 1) / 2 - 1, above = (y + 1) / 2 - 1;
          const float tx = x % 2 == 0 ? 0.75F : 0.25F, ty = y % 2 == 0 ? 0.75F : 0.25F;
          const float upper = a.clamped(left, above, c) * (1 - tx) + a.clamped(left + 1, above, c) * tx;
          const float lower = a.clamped(left, above + 1, c) * (1 - tx) + a.clamped(left + 1, above + 1, c) * tx;
          out.at(x, y, c) = upper * (1 - ty) + lower * ty;
        }
      }
    }
    return out;
  }
  static Layer concat(const Layer& a, const Layer& b) {
    Layer out(a.width, a.height, a.count + b.count);
    std::copy(a.values.begin(), a.values.end(), out.values.begin());
    std::copy(b.values.begin(), b.values.end(), out.values.begin() + static_cast<std::ptrdiff_t>(a.values.size()));
    return out;
  }
  Layer convolve(const std::string& name, const Layer& a, int stride) const {
    const Tensor &weight = weights_.tensors.at(name + ".weight"), &bias = weights_.tensors.at(name + ".bias");
    const auto size = static_cast<int>(weight.shape[2]);
    Layer out(a.width / stride, a.height / stride, static_cast<int>(weight.shape[0]));
    for (int o = 0; o < out.count; ++o) {
      for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
          double total = bias.values[o];
          size_t at = static_cast<size_t>(o) * a.count * size * size;
          for (int i = 0; i < a.count; ++i)
            for (int v = 0; v < size; ++v)
              for (int u = 0; u < size; ++u)
                total += weight.values[at++] * a.padded(stride * x + u - size / 2, stride * y + v - size / 2, i);
          out.at(x, y, o) = static_cast<float>(total);
        }
      }
    }
    return out;
  }

  const Weights& weights_;
  Architecture architecture_;
};

float largest_difference(const ScalarField& a, const ScalarField& b) {
  EXPECT_EQ(a.frame(), b.frame());
  float most = 0.0F;
  for (size_t i = 0; i < a.size(); ++i) {
    const float difference = std::abs(a.cells()[i] - b.cells()[i]);
    if (!(difference <= most)) most = difference;  // what is no number, too
  }
  return most;
}

/// How far the numbers of a field lie apart.
float range_of(const ScalarField& a) {
  const auto [low, high] = std::minmax_element(a.cells().begin(), a.cells().end());
  return *high - *low;
}

ScalarField evaluated(const Network& network, int width, int height, int tile = 0, const RunContext& run = {}) {
  return network.evaluate(test_planes(width, height, network.architecture().planes),
                          GridFrame::centred(width, height, 1.0), run, tile);
}

std::vector<Precision> precisions() {
  std::vector<Precision> all = {Precision::f32};
  if (has_bf16()) all.push_back(Precision::bf16);
  return all;
}

struct Case {
  Architecture architecture;
  int width, height;
};

std::vector<Case> cases() {
  return {{{3, {8, 16, 24}}, 64, 48},
          {{1, {8, 8}}, 5, 3},
          {{16, {32, 64, 128}}, 33, 70},
          {{5, {9, 17, 33, 40}}, 1, 1},
          {{2, {24, 40, 8, 16, 8, 8, 12, 16}}, 300, 20},
          {{7, {16, 24, 192, 200, 192}}, 60, 33},
          {{4, {192, 16, 8}}, 22, 40},
          {{4, {8, 192}}, 18, 90},
          {{32, {8, 16, 24}}, 1, 130},
          {{16, {32, 48, 64}}, 130, 1}};
}

TEST(Network, IsWhatTheArchitectureSays) {
  for (const Case& c : cases()) {
    const Weights weights = random_weights(c.architecture);
    const ScalarField expected = Oracle(weights).evaluate(c.width, c.height);
    const float range = std::max(range_of(expected), 0.1F);
    EXPECT_LE(largest_difference(evaluated(Network(weights, Precision::f32), c.width, c.height), expected), 1e-5F)
        << c.width << " x " << c.height;
    if (has_bf16()) {
      EXPECT_LE(largest_difference(evaluated(Network(weights, Precision::bf16), c.width, c.height), expected),
                0.01F * range)
          << c.width << " x " << c.height;
    }
  }
}

TEST(Network, TilesDoNotShow) {
  for (const Case& c : {Case{{3, {8, 16, 24}}, 100, 250}, Case{{16, {32, 64, 128, 192}}, 70, 300},
                        Case{{2, {192, 192, 8}}, 40, 200}, Case{{1, {8, 8}}, 20, 100}}) {
    for (const Precision precision : precisions()) {
      const Network network(random_weights(c.architecture), precision);
      const ScalarField whole = evaluated(network, c.width, c.height, 512);
      const float bound = precision == Precision::f32 ? 1e-5F : 0.002F * range_of(whole);
      for (const int tile : {16, 48, 64, 128}) {
        EXPECT_LE(largest_difference(evaluated(network, c.width, c.height, tile), whole), bound)
            << tile << " of " << c.height;
      }
    }
  }
}

TEST(Network, GivesTheSameBytesOnAnyNumberOfThreads) {
  for (const Precision precision : precisions()) {
    const Network network(random_weights({7, {16, 32, 64, 192}}), precision);
    for (const int tile : {0, 64}) {
      const ScalarField one = evaluated(network, 150, 203, tile, {.threads = 1});
      EXPECT_EQ(one, evaluated(network, 150, 203, tile, {.threads = 2}));
      EXPECT_EQ(one, evaluated(network, 150, 203, tile));
      EXPECT_EQ(one, evaluated(Network(random_weights({7, {16, 32, 64, 192}}), precision), 150, 203, tile));
    }
  }
}

TEST(Network, StopsWhenItIsCancelled) {
  const Network network(random_weights({3, {8, 16, 24}}));
  std::atomic<bool> stop = false;
  double reached = 0.0;
  const RunContext run{.progress =
                           [&](double fraction) {
                             reached = fraction;
                             stop = fraction > 0.3;
                           },
                       .cancelled = &stop};
  EXPECT_THROW(evaluated(network, 512, 512, 0, run), Cancelled);
  EXPECT_LT(reached, 0.9);
}

TEST(Network, ReportsProgressThatGrowsToOne) {
  const Network network(random_weights({3, {8, 16, 192, 24}}));
  for (const int tile : {0, 64}) {
    double before = 0.0;
    bool grows = true;
    evaluated(network, 200, 200, tile,
              {.progress = [&](double fraction) { grows &= fraction >= before - 1e-9, before = fraction; }});
    EXPECT_TRUE(grows);
    EXPECT_EQ(before, 1.0);
  }
}

TEST(Network, RefusesInputsThatDoNotBelong) {
  const Network network(random_weights({3, {8, 16, 24}}));
  const GridFrame frame = GridFrame::centred(16, 8, 1.0);
  EXPECT_THROW(network.evaluate(test_planes(16, 8, 4), frame, {}), IncompatibleInputs);
  EXPECT_THROW(network.evaluate(test_planes(8, 16, 3), frame, {}), IncompatibleInputs);
  EXPECT_THROW(network.evaluate(test_planes(16, 8, 3), frame, {}, 12), InvalidArgument);
  EXPECT_THROW(network.evaluate(test_planes(16, 8, 3), frame, {}, -8), InvalidArgument);
}

TEST(Network, SaysWhichPrecisionItHas) {
  const Weights weights = random_weights({3, {8, 16, 24}});
  EXPECT_EQ(Network(weights, Precision::f32).precision(), Precision::f32);
  EXPECT_EQ(Network(weights).precision(), has_bf16() ? Precision::bf16 : Precision::f32);
  if (!has_bf16()) {
    EXPECT_THROW(Network(weights, Precision::bf16), InvalidArgument);
  }
}

}  // namespace
}  // namespace seamount::learned
