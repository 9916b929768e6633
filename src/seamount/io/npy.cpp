// NumPy's array file (NEP 1): magic, version, length of the header, header as a Python dictionary, values.
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <string_view>

#include "seamount/base/error.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/raster_files.h"

namespace seamount::io {
namespace {

static_assert(std::endian::native == std::endian::little);
constexpr std::string_view kMagic = "\x93NUMPY";

/// The header's text and where the values begin.
struct NpyHeader {
  std::string_view text;
  size_t values_at = 0;
};

NpyHeader split_header(std::span<const uint8_t> file, const std::string& name) {
  const std::string_view all(reinterpret_cast<const char*>(file.data()), file.size());
  if (all.size() < 12 || !all.starts_with(kMagic)) throw IoError(name, "is not an NPY file");
  const int version = file[6];
  if (version < 1 || version > 3) throw IoError(name, "NPY version " + std::to_string(version) + " is not known");
  const size_t length_bytes = version == 1 ? 2 : 4;
  uint32_t length = 0;
  std::memcpy(&length, file.data() + 8, length_bytes);
  const size_t values_at = 8 + length_bytes + length;
  if (values_at > all.size()) throw IoError(name, "the NPY header ends early");
  return {all.substr(8 + length_bytes, length), values_at};
}

/// The text after 'key': in the header's dictionary, spaces skipped.
std::string_view value_of(std::string_view header, std::string_view key, const std::string& name) {
  const std::string quoted = "'" + std::string(key) + "'";
  size_t at = header.find(quoted);
  if (at != std::string_view::npos) at = header.find_first_not_of(' ', at + quoted.size());
  if (at == std::string_view::npos || header[at] != ':') throw IoError(name, "the NPY header has no " + quoted);
  at = header.find_first_not_of(' ', at + 1);
  return at == std::string_view::npos ? std::string_view() : header.substr(at);
}

/// "(rows, columns)".
std::array<int64_t, 2> parse_shape(std::string_view text, const std::string& name) {
  const IoError wrong(name, "a two-dimensional array is needed, as NPY shape (rows, columns)");
  std::array<int64_t, 2> shape{};
  if (!text.starts_with('(')) throw wrong;
  text.remove_prefix(1);
  for (size_t i = 0; i < 2; ++i) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), shape[i]);
    if (error != std::errc() || shape[i] < 1 || shape[i] > 1'000'000) throw wrong;
    text.remove_prefix(static_cast<size_t>(end - text.data()));
    if (!text.starts_with(i == 0 ? ',' : ')')) throw wrong;
    text.remove_prefix(1);
    while (text.starts_with(' ')) text.remove_prefix(1);
  }
  return shape;
}

template <class T>
void convert(const uint8_t* from, std::span<float> to) {
  for (size_t i = 0; i < to.size(); ++i) {
    T value;
    std::memcpy(&value, from + i * sizeof(T), sizeof(T));
    to[i] = static_cast<float>(value);
  }
}

struct NpyType {
  std::string_view code, type;
  size_t bytes;
  double code_max;
  void (*convert)(const uint8_t*, std::span<float>);
};

constexpr std::array<NpyType, 6> kTypes = {{{"'<f4'", "float32", 4, 0, convert<float>},
                                            {"'<f8'", "float64", 8, 0, convert<double>},
                                            {"'<i2'", "int16", 2, 0, convert<int16_t>},
                                            {"'<u2'", "uint16", 2, 65535, convert<uint16_t>},
                                            {"'|u1'", "uint8", 1, 255, convert<uint8_t>},
                                            {"'|i1'", "int8", 1, 0, convert<int8_t>}}};

}  // namespace

Stored decode_npy(std::span<const uint8_t> file, const std::string& name, int64_t max_cells) {
  const NpyHeader header = split_header(file, name);
  if (!value_of(header.text, "fortran_order", name).starts_with("False"))
    throw IoError(name, "arrays in Fortran order are not read; save np.ascontiguousarray(a)");
  const std::string_view descr = value_of(header.text, "descr", name);
  const NpyType* type = nullptr;
  for (const NpyType& candidate : kTypes)
    if (descr.starts_with(candidate.code)) type = &candidate;
  if (type == nullptr)
    throw IoError(name, "NPY type " + std::string(descr.substr(0, descr.find(','))).substr(0, 20) +
                            " is not read; known are: <f4, <f8, <i2, <u2, |u1, |i1");
  const auto [rows, columns] = parse_shape(value_of(header.text, "shape", name), name);
  if (rows * columns > max_cells) throw IoError(name, "has more than " + std::to_string(max_cells) + " cells");
  if (file.size() - header.values_at != static_cast<size_t>(rows * columns) * type->bytes)
    throw IoError(name, "its length does not fit its NPY shape");
  Stored stored{Grid<float>(GridFrame{static_cast<int>(columns), static_cast<int>(rows)}), type->code_max, "NPY",
                std::string(type->type)};
  type->convert(file.data() + header.values_at, stored.values.cells());
  return stored;
}

void encode_npy(const Grid<float>& grid, const std::string& temporary, const std::string& path) {
  std::string header = "{'descr': '<f4', 'fortran_order': False, 'shape': (" + std::to_string(grid.height()) + ", " +
                       std::to_string(grid.width()) + "), }";
  header.append(64 - (10 + header.size() + 1) % 64, ' ');
  header += '\n';
  const auto length = static_cast<uint16_t>(header.size());
  std::string start(kMagic);
  start += {'\x01', '\x00', static_cast<char>(length & 0xff), static_cast<char>(length >> 8)};
  start += header;
  FileWriter file(temporary, path);
  file.write_raw(std::span<const char>(start));
  file.write_raw(grid.cells());
  file.close();
}

}  // namespace seamount::io
