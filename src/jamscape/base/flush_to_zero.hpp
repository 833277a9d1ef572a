// Numbers below 1e-308 become zero while this object lives, in this thread. The higher derivatives of a grain in free
// flight decay into that range, where arithmetic is a hundred times slower and the physics long gone.
#pragma once

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace jam {

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
