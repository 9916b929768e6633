// Reading painted label maps. The order of things:
//   1. seeds: pixels in the middle of an evenly coloured patch whose hue is a region's; they also tell what the value V
//      of pure colours is here;
//   2. every pixel learns its nearest seed, hence the V that a pure colour has around it;
//   3. marks: seeds, and single pixels that are a pure colour at that V (lines one pixel wide);
//   4. every other pixel is explained as a mix of two regions marked nearby. A seam of red and green is dark yellow,
//      half the value of true yellow, which tells them apart;
//   5. specks that are not pure go to their neighbours; shares are averaged to the cells.
#include "seamount/geom/grid/painted_labels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/geom/grid/closing.h"
#include "seamount/geom/scalar/quantile.h"

namespace seamount::geom {
namespace {

constexpr uint8_t kNone = 255;
constexpr double kPureHue_deg = 15.0;  ///< so far from a region's hue is still that region alone
constexpr float kColoured = 0.3F;      ///< saturation from which hue can be trusted
constexpr float kFull = 0.8F;          ///< saturation of a colour that is meant as painted, not washed out or blended
constexpr float kDark = 0.08F;         ///< value below which it cannot
constexpr int kReach = 5;              ///< pixels over which a blurred seam may run
constexpr int kSeam = 4;               ///< pixels to either side of a seam that its blur may darken

struct Vec3 {
  float r = 0, g = 0, b = 0;
};

/// Pure colours at V = 1, by region number.
constexpr std::array<Vec3, kRegionCount> kPure = {{{1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}, {1, 0, 0}}};

struct Hsv {
  float hue_deg = 0, saturation = 0, value = 0;
};

Hsv to_hsv(Vec3 c) {
  const float high = std::max({c.r, c.g, c.b}), low = std::min({c.r, c.g, c.b}), chroma = high - low;
  if (high <= 0 || chroma <= 0) return {0, 0, high};
  float sector = 0;
  if (high == c.r) {
    sector = (c.g - c.b) / chroma;
  } else if (high == c.g) {
    sector = 2 + (c.b - c.r) / chroma;
  } else {
    sector = 4 + (c.r - c.g) / chroma;
  }
  return {sector < 0 ? 60 * sector + 360 : 60 * sector, chroma / high, high};
}

double hue_distance(double a, double b) {
  const double d = std::abs(a - b);
  return std::min(d, 360 - d);
}

/// The region whose hue this is, within kPureHue_deg; kNone between regions.
uint8_t pure_region(float hue_deg) {
  for (uint8_t region = 0; region < kRegionCount; ++region)
    if (hue_distance(hue_deg, kRegionHues_deg[region]) <= kPureHue_deg) return region;
  return kNone;
}

/// What a pixel is made of: (1 - t) of `a` and t of `b`, t in [0, 1/2].
struct Mix {
  uint8_t a = 0, b = 0;
  bool pure = false;
  float t = 0;
};

Mix ordered(int a, int b, float t) {
  if (t > 0.5F) return {static_cast<uint8_t>(b), static_cast<uint8_t>(a), false, 1 - t};
  return {static_cast<uint8_t>(a), static_cast<uint8_t>(b), false, t};
}

/// A hue between two regions as a mix; the wide gap from reef (240) to abyss (360) is a mix of these two.
Mix mix_of_hue(float hue_deg) {
  constexpr std::array<int, 6> kOrder = {4, 0, 1, 2, 3, 4};
  constexpr std::array<float, 6> kHues = {0, 60, 120, 180, 240, 360};
  size_t i = 0;
  while (i + 2 < kHues.size() && hue_deg >= kHues[i + 1]) ++i;
  const float margin = static_cast<float>(kPureHue_deg);
  const float t = (hue_deg - kHues[i] - margin) / (kHues[i + 1] - kHues[i] - 2 * margin);
  return ordered(kOrder[i], kOrder[i + 1], std::clamp(t, 0.0F, 1.0F));
}

class Painting {
 public:
  Painting(const Image& image, const RunContext& run)
      : width_(image.width), height_(image.height), run_(run), image_(image), hsv_(size()), seed_(size(), kNone) {}

  /// Mixes of all pixels, row by row.
  std::vector<Mix> read() {
    rows([&](int y) {
      for (int x = 0; x < width_; ++x) hsv_[at(x, y)] = to_hsv(colour(x, y));
    });
    find_seeds();
    spread_seeds();
    mark_neighbourhoods();
    std::vector<Mix> mixes(size());
    rows([&](int y) {
      for (int x = 0; x < width_; ++x) mixes[at(x, y)] = explain(x, y);
    });
    remove_specks(mixes);
    return mixes;
  }

  /// V of pure colours around a pixel.
  float value_near(size_t pixel) const { return seed_value_[static_cast<size_t>(nearest_[pixel])]; }
  double median_value() const { return median_value_; }
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  size_t size() const { return static_cast<size_t>(width_) * static_cast<size_t>(height_); }
  size_t at(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x);
  }
  Vec3 colour(int x, int y) const {
    const uint8_t* p = image_.pixel(x, y);
    return {p[0] / 255.0F, p[1] / 255.0F, p[2] / 255.0F};
  }
  template <class Row>
  void rows(const Row& row) {
    parallel_rows(run_, width_, height_, [&](int begin, int end) {
      for (int y = begin; y < end; ++y) row(y);
    });
  }

  /// Pixels of the patch of `reach` pixels around (x, y) that look like its middle, as a share of those inside the
  /// picture, and their mean value.
  std::pair<float, float> agreement(int x, int y, double most_degrees, int reach) const {
    const Hsv middle = hsv_[at(x, y)];
    int same = 0, all = 0;
    float value = 0;
    for (int j = std::max(y - reach, 0); j <= std::min(y + reach, height_ - 1); ++j) {
      for (int i = std::max(x - reach, 0); i <= std::min(x + reach, width_ - 1); ++i) {
        const Hsv& other = hsv_[at(i, j)];
        ++all;
        if (other.saturation < kColoured || hue_distance(other.hue_deg, middle.hue_deg) > most_degrees) continue;
        if (std::abs(other.value - middle.value) > 0.15F * middle.value) continue;
        ++same;
        value += other.value;
      }
    }
    return {static_cast<float>(same) / static_cast<float>(all), same > 0 ? value / static_cast<float>(same) : 0};
  }

  bool has_hue(const Hsv& c) const { return c.saturation >= kColoured && c.value >= kDark; }

  void find_seeds() {
    constexpr float kAgreeing = 0.75F;  // 7 of 9
    seed_value_.assign(size(), 0);
    for (const bool patches_only : {true, false}) {
      rows([&](int y) {
        for (int x = 0; x < width_; ++x) {
          const Hsv& c = hsv_[at(x, y)];
          const uint8_t region = has_hue(c) ? pure_region(c.hue_deg) : kNone;
          if (region == kNone) continue;
          const auto [share, value] = agreement(x, y, 2 * kPureHue_deg, c.saturation >= kFull ? 1 : 3);
          if (patches_only && share < kAgreeing) continue;
          seed_[at(x, y)] = region;
          seed_value_[at(x, y)] = patches_only ? value : c.value;
        }
      });
      if (std::any_of(seed_.begin(), seed_.end(), [](uint8_t seed) { return seed != kNone; })) return;
    }
    throw InvalidArgument("image", "has no pixel in the colour of a region (red, yellow, green, cyan, blue)");
  }

  /// Nearest seed of each pixel by two sweeps (exact but for rare ties), and the median value of seeds.
  void spread_seeds() {
    nearest_.assign(size(), -1);
    std::vector<float> values;
    for (size_t i = 0; i < size(); ++i) {
      if (seed_[i] == kNone) continue;
      nearest_[i] = static_cast<int32_t>(i);
      values.push_back(seed_value_[i]);
    }
    median_value_ = median(std::move(values));
    for (int y = 0; y < height_; ++y) {
      run_.check_cancelled();
      for (int x = 0; x < width_; ++x)
        for (const auto& [dx, dy] : {std::pair(-1, 0), std::pair(-1, -1), std::pair(0, -1), std::pair(1, -1)})
          adopt(x, y, x + dx, y + dy);
      for (int x = width_ - 1; x >= 0; --x) adopt(x, y, x + 1, y);
    }
    for (int y = height_ - 1; y >= 0; --y) {
      for (int x = width_ - 1; x >= 0; --x)
        for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(1, 1), std::pair(0, 1), std::pair(-1, 1)})
          adopt(x, y, x + dx, y + dy);
      for (int x = 0; x < width_; ++x) adopt(x, y, x - 1, y);
    }
  }

  /// Takes over a neighbour's seed if it is nearer than the own one.
  void adopt(int x, int y, int from_x, int from_y) {
    if (seed_[at(x, y)] != kNone) return;  // its own
    if (from_x < 0 || from_y < 0 || from_x >= width_ || from_y >= height_) return;
    const int32_t seed = nearest_[at(from_x, from_y)];
    if (seed < 0) return;
    const auto distance2 = [&](int32_t pixel) {
      const int64_t dx = pixel % width_ - x, dy = pixel / width_ - y;
      return dx * dx + dy * dy;
    };
    int32_t& own = nearest_[at(x, y)];
    if (own < 0 || distance2(seed) < distance2(own)) own = seed;
  }

  /// The region of a pixel that is exactly as colourful and bright as pure colours are here.
  uint8_t mark_of(size_t i) const {
    if (seed_[i] != kNone) return seed_[i];
    const Hsv& c = hsv_[i];
    const float value = value_near(i);
    if (c.saturation < 0.93F || c.value < kDark || std::abs(c.value - value) > 0.08F * value) return kNone;
    const uint8_t region = pure_region(c.hue_deg);
    return region != kNone && hue_distance(c.hue_deg, kRegionHues_deg[region]) <= 0.5 * kPureHue_deg ? region : kNone;
  }

  /// The regions that are marked within kReach pixels, as bits.
  void mark_neighbourhoods() {
    std::vector<uint8_t> marks(size()), along(size());
    rows([&](int y) {
      for (int x = 0; x < width_; ++x) {
        const uint8_t mark = mark_of(at(x, y));
        marks[at(x, y)] = mark == kNone ? uint8_t{0} : static_cast<uint8_t>(1U << mark);
      }
    });
    nearby_.assign(size(), 0);
    rows([&](int y) {
      for (int x = 0; x < width_; ++x)
        for (int i = std::max(x - kReach, 0); i <= std::min(x + kReach, width_ - 1); ++i)
          along[at(x, y)] |= marks[at(i, y)];
    });
    rows([&](int y) {
      for (int j = std::max(y - kReach, 0); j <= std::min(y + kReach, height_ - 1); ++j)
        for (int x = 0; x < width_; ++x) nearby_[at(x, y)] |= along[at(x, j)];
    });
  }

  Mix explain(int x, int y) const {
    const size_t i = at(x, y);
    if (const uint8_t mark = mark_of(i); mark != kNone) return {mark, mark, true, 0};
    const Hsv& c = hsv_[i];
    const float value = std::max(value_near(i), kDark);
    const bool bright = std::abs(c.value - value) <= 0.2F * value;
    // An even patch of a hue between two regions is meant as a mix.
    if (c.saturation >= kFull && bright && agreement(x, y, 10.0, 1).first >= 0.99F) return mix_of_hue(c.hue_deg);
    return best_pair(i, colour(x, y), value);
  }

  /// The pair of nearby regions whose blend is closest to the colour, or the nearest region if none comes close.
  Mix best_pair(size_t i, Vec3 c, float value) const {
    constexpr float kClose = 0.4F;
    c = {c.r / value, c.g / value, c.b / value};
    const uint8_t home = seed_[static_cast<size_t>(nearest_[i])];
    const unsigned nearby = nearby_[i] | 1U << home;
    Mix best{home, home, false, 0};
    float best_distance = kClose;
    for (int a = 0; a < kRegionCount; ++a) {
      for (int b = a; b < kRegionCount; ++b) {
        if ((nearby >> a & 1U) == 0 || (nearby >> b & 1U) == 0) continue;
        const Vec3 p = kPure[static_cast<size_t>(a)], q = kPure[static_cast<size_t>(b)];
        const Vec3 d{q.r - p.r, q.g - p.g, q.b - p.b}, e{c.r - p.r, c.g - p.g, c.b - p.b};
        const float length2 = d.r * d.r + d.g * d.g + d.b * d.b;
        const float along = length2 > 0 ? (d.r * e.r + d.g * e.g + d.b * e.b) / length2 : 0;
        const float t = std::clamp(along, 0.0F, 1.0F);
        const Vec3 off{e.r - t * d.r, e.g - t * d.g, e.b - t * d.b};
        const float distance = std::sqrt(off.r * off.r + off.g * off.g + off.b * off.b);
        if (distance < best_distance) {
          best_distance = distance;
          best = ordered(a, b, t);
        }
      }
    }
    return best;
  }

  /// Connected patches (4 neighbours) of a few pixels without a pure one become what most of their neighbours are.
  void remove_specks(std::vector<Mix>& mixes) const {
    for (size_t start = 0; start < size(); ++start)
      if (!mixes[start].pure) remove_speck(mixes, start);
  }

  void remove_speck(std::vector<Mix>& mixes, size_t start) const {
    constexpr size_t kFew = 4;
    const uint8_t label = mixes[start].a;
    std::array<int, kRegionCount> around{};
    std::array<size_t, kFew> patch{start};
    size_t count = 1;
    for (size_t next = 0; next < count; ++next) {
      const int x = static_cast<int>(patch[next] % static_cast<size_t>(width_));
      const int y = static_cast<int>(patch[next] / static_cast<size_t>(width_));
      for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
        if (x + dx < 0 || y + dy < 0 || x + dx >= width_ || y + dy >= height_) continue;
        const size_t j = at(x + dx, y + dy);
        if (mixes[j].a != label) {
          ++around[mixes[j].a];
        } else if (std::find(patch.begin(), patch.begin() + count, j) == patch.begin() + count) {
          if (count == kFew || mixes[j].pure) return;
          patch[count++] = j;
        }
      }
    }
    const auto most = std::max_element(around.begin(), around.end());
    if (*most == 0) return;
    const auto region = static_cast<uint8_t>(most - around.begin());
    for (size_t i = 0; i < count; ++i) mixes[patch[i]] = {region, region, false, 0};
  }

  int width_, height_;
  const RunContext& run_;
  const Image& image_;
  std::vector<Hsv> hsv_;
  std::vector<uint8_t> seed_;  ///< region, or kNone
  std::vector<float> seed_value_;
  std::vector<int32_t> nearest_;
  std::vector<uint8_t> nearby_;
  double median_value_ = 1.0;
};

/// The pixels that a cell covers along one axis: [first, last], each with its weight. Where cells are smaller than
/// pixels, the two nearest pixels, linearly.
struct Cover {
  int first = 0;
  std::vector<float> weights;
};

std::vector<Cover> covers(int cells, int pixels) {
  std::vector<Cover> result(static_cast<size_t>(cells));
  const double scale = static_cast<double>(pixels) / cells;
  for (int i = 0; i < cells; ++i) {
    Cover& cover = result[static_cast<size_t>(i)];
    const double half = 0.5 * std::max(scale, 1.0), middle = (i + 0.5) * scale;
    const double low = std::max(middle - half, 0.0), high = std::min(middle + half, static_cast<double>(pixels));
    cover.first = std::min(static_cast<int>(low + 1e-9), pixels - 1);
    for (int p = cover.first; p < pixels && p < high - 1e-9; ++p)
      cover.weights.push_back(static_cast<float>(std::min(high, p + 1.0) - std::max(low, static_cast<double>(p))));
    float total = 0;
    for (const float weight : cover.weights) total += weight;
    for (float& weight : cover.weights) weight /= total;
  }
  return result;
}

float subsidence_of(double value) { return static_cast<float>(std::clamp((1.0 - value) / 0.8, 0.0, 1.0)); }

}  // namespace

PaintedLabels decode_labels(const Image& image, const GridFrame& frame, const RunContext& run) {
  if (image.width < 1 || image.height < 1) throw InvalidArgument("image", "is empty");
  if (frame.width < 1 || frame.height < 1) throw InvalidArgument("frame", "has no cells");
  if (int64_t{image.width} * image.height > std::numeric_limits<int32_t>::max())
    throw InvalidArgument("image", "has too many pixels");
  Painting painting(image, run);
  const std::vector<Mix> mixes = painting.read();
  ScalarField values(GridFrame::centred(image.width, image.height, 1.0));  // V of pure colours at each pixel
  for (size_t i = 0; i < values.cells().size(); ++i) values.cells()[i] = painting.value_near(i);
  values = closing(values, kSeam, run);
  PaintedLabels result;
  result.labels = LabelMap(frame);
  result.subsidence_per_cell = ScalarField(frame);
  for (Mask& share : result.shares) share = Mask(frame);
  result.subsidence = subsidence_of(painting.median_value());
  const std::vector<Cover> across = covers(frame.width, image.width), down = covers(frame.height, image.height);
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const Cover& rows = down[static_cast<size_t>(y)];
      for (int x = 0; x < frame.width; ++x) {
        const Cover& columns = across[static_cast<size_t>(x)];
        std::array<float, kRegionCount> shares{};
        float subsidence = 0;
        for (size_t j = 0; j < rows.weights.size(); ++j) {
          for (size_t i = 0; i < columns.weights.size(); ++i) {
            const float weight = rows.weights[j] * columns.weights[i];
            const size_t pixel = (static_cast<size_t>(rows.first) + j) * static_cast<size_t>(image.width) +
                                 static_cast<size_t>(columns.first) + i;
            const Mix& mix = mixes[pixel];
            shares[mix.a] += weight * (1 - mix.t);
            shares[mix.b] += weight * mix.t;
            subsidence += weight * subsidence_of(values.cells()[pixel]);
          }
        }
        for (size_t region = 0; region < kRegionCount; ++region) result.shares[region](x, y) = shares[region];
        result.labels(x, y) = static_cast<Region>(std::max_element(shares.begin(), shares.end()) - shares.begin());
        result.subsidence_per_cell(x, y) = subsidence;
      }
    }
  });
  return result;
}

}  // namespace seamount::geom
