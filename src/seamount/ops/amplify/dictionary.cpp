#include "seamount/ops/amplify/dictionary.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "seamount/base/error.h"
#include "seamount/base/simd.h"
#include "seamount/base/text.h"

namespace seamount::amplify {
namespace {

constexpr size_t kLanes = 16;    ///< atoms side by side
constexpr size_t kTogether = 8;  ///< shapes that are compared at once
constexpr float kLargestDetail = 10.0F;

std::string shape_text(const std::vector<int64_t>& shape) {
  std::string text;
  for (const int64_t side : shape) text += (text.empty() ? "" : " x ") + std::to_string(side);
  return text.empty() ? "one number" : text;
}

const Tensor& tensor_of(const Weights& weights, const std::string& name, const std::vector<int64_t>& sides) {
  const auto found = weights.tensors.find(name);
  if (found == weights.tensors.end()) throw Error("is no dictionary: '" + name + "' is missing");
  const Tensor& tensor = found->second;
  const bool fits = tensor.shape.size() == sides.size() + 1 && tensor.shape[0] >= 1 &&
                    std::equal(sides.begin(), sides.end(), tensor.shape.begin() + 1);
  if (!fits) throw Error("'" + name + "' is " + shape_text(tensor.shape) + ", expected atoms x " + shape_text(sides));
  if (tensor.shape[0] > kMostAtoms)
    throw Error("has " + std::to_string(tensor.shape[0]) + " atoms; at most " + std::to_string(kMostAtoms));
  return tensor;
}

template <size_t n>
std::vector<std::array<float, n>> rows_of(const Tensor& tensor) {
  std::vector<std::array<float, n>> rows(static_cast<size_t>(tensor.shape[0]));
  for (size_t i = 0; i < rows.size(); ++i) std::copy_n(tensor.values.begin() + i * n, n, rows[i].begin());
  return rows;
}

template <size_t n>
void append(std::vector<float>& values, const std::vector<std::array<float, n>>& rows) {
  for (const auto& row : rows) values.insert(values.end(), row.begin(), row.end());
}

void check_atoms(const Dictionary& dictionary) {
  for (size_t i = 0; i < dictionary.shapes.size(); ++i) {
    float squares = 0.0F;
    for (const float f : dictionary.shapes[i]) squares += f * f;
    if (!(std::abs(squares - 1.0F) < 1e-3F))
      throw Error("the shape of atom " + std::to_string(i) + " is not of length 1");
    for (const float z : dictionary.details[i]) {
      if (!(std::abs(z) <= kLargestDetail))
        throw Error("the detail of atom " + std::to_string(i) + " has a number that is not within [-10, 10]");
    }
  }
}

// Sixteen numbers at once, in whatever registers there are: left to itself the compiler keeps sums in memory.
using Lanes = float __attribute__((vector_size(kLanes * sizeof(float))));
using Bits = int __attribute__((vector_size(kLanes * sizeof(int))));

/// Products of kTogether shapes with all atoms; keeps the best of each lane.
SEAMOUNT_VECTORISED void best_of_lanes(const float* tiles, int tile_count, const float* shapes, float* best,
                                       int* tile_of) {
  for (size_t i = 0; i < kTogether * kLanes; ++i) {
    best[i] = -2.0F;
    tile_of[i] = 0;
  }
  for (int tile = 0; tile < tile_count; ++tile) {
    const float* atoms = tiles + static_cast<size_t>(tile) * kFeatures * kLanes;
    Lanes sums[kTogether] = {};
    for (size_t f = 0; f < kFeatures; ++f) {
      Lanes column;
      std::memcpy(&column, atoms + f * kLanes, sizeof column);
      for (size_t s = 0; s < kTogether; ++s) sums[s] += shapes[s * kFeatures + f] * column;
    }
    for (size_t s = 0; s < kTogether; ++s) {
      Lanes most;
      Bits of;
      std::memcpy(&most, best + s * kLanes, sizeof most);
      std::memcpy(&of, tile_of + s * kLanes, sizeof of);
      const Bits better = sums[s] > most;
      Bits sum_bits, most_bits;
      std::memcpy(&sum_bits, &sums[s], sizeof sum_bits);
      std::memcpy(&most_bits, &most, sizeof most_bits);
      const Bits kept = (better & sum_bits) | (~better & most_bits);
      of = (better & tile) | (~better & of);
      std::memcpy(best + s * kLanes, &kept, sizeof kept);
      std::memcpy(tile_of + s * kLanes, &of, sizeof of);
    }
  }
}

}  // namespace

Dictionary dictionary_of(const Weights& weights) {
  const auto kind = weights.about.find("kind");
  if (kind == weights.about.end() || kind->second != "dictionary")
    throw Error(kind == weights.about.end() ? "does not say that it is a dictionary"
                                            : "is a model of another kind: '" + kind->second + "'");
  const Tensor& shapes = tensor_of(weights, "shapes", {kFeatures});
  const Tensor& details = tensor_of(weights, "details", {kDetail, kDetail});
  if (weights.tensors.size() != 2) throw Error("has tensors that no dictionary has");
  if (shapes.shape[0] != details.shape[0])
    throw Error("has " + std::to_string(shapes.shape[0]) + " shapes and " + std::to_string(details.shape[0]) +
                " details");
  Dictionary dictionary{rows_of<kFeatures>(shapes), rows_of<kDetail * kDetail>(details)};
  check_atoms(dictionary);
  return dictionary;
}

Weights weights_of(const Dictionary& dictionary) {
  const auto atoms = static_cast<int64_t>(dictionary.shapes.size());
  Weights weights;
  Tensor& shapes = weights.tensors["shapes"];
  shapes.shape = {atoms, kFeatures};
  append(shapes.values, dictionary.shapes);
  Tensor& details = weights.tensors["details"];
  details.shape = {atoms, kDetail, kDetail};
  append(details.values, dictionary.details);
  weights.about["kind"] = "dictionary";
  return weights;
}

AtomTable::AtomTable(std::span<const Features> shapes) {
  const size_t tiles = (shapes.size() + kLanes - 1) / kLanes;
  tiles_.resize(tiles * kFeatures * kLanes);
  for (size_t atom = 0; atom < tiles * kLanes; ++atom) {
    const Features& shape = atom < shapes.size() ? shapes[atom] : shapes[0];
    for (size_t f = 0; f < kFeatures; ++f)
      tiles_[((atom / kLanes) * kFeatures + f) * kLanes + atom % kLanes] = shape[f];
  }
}

void AtomTable::find(std::span<const Features> shapes, std::span<Match> matches) const {
  const auto tiles = static_cast<int>(tiles_.size() / (kFeatures * kLanes));
  std::array<Features, kTogether> given{};
  std::array<float, kTogether * kLanes> best;
  std::array<int, kTogether * kLanes> tile_of;
  for (size_t first = 0; first < shapes.size(); first += kTogether) {
    const size_t count = std::min(kTogether, shapes.size() - first);
    std::copy_n(shapes.begin() + first, count, given.begin());
    best_of_lanes(tiles_.data(), tiles, given[0].data(), best.data(), tile_of.data());
    for (size_t s = 0; s < count; ++s) {
      Match match{0, -2.0F};
      for (size_t l = 0; l < kLanes; ++l) {
        const int atom = tile_of[s * kLanes + l] * static_cast<int>(kLanes) + static_cast<int>(l);
        const float cosine = best[s * kLanes + l];
        if (cosine > match.cosine || (cosine == match.cosine && atom < match.atom)) match = {atom, cosine};
      }
      matches[first + s] = match;
    }
  }
}

}  // namespace seamount::amplify
