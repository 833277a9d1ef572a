// Counter-based random numbers: Philox4x32-10 (Salmon et al., SC 2011). A stream is named by what it is for, so
// that adding a realisation, a system or a purpose never changes the numbers of another.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace jam {

/// One Philox4x32 block of ten rounds: four words from a 128-bit counter and a 64-bit key.
std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key);

/// FNV-1a, 64 bit: stable across platforms, used to turn names into keys.
std::uint64_t hash_name(std::string_view name);

/// A stream of random numbers, keyed by study seed, system name, realisation and purpose.
class Random {
 public:
  Random(std::uint64_t seed, std::string_view system, std::uint64_t realisation, std::string_view purpose);

  std::uint64_t bits();
  /// Uniform in [0, 1), 53 bits.
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }
  double uniform(double lo, double hi) { return lo + (hi - lo) * uniform(); }
  /// Uniform in {0, ..., n - 1}, without bias.
  std::uint64_t below(std::uint64_t n);

 private:
  std::array<std::uint32_t, 2> key_;
  std::array<std::uint32_t, 4> counter_;
  std::array<std::uint32_t, 4> block_{};
  int used_ = 4;
};

}  // namespace jam
