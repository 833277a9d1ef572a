#include "heap_peak.hpp"

#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <new>

namespace {

bool counting = false;
long long live = 0, peak = 0;

}  // namespace

void* operator new(std::size_t size) {
  void* block = std::malloc(size);
  if (block == nullptr) throw std::bad_alloc();
  if (counting) {
    live += static_cast<long long>(malloc_usable_size(block));
    peak = std::max(peak, live);
  }
  return block;
}

void operator delete(void* block) noexcept {
  if (counting) live -= static_cast<long long>(malloc_usable_size(block));
  std::free(block);
}

void operator delete(void* block, std::size_t) noexcept { operator delete(block); }

double heap_peak(const std::function<void()>& call) {
  live = peak = 0;
  counting = true;
  call();
  counting = false;
  return static_cast<double>(peak);
}
