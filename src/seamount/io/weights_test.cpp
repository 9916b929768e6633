#include "seamount/io/weights.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "seamount/io/half_float.h"
#include "seamount/io/test_files.h"

namespace seamount::io {
namespace {

using ::testing::HasSubstr;

Weights some_weights() {
  Weights weights;
  weights.about = {{"planes", "3"}, {"made by", "a \"test\"\n\xc3\xa9"}};
  weights.tensors["a.weight"] = {{2, 3, 1, 1}, {0, -1.5F, 2, 65504, 0x1p-24F, -0x1p-14F}};
  weights.tensors["a.bias"] = {{2}, {0.5F, 1023.5F}};
  weights.tensors["one"] = {{}, {7}};
  return weights;
}

/// A file of a header and some bytes of data.
std::vector<uint8_t> file_of(const std::string& header, size_t data) {
  std::vector<uint8_t> out(8);
  for (size_t b = 0; b < 8; ++b) out[b] = static_cast<uint8_t>(header.size() >> (8 * b));
  out.insert(out.end(), header.begin(), header.end());
  out.resize(out.size() + data);
  return out;
}

std::string reading(const std::vector<uint8_t>& bytes) {
  return error_of([&] { read_weights(bytes, "w.safetensors"); });
}

std::string entry(const std::string& name, const std::string& type, const std::string& shape,
                  const std::string& place) {
  return '"' + name + R"(":{"dtype":")" + type + R"(","shape":)" + shape + R"(,"data_offsets":)" + place + "}";
}

TEST(Weights, AreReadAsTheyWereWritten) {
  const TestFolder folder;
  for (const WeightType type : {WeightType::f32, WeightType::f16}) {
    write_weights(some_weights(), folder("w"), type);
    EXPECT_EQ(read_weights(folder("w")), some_weights());
    EXPECT_EQ(folder.files(), 1U);
  }
  EXPECT_EQ(read_weights(encode_weights({}, WeightType::f16), "w"), Weights{});
}

TEST(Weights, BytesAreThoseOfTheFormat) {
  Weights weights;
  weights.tensors["t"] = {{2}, {1, -2}};
  const std::string header = R"({"t":{"data_offsets":[0,4],"dtype":"F16","shape":[2]}})";
  std::vector<uint8_t> expected = file_of(header + "  ", 4);
  const std::vector<uint8_t> numbers = {0x00, 0x3c, 0x00, 0xc0};
  std::copy(numbers.begin(), numbers.end(), expected.end() - 4);
  EXPECT_EQ(encode_weights(weights, WeightType::f16), expected);
}

TEST(Weights, Bf16IsRead) {
  std::vector<uint8_t> bytes = file_of("{" + entry("t", "BF16", "[2]", "[0,4]") + "}", 4);
  const std::vector<uint8_t> numbers = {0x80, 0x3f, 0x49, 0xc0};
  std::copy(numbers.begin(), numbers.end(), bytes.end() - 4);
  EXPECT_EQ(read_weights(bytes, "w").tensors.at("t").values, (std::vector<float>{1, -3.140625F}));
}

TEST(HalfFloat, EveryOneIsItselfAgain) {
  for (uint32_t bits = 0; bits < 0x10000; ++bits) {
    const float value = from_f16(static_cast<uint16_t>(bits));
    if ((bits & 0x7c00) == 0x7c00) {
      EXPECT_FALSE(std::isfinite(value));
      continue;
    }
    const int exponent = static_cast<int>(bits >> 10 & 31), fraction = static_cast<int>(bits & 1023);
    const double size = exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
    ASSERT_EQ(value, (bits & 0x8000) != 0 ? -size : size) << bits;
    ASSERT_EQ(to_f16(value), bits);
  }
}

TEST(HalfFloat, RoundsToTheNearestAndTiesToEven) {
  for (uint16_t bits = 0; bits < 0x7bff; ++bits) {
    const float low = from_f16(bits), high = from_f16(static_cast<uint16_t>(bits + 1)), middle = (low + high) / 2;
    ASSERT_EQ(to_f16(middle), bits + bits % 2) << bits;
    ASSERT_EQ(to_f16(std::nextafter(middle, 0.0F)), bits);
    ASSERT_EQ(to_f16(-std::nextafter(middle, high)), (bits + 1) | 0x8000);
  }
  EXPECT_EQ(to_f16(std::nextafter(65520.0F, 0.0F)), 0x7bff);
  EXPECT_EQ(to_f16(65520.0F), 0x7c00);
}

TEST(Weights, WhatAFileCannotHoldIsNotWritten) {
  const TestFolder folder;
  const auto writing = [&](const std::string& name, Tensor tensor, WeightType type = WeightType::f16) {
    Weights weights;
    weights.tensors[name] = std::move(tensor);
    return error_of([&] { write_weights(weights, folder("w"), type); });
  };
  EXPECT_EQ(writing("big", {{1}, {65520}}), "big: holds 65520.000000, beyond the range of f16 (65504)");
  EXPECT_EQ(writing("big", {{1}, {65520}}, WeightType::f32), "");
  std::filesystem::remove(folder("w"));
  EXPECT_EQ(writing("nan", {{1}, {std::nanf("")}}, WeightType::f32), "nan: holds a number that is not finite");
  EXPECT_EQ(writing("odd", {{2, 2}, {1}}), "odd: has more or fewer numbers than its shape");
  EXPECT_THAT(writing("none", {{0}, {}}), HasSubstr("none: has a side below 1"));
  EXPECT_THAT(writing("huge", {{int64_t{1} << 40, int64_t{1} << 40}, {}}), HasSubstr("huge: has a side"));
  EXPECT_THAT(writing("\xff", {{1}, {1}}), HasSubstr("UTF-8"));
  EXPECT_THAT(writing("__metadata__", {{1}, {1}}), HasSubstr("no name for a tensor"));
  EXPECT_EQ(folder.files(), 0U);
}

TEST(DamagedWeights, SayWhatIsWrong) {
  const std::string good = entry("t", "F32", "[2]", "[0,8]");
  EXPECT_EQ(reading(file_of("{" + good + "}", 8)), "");
  const std::vector<std::array<std::string, 2>> cases = {
      {entry("t", "F64", "[1]", "[0,8]"), "tensor \"t\" holds F64, and only F32, F16 and BF16 can be read"},
      {entry("t", "F32", "[3]", "[0,8]"), "tensor \"t\" has more or fewer bytes than its shape needs"},
      {entry("t", "F32", "[2]", "[4,12]"), "tensor \"t\" lies outside of the file, which may be cut off"},
      {entry("t", "F32", "[2]", "[8,0]"), "tensor \"t\" lies outside of the file, which may be cut off"},
      {entry("t", "F32", "[1]", "[4,8]"), "tensor \"t\" has bytes before it that belong to no tensor"},
      {entry("t", "F32", "[1]", "[0,4]"), "ends with 4 bytes that belong to no tensor"},
      {good + "," + entry("u", "F16", "[2]", "[4,8]"), "tensor \"u\" overlaps another"},
      {good + "," + good, "its header says \"t\" twice"},
      {entry("t", "F32", "[0]", "[0,0]"), "tensor \"t\" has a side that is no whole number above 0"},
      {entry("t", "F32", "[-1]", "[0,8]"), "tensor \"t\" has a side that is no whole number above 0"},
      {entry("t", "F32", "[2.0]", "[0,8]"), "tensor \"t\" has a side that is no whole number above 0"},
      {entry("t", "F32", "[4294967296,4294967296]", "[0,8]"), "tensor \"t\" is larger than the file"},
      {entry("t", "F32", "[1,1,1,1,1,1,1,1,2]", "[0,8]"), "tensor \"t\" has more than 8 sides"},
      {entry("t", "F32", "2", "[0,8]"), "tensor \"t\" has a shape that is no list"},
      {entry("t", "F32", "[2]", "[0,8,9]"), "tensor \"t\" has data_offsets that are not two whole numbers"},
      {entry("t", "F32", "[2]", "[0,1e1]"), "tensor \"t\" has data_offsets that are not two whole numbers"},
      {R"("t":5)", "tensor \"t\" is not described by dtype, shape and data_offsets"},
      {R"("a\u001b":5)", "tensor \"a\\x1b\" is not described by dtype, shape and data_offsets"},
      {good + R"(,"__metadata__":[])", "__metadata__ is no object"},
      {good + R"(,"__metadata__":{"x":1})", "__metadata__: \"x\" is no text"},
      {R"("t":{"a":{"b":{}}})", "its header is nested deeper than any of weights (safetensors)"},
      {std::string(900000, '['), "its header is no JSON object: no weights (safetensors), or damaged"},
      {R"("t":)" + std::string(900000, '['), "its header is nested deeper than any of weights (safetensors)"},
      {"\xff", "its header is no JSON object: no weights (safetensors), or damaged"}};
  for (const auto& [header, message] : cases)
    EXPECT_EQ(reading(file_of("{" + header + "}", 8)), "w.safetensors: " + message) << header.substr(0, 200);
}

TEST(DamagedWeights, ManyKeysTakeNoTime) {
  std::string header = "{\"__metadata__\":{";
  for (int i = 0; i < 60000; ++i) header += (i > 0 ? ",\"" : "\"") + std::to_string(i) + "\":\"\"";
  EXPECT_EQ(read_weights(file_of(header + "}}", 0), "w").about.size(), 60000U);
}

TEST(DamagedWeights, ThatAreNotFiniteAreRefused) {
  std::vector<uint8_t> bytes = file_of("{" + entry("t", "F16", "[2]", "[0,4]") + "}", 4);
  bytes.back() = 0x7c;
  EXPECT_EQ(reading(bytes), "w.safetensors: tensor \"t\" holds a number that is not finite");
}

TEST(DamagedWeights, CutAnywhereAreRefused) {
  const std::vector<uint8_t> whole = encode_weights(some_weights(), WeightType::f16);
  for (size_t length = 0; length < whole.size(); ++length) {
    const std::vector<uint8_t> cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
    EXPECT_THROW(read_weights(cut, "w"), IoError) << length;
  }
  std::vector<uint8_t> longer = whole;
  longer.push_back(0);
  EXPECT_THROW(read_weights(longer, "w"), IoError);
}

TEST(DamagedWeights, OneByteIsRefusedOrReadsSomethingElse) {
  const std::vector<uint8_t> whole = encode_weights(some_weights(), WeightType::f16);
  int refused = 0;
  for (size_t at = 0; at < whole.size(); ++at) {
    for (const int flip : {1, 4, 0x20, 0x80, 0xff}) {
      std::vector<uint8_t> bytes = whole;
      bytes[at] = static_cast<uint8_t>(bytes[at] ^ flip);
      try {
        const Weights read = read_weights(bytes, "w");
        EXPECT_EQ(read_weights(encode_weights(read, WeightType::f32), "again"), read);
      } catch (const IoError&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 500);
}

TEST(DamagedWeights, OtherFilesAreRefused) {
  const TestFolder folder;
  EXPECT_THROW(read_weights(folder("none")), IoError);
  EXPECT_THROW(read_weights(folder("")), IoError);
  write_text(folder("text"), "no weights, but some words that are long enough");
  EXPECT_EQ(error_of([&] { read_weights(folder("text")); }),
            folder("text") + ": has no header of weights (safetensors), or one above 1 MiB");
}

}  // namespace
}  // namespace seamount::io
