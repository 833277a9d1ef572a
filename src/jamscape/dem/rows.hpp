// Where a body's numbers lie. Everything the contact loop reads of a body is one row of whole cache lines, in pieces of
// four doubles that load and transpose in registers:
//
//   2D, 64 bytes    x y angle radius | vx vy spin 0
//   3D, 128 bytes   x y z radius | vx vy vz 0 | wx wy wz 0 | angles about x y z, 0
//
// A "motion" is a piece of positions with its piece of velocities: one in 2D, two in 3D. Forces
// have one piece a motion: (f_x f_y torque 0) in 2D. The zeros are kept by every pass, so that position += velocity dt
// leaves the radius alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace jam {

template <int D>
struct Row {
  static constexpr int motions = D == 2 ? 1 : 2;
  static constexpr std::size_t stride = D == 2 ? 8 : 16;
  static constexpr std::size_t force_stride = 4 * static_cast<std::size_t>(motions);
  static constexpr std::size_t position = 0, radius = 3, velocity = 4;
  static constexpr std::size_t spin = D == 2 ? 6 : 8;
  static constexpr std::size_t angle = D == 2 ? 2 : 12;
  /// start of the positions and of the velocities of motion m
  static constexpr std::size_t position_of(int m) { return m == 0 ? 0 : 12; }
  static constexpr std::size_t velocity_of(int m) { return m == 0 ? 4 : 8; }
};

/// Pairs are stored in blocks of this many, the widest vector there is; arrays are padded to whole blocks.
inline constexpr std::size_t block = 8;

/// Memory from a cache line's edge on. `spread`: what is read in no order a page table could foresee; large arrays of
/// that kind ask the system for its large pages.
void* allocate_lines(std::size_t bytes, bool spread);
void free_lines(void* p, std::size_t bytes, bool spread);

template <class T, bool spread = false>
struct CacheAligned {
  using value_type = T;
  template <class U>
  struct rebind {
    using other = CacheAligned<U, spread>;
  };
  CacheAligned() = default;
  template <class U>
  CacheAligned(const CacheAligned<U, spread>&) {}
  T* allocate(std::size_t n) { return static_cast<T*>(allocate_lines(n * sizeof(T), spread)); }
  void deallocate(T* p, std::size_t n) { free_lines(p, n * sizeof(T), spread); }
  bool operator==(const CacheAligned&) const { return true; }
};

template <class T>
using Aligned = std::vector<T, CacheAligned<T>>;
template <class T>
using Spread = std::vector<T, CacheAligned<T, true>>;

}  // namespace jam
