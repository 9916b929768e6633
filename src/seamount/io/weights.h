// Weights from and to safetensors files (github.com/huggingface/safetensors): the length of the header in 8 bytes, the
// header, which is JSON and says type, shape and place of every tensor, and the numbers, little-endian.
//
// Reading is strict: tensors are F32, F16 or BF16, they fill the data without gap or overlap, and every number is
// finite. A damaged or hostile file is an IoError that says what is wrong with it. Memory: that of the file and of the
// numbers as f32, and at most some hundred times the header, which is limited to 1 MiB; nothing is allocated by what a
// file claims. "__metadata__" is what a file says about itself: Weights::about.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "seamount/model/weights.h"

namespace seamount::io {

enum class WeightType { f32, f16 };

/// Files of at most 512 MiB. Throws IoError{path}.
Weights read_weights(const std::string& path);
/// The same from memory; `name` stands in messages.
Weights read_weights(std::span<const uint8_t> bytes, const std::string& name);

/// f16 rounds to 11 bits. Throws InvalidArgument{tensor} for numbers that the type cannot hold, a shape that is not
/// that of the numbers, names or words that are no UTF-8; InvalidArgument{"weights"} where read_weights() would refuse
/// the header for its size.
std::vector<uint8_t> encode_weights(const Weights& weights, WeightType type);

/// The same into a file, all of it or nothing. Throws WriteError{path}, and what encode_weights() throws.
void write_weights(const Weights& weights, const std::string& path, WeightType type);

}  // namespace seamount::io
