// Numbers below 1e-308 become zero while this object lives, in this thread. The higher derivatives of a grain in free
// flight decay into that range, where arithmetic is a hundred times slower and the physics long gone.
#pragma once

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace jam {

/// How this thread treats denormals and rounding; a thread that computes a part for another one takes over its setting.
#if defined(__SSE2__)
inline unsigned float_control() { return _mm_getcsr(); }
inline void set_float_control(unsigned control) { _mm_setcsr(control & ~0x3fu); }  // without the exceptions seen so far
#else
inline unsigned float_control() { return 0; }
inline void set_float_control(unsigned) {}
#endif

class FlushToZero {
 public:
#if defined(__SSE2__)
  FlushToZero() : saved_(_mm_getcsr()) { _mm_setcsr(saved_ | 0x8040u); }  // flush results, and operands, to zero
  ~FlushToZero() { _mm_setcsr(saved_); }

 private:
  unsigned saved_;
#else
  FlushToZero() = default;
#endif

 public:
  FlushToZero(const FlushToZero&) = delete;
  FlushToZero& operator=(const FlushToZero&) = delete;
};

}  // namespace jam
