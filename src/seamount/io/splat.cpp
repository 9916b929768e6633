#include "seamount/io/splat.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/error.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/png_codec.h"
#include "seamount/model/same_size.h"

namespace seamount::io {
namespace {

constexpr size_t kChannels = 4;

/// Shares of 255 by the method of largest remainders: each within one of its true share, the sum exact.
void quantise(std::span<const double> weights, std::span<uint8_t> shares) {
  double total = 0;
  for (const double weight : weights) total += weight;
  std::fill(shares.begin(), shares.end(), uint8_t{0});
  if (!(total > 0)) {
    shares[0] = 255;
    return;
  }
  int left = 255;
  for (size_t i = 0; i < weights.size(); ++i) {
    shares[i] = static_cast<uint8_t>(255.0 * weights[i] / total);
    left -= shares[i];
  }
  for (; left > 0; --left) {
    size_t neediest = 0;
    double most = -1;
    for (size_t i = 0; i < weights.size(); ++i) {
      const double missing = 255.0 * weights[i] / total - shares[i];
      if (missing > most) most = missing, neediest = i;
    }
    ++shares[neediest];
  }
}

/// Files of four materials each, from a function that gives the weights of a cell.
template <class WeightsOf>
std::vector<std::string> write_files(int width, int height, size_t materials, const std::string& path,
                                     const WeightsOf& weights_of) {
  const std::string extension = extension_of(path);
  if (extension != ".png") throw IoError(path, "splat maps are PNG files");
  const size_t files = (materials + kChannels - 1) / kChannels;
  const size_t cells = static_cast<size_t>(width) * static_cast<size_t>(height);
  std::vector<std::vector<uint8_t>> samples(files, std::vector<uint8_t>(cells * kChannels));
  std::vector<double> weights(materials);
  std::vector<uint8_t> shares(materials);
  for (size_t i = 0; i < cells; ++i) {
    weights_of(i, weights);
    quantise(weights, shares);
    for (size_t m = 0; m < materials; ++m) samples[m / kChannels][i * kChannels + m % kChannels] = shares[m];
  }
  std::vector<std::string> paths;
  const std::string stem = path.substr(0, path.size() - extension.size());
  for (size_t file = 0; file < files; ++file) {
    paths.push_back(files == 1 ? path : stem + "_" + std::to_string(file) + extension);
    write_bytes(paths.back(), encode_png8(samples[file], width, height, kChannels));
  }
  return paths;
}

}  // namespace

std::vector<std::string> write_splat(std::span<const Mask> weights, const std::string& path) {
  if (weights.empty() || weights[0].empty()) throw InvalidArgument("weights", "there are none");
  for (const Mask& mask : weights) check_same_size("weights", mask.frame(), weights[0].frame(), "first mask");
  return write_files(weights[0].width(), weights[0].height(), weights.size(), path,
                     [&](size_t i, std::vector<double>& cell) {
                       for (size_t m = 0; m < weights.size(); ++m) {
                         const float weight = weights[m].cells()[i];
                         if (!(weight >= 0) || !std::isfinite(weight))
                           throw InvalidArgument("weights", "must be finite and at least 0");
                         cell[m] = weight;
                       }
                     });
}

std::vector<std::string> write_splat(const LabelMap& labels, const std::string& path) {
  if (labels.empty()) throw InvalidArgument("labels", "there are no cells");
  return write_files(labels.width(), labels.height(), kRegionCount, path, [&](size_t i, std::vector<double>& cell) {
    std::fill(cell.begin(), cell.end(), 0.0);
    cell[static_cast<size_t>(labels.cells()[i])] = 1.0;
  });
}

}  // namespace seamount::io
