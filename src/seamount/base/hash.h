// Content hashes: XXH3, 128 bits. For cache keys and checksums, not for security.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace seamount {

struct Digest {
  uint64_t high = 0;
  uint64_t low = 0;
  /// 32 lower-case hex digits.
  std::string hex() const;
  bool operator==(const Digest&) const = default;
};

/// Accumulates bytes. Text is framed by its length, so that ("ab", "c") and ("a", "bc") differ.
class Hasher {
 public:
  Hasher();
  ~Hasher();
  Hasher(const Hasher&) = delete;
  Hasher& operator=(const Hasher&) = delete;

  Hasher& bytes(std::span<const std::byte> data);
  Hasher& text(std::string_view value);
  Hasher& number(uint64_t value);
  Digest digest() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

Digest hash_bytes(std::span<const std::byte> data);

}  // namespace seamount
