// Plain values and lists as checksummed bytes in the machine's own order: the ground that value_bytes stands on.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "seamount/base/hash.h"

namespace seamount::recipe {

class Writer {
 public:
  explicit Writer(std::ostream& out) : out_(out) {}
  void raw(const void* data, size_t bytes) {
    const auto* first = static_cast<const std::byte*>(data);
    hasher_.bytes({first, bytes});
    out_.write(static_cast<const char*>(data), static_cast<std::streamsize>(bytes));
  }
  template <class T>
  void plain(const T& value) {
    raw(&value, sizeof value);
  }
  void text(const std::string& value) {
    plain(static_cast<uint64_t>(value.size()));
    raw(value.data(), value.size());
  }
  template <class T>
  void list(const std::vector<T>& items) {
    plain(static_cast<uint64_t>(items.size()));
    raw(items.data(), items.size() * sizeof(T));
  }
  void finish() {
    const Digest digest = hasher_.digest();
    out_.write(reinterpret_cast<const char*>(&digest), sizeof digest);
  }

 private:
  std::ostream& out_;
  Hasher hasher_;
};

/// What a Reader throws.
struct Damaged {};

class Reader {
 public:
  explicit Reader(std::istream& in) : in_(in) {
    in_.seekg(0, std::ios::end);
    left_ = static_cast<uint64_t>(std::max<std::streamoff>(0, in_.tellg()));
    in_.seekg(0);
  }
  void raw(void* data, uint64_t bytes) {
    if (bytes > left_ || !in_.read(static_cast<char*>(data), static_cast<std::streamsize>(bytes))) throw Damaged();
    left_ -= bytes;
    hasher_.bytes({static_cast<const std::byte*>(data), bytes});
  }
  template <class T>
  T plain() {
    T value;
    raw(&value, sizeof value);
    return value;
  }
  /// A count of items of `size` bytes that the rest of the file can hold.
  uint64_t count(uint64_t size) {
    constexpr uint64_t kMost = uint64_t{1} << 36;
    const auto n = plain<uint64_t>();
    if (n > kMost / size || n * size > left_) throw Damaged();
    return n;
  }
  std::string text() {
    std::string value(count(1), '\0');
    raw(value.data(), value.size());
    return value;
  }
  template <class T>
  std::vector<T> list() {
    std::vector<T> items(count(sizeof(T)));
    raw(items.data(), items.size() * sizeof(T));
    return items;
  }
  void finish() {
    const Digest expected = hasher_.digest();
    Digest found;
    if (!in_.read(reinterpret_cast<char*>(&found), sizeof found) || !(found == expected)) throw Damaged();
  }
  uint64_t left() const { return left_; }

 private:
  std::istream& in_;
  Hasher hasher_;
  uint64_t left_ = 0;
};

}  // namespace seamount::recipe
