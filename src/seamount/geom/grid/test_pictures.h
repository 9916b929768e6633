// Painted islands, and how far what is read of them is from the truth: for tests of reading label pictures.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "seamount/base/rng.h"
#include "seamount/geom/grid/painted_labels.h"

namespace seamount::geom {

/// Regions of an island as rings, wobbling, at a finer scale; `order` says which region lies at which ring.
inline Region island_at(double x, double y, const std::array<Region, 5>& order) {
  const double angle = std::atan2(y, x);
  const double r = std::hypot(x, y) * (1 + 0.12 * std::sin(3 * angle) + 0.05 * std::cos(7 * angle));
  constexpr std::array<double, 4> kRings = {0.25, 0.36, 0.62, 0.75};
  size_t ring = 0;
  while (ring < kRings.size() && r > kRings[ring]) ++ring;
  return order[ring];
}

inline LabelMap island(int size, const std::array<Region, 5>& order) {
  LabelMap labels(GridFrame::centred(size, size, 10));
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) labels(x, y) = island_at(2 * (x + 0.5) / size - 1, 2 * (y + 0.5) / size - 1, order);
  return labels;
}

/// The same island with each pixel the mean of 8 x 8 samples.
inline Image antialiased(int size, const std::array<Region, 5>& order, double subsidence) {
  constexpr int kSamples = 8;
  const Image fine = encode_labels(island(size * kSamples, order), subsidence);
  Image image(size, size);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      for (int c = 0; c < 3; ++c) {
        int sum = 0;
        for (int k = 0; k < kSamples * kSamples; ++k)
          sum += fine.pixel(x * kSamples + k % kSamples, y * kSamples + k / kSamples)[c];
        image.pixel(x, y)[c] = static_cast<uint8_t>(sum / (kSamples * kSamples));
      }
    }
  }
  return image;
}

/// Gaussian blur by direct sums.
inline Image blurred(const Image& image, double sigma) {
  Image result = image;
  const int reach = static_cast<int>(std::ceil(3 * sigma));
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      std::array<double, 3> sum{};
      double weights = 0;
      for (int j = -reach; j <= reach; ++j) {
        for (int i = -reach; i <= reach; ++i) {
          const uint8_t* p = image.pixel(std::clamp(x + i, 0, image.width - 1), std::clamp(y + j, 0, image.height - 1));
          const double w = std::exp(-0.5 * (i * i + j * j) / (sigma * sigma));
          weights += w;
          for (size_t c = 0; c < 3; ++c) sum[c] += w * p[c];
        }
      }
      for (size_t c = 0; c < 3; ++c) result.pixel(x, y)[c] = static_cast<uint8_t>(std::lround(sum[c] / weights));
    }
  }
  return result;
}

inline Image noisy(Image image, double deviation) {
  Rng rng(Seed{5}.derive("noise"));
  for (uint8_t& value : image.rgb)
    value = static_cast<uint8_t>(std::clamp(value + deviation * rng.normal(), 0.0, 255.0));
  return image;
}

/// Cells that differ from the truth, of all and of those that are not next to another region.
struct Errors {
  double all = 0, inside = 0, invented = 0;
};

inline Errors errors(const LabelMap& found, const LabelMap& truth) {
  Errors result;
  double inside = 0;
  for (int y = 0; y < truth.height(); ++y) {
    for (int x = 0; x < truth.width(); ++x) {
      bool border = false, known = false;
      for (int j = -2; j <= 2; ++j) {
        for (int i = -2; i <= 2; ++i) {
          border = border || truth.clamped(x + i, y + j) != truth(x, y);
          known = known || truth.clamped(x + i, y + j) == found(x, y);
        }
      }
      inside += border ? 0 : 1;
      if (found(x, y) == truth(x, y)) continue;
      result.all += 1;
      result.inside += border ? 0 : 1;
      result.invented += known ? 0 : 1;  // a region that is nowhere near: a false seam
    }
  }
  const auto cells = static_cast<double>(truth.size());
  return {result.all / cells, result.inside / inside, result.invented / cells};
}

inline constexpr std::array<Region, 5> kInOrder = {Region::mountain, Region::beach, Region::lagoon, Region::reef,
                                                   Region::abyss};
/// Every neighbourhood whose blend looks like a third region or like none: green|red, cyan|red, yellow|cyan,
/// yellow|blue.
inline constexpr std::array<Region, 5> kTraps = {Region::beach, Region::abyss, Region::lagoon, Region::mountain,
                                                 Region::reef};
inline constexpr std::array<Region, 5> kMoreTraps = {Region::abyss, Region::beach, Region::reef, Region::abyss,
                                                     Region::mountain};

}  // namespace seamount::geom
