#include "seamount/io/weights.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "seamount/base/error.h"
#include "seamount/base/printable.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/half_float.h"

namespace seamount::io {
namespace {

using Json = nlohmann::json;

constexpr uint64_t kMostBytes = uint64_t{512} << 20;
constexpr uint64_t kMostHeader = 1 << 20;
constexpr size_t kMostSides = 8, kMostDepth = 3;
constexpr const char* kAbout = "__metadata__";

size_t bytes_of(const std::string& type) { return type == "F32" ? 4 : type == "F16" || type == "BF16" ? 2 : 0; }

std::string called(const std::string& name) { return "tensor \"" + printable(name.substr(0, 60)) + "\" "; }

/// A tensor of the header. Its bytes are [begin, end) of the data.
struct Entry {
  std::string name, type;
  std::vector<int64_t> shape;
  uint64_t count = 1, begin = 0, end = 0;
};

/// Reads entries; `data`: bytes behind the header.
class EntryReader {
 public:
  EntryReader(const std::string& file, uint64_t data) : file_(file), data_(data) {}

  Entry read(const std::string& name, const Json& json) const {
    if (!json.is_object() || json.size() != 3 || !json.contains("dtype") || !json.contains("shape") ||
        !json.contains("data_offsets"))
      fail(name, "is not described by dtype, shape and data_offsets");
    Entry entry{name, {}, {}};
    if (!json["dtype"].is_string()) fail(name, "has a dtype that is no text");
    entry.type = json["dtype"].get<std::string>();
    if (bytes_of(entry.type) == 0)
      fail(name, "holds " + printable(entry.type.substr(0, 20)) + ", and only F32, F16 and BF16 can be read");
    read_shape(json["shape"], entry);
    read_place(json["data_offsets"], entry);
    return entry;
  }

  [[noreturn]] void fail(const std::string& name, const std::string& what) const {
    throw IoError(file_, called(name) + what);
  }

 private:
  void read_shape(const Json& json, Entry& entry) const {
    if (!json.is_array()) fail(entry.name, "has a shape that is no list");
    if (json.size() > kMostSides) fail(entry.name, "has more than 8 sides");
    for (const Json& side : json) {
      if (!side.is_number_unsigned() || side == 0) fail(entry.name, "has a side that is no whole number above 0");
      if (side.get<uint64_t>() > data_ / entry.count) fail(entry.name, "is larger than the file");
      entry.shape.push_back(side.get<int64_t>());
      entry.count *= side.get<uint64_t>();
    }
  }

  void read_place(const Json& json, Entry& entry) const {
    if (!json.is_array() || json.size() != 2 || !json[0].is_number_unsigned() || !json[1].is_number_unsigned())
      fail(entry.name, "has data_offsets that are not two whole numbers");
    entry.begin = json[0].get<uint64_t>();
    entry.end = json[1].get<uint64_t>();
    if (entry.begin > entry.end || entry.end > data_)
      fail(entry.name, "lies outside of the file, which may be cut off");
    if (entry.end - entry.begin != entry.count * bytes_of(entry.type))
      fail(entry.name, "has more or fewer bytes than its shape needs");
  }

  const std::string& file_;
  uint64_t data_;
};

/// The header as JSON: an object, no key twice, no deeper than tensors need.
Json parse_header(std::span<const uint8_t> text, const std::string& file) {
  std::vector<std::set<std::string>> keys;
  size_t depth = 0;
  using Event = Json::parse_event_t;
  const auto watch = [&](int, Event event, Json& parsed) {
    if (event == Event::object_start) keys.emplace_back();
    if (event == Event::object_end) keys.pop_back();
    if (event == Event::object_start || event == Event::array_start) ++depth;
    if (event == Event::object_end || event == Event::array_end) --depth;
    if (depth > kMostDepth) throw IoError(file, "its header is nested deeper than any of weights (safetensors)");
    if (event == Event::key && !keys.back().insert(parsed.get<std::string>()).second)
      throw IoError(file, "its header says \"" + printable(parsed.get<std::string>().substr(0, 60)) + "\" twice");
    return true;
  };
  Json json = Json::parse(text.begin(), text.end(), watch, false);
  if (!json.is_object()) throw IoError(file, "its header is no JSON object: no weights (safetensors), or damaged");
  return json;
}

void read_about(const Json& json, Weights& weights, const std::string& file) {
  if (!json.is_object()) throw IoError(file, "__metadata__ is no object");
  for (const auto& [word, text] : json.items()) {
    if (!text.is_string()) throw IoError(file, "__metadata__: \"" + printable(word.substr(0, 60)) + "\" is no text");
    weights.about[word] = text.get<std::string>();
  }
}

/// Throws IoError unless the entries fill the data from end to end.
void check_places(std::vector<Entry>& entries, uint64_t data, const EntryReader& reader, const std::string& file) {
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.begin < b.begin; });
  uint64_t at = 0;
  for (const Entry& entry : entries) {
    if (entry.begin < at) reader.fail(entry.name, "overlaps another");
    if (entry.begin > at) reader.fail(entry.name, "has bytes before it that belong to no tensor");
    at = entry.end;
  }
  if (at != data) throw IoError(file, "ends with " + std::to_string(data - at) + " bytes that belong to no tensor");
}

std::vector<float> numbers_of(const Entry& entry, const uint8_t* bytes) {
  std::vector<float> out(entry.count);
  const auto half = [bytes](size_t i) { return static_cast<uint16_t>(bytes[2 * i] | bytes[2 * i + 1] << 8); };
  if (entry.type == "F32") {
    for (size_t i = 0; i < out.size(); ++i) {
      const auto low = half(2 * i), high = half(2 * i + 1);
      out[i] = std::bit_cast<float>(static_cast<uint32_t>(high) << 16 | low);
    }
  } else if (entry.type == "F16") {
    for (size_t i = 0; i < out.size(); ++i) out[i] = from_f16(half(i));
  } else {
    for (size_t i = 0; i < out.size(); ++i) out[i] = from_bf16(half(i));
  }
  return out;
}

void check_tensor(const std::string& name, const Tensor& tensor, WeightType type) {
  uint64_t count = 1;
  for (const int64_t side : tensor.shape) {
    if (side < 1 || static_cast<uint64_t>(side) > kMostBytes / count)
      throw InvalidArgument(printable(name), "has a side below 1 or beyond what a file may hold");
    count *= static_cast<uint64_t>(side);
  }
  if (tensor.shape.size() > kMostSides) throw InvalidArgument(printable(name), "has more than 8 sides");
  if (count != tensor.values.size()) throw InvalidArgument(printable(name), "has more or fewer numbers than its shape");
  for (const float value : tensor.values) {
    if (!std::isfinite(value)) throw InvalidArgument(printable(name), "holds a number that is not finite");
    if (type == WeightType::f16 && (to_f16(value) & 0x7c00) == 0x7c00)
      throw InvalidArgument(printable(name), "holds " + std::to_string(value) + ", beyond the range of f16 (65504)");
  }
}

/// The header, padded with spaces so that the numbers begin at a multiple of 8.
std::string header_of(const Weights& weights, WeightType type) {
  Json header = Json::object();
  if (!weights.about.empty()) header[kAbout] = weights.about;
  uint64_t at = 0;
  for (const auto& [name, tensor] : weights.tensors) {
    check_tensor(name, tensor, type);
    if (name == kAbout) throw InvalidArgument(name, "is no name for a tensor");
    const uint64_t end = at + (type == WeightType::f32 ? 4 : 2) * tensor.values.size();
    const char* dtype = type == WeightType::f32 ? "F32" : "F16";
    header[name] = {{"dtype", dtype}, {"shape", tensor.shape}, {"data_offsets", {at, end}}};
    at = end;
  }
  try {
    std::string text = header.dump();
    text.resize((text.size() + 7) / 8 * 8, ' ');
    if (text.size() > kMostHeader || 8 + text.size() + at > kMostBytes)
      throw InvalidArgument("weights", "are more than a file may hold");
    return text;
  } catch (const Json::exception&) {
    throw InvalidArgument("weights", "a name or what is said about them is no UTF-8");
  }
}

}  // namespace

Weights read_weights(std::span<const uint8_t> bytes, const std::string& name) {
  if (bytes.size() < 8) throw IoError(name, "is too short for weights (safetensors)");
  uint64_t length = 0;
  for (size_t b = 0; b < 8; ++b) length |= static_cast<uint64_t>(bytes[b]) << (8 * b);
  if (length > kMostHeader) throw IoError(name, "has no header of weights (safetensors), or one above 1 MiB");
  if (length > bytes.size() - 8) throw IoError(name, "is cut off within its header, or no weights (safetensors)");
  const Json header = parse_header(bytes.subspan(8, length), name);
  const std::span<const uint8_t> data = bytes.subspan(8 + length);
  const EntryReader reader(name, data.size());
  Weights weights;
  std::vector<Entry> entries;
  for (const auto& [key, value] : header.items()) {
    if (key == kAbout) {
      read_about(value, weights, name);
    } else {
      entries.push_back(reader.read(key, value));
    }
  }
  check_places(entries, data.size(), reader, name);
  for (const Entry& entry : entries) {
    Tensor& tensor = weights.tensors[entry.name];
    tensor = {entry.shape, numbers_of(entry, data.data() + entry.begin)};
    if (!std::all_of(tensor.values.begin(), tensor.values.end(), [](float v) { return std::isfinite(v); }))
      reader.fail(entry.name, "holds a number that is not finite");
  }
  return weights;
}

Weights read_weights(const std::string& path) { return read_weights(read_file(path, kMostBytes), path); }

std::vector<uint8_t> encode_weights(const Weights& weights, WeightType type) {
  const std::string header = header_of(weights, type);
  std::vector<uint8_t> out;
  const auto put = [&out](uint64_t bits, int bytes) {
    for (int b = 0; b < bytes; ++b) out.push_back(static_cast<uint8_t>(bits >> (8 * b)));
  };
  put(header.size(), 8);
  out.insert(out.end(), header.begin(), header.end());
  for (const auto& [name, tensor] : weights.tensors) {
    for (const float value : tensor.values) {
      if (type == WeightType::f32) {
        put(std::bit_cast<uint32_t>(value), 4);
      } else {
        put(to_f16(value), 2);
      }
    }
  }
  return out;
}

void write_weights(const Weights& weights, const std::string& path, WeightType type) {
  write_bytes(path, encode_weights(weights, type));
}

}  // namespace seamount::io
