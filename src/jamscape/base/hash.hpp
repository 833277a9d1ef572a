// Names for contents: SHA-256 (FIPS 180-4), used to name task folders and to compare results.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace jam {

/// SHA-256 of bytes fed piece by piece.
class Sha256 {
 public:
  void add(const void* data, std::size_t size);
  void add(std::string_view text) { add(text.data(), text.size()); }
  template <class T>
  void add(std::span<const T> values) {
    add(values.data(), values.size_bytes());
  }
  /// The digest as 64 hexadecimal digits; nothing may be added afterwards.
  std::string hex();

 private:
  void block(const unsigned char* data);

  std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<unsigned char, 64> buffer_{};
  std::uint64_t size_ = 0;
};

/// The first 16 hexadecimal digits of the SHA-256 of `text`.
std::string short_hash(std::string_view text);

}  // namespace jam
