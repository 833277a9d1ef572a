#include "jamscape/dem/rows.hpp"

#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace jam {
namespace {

/// Size of a large page, and the least array that asks for them: a smaller one would leave most of a page empty.
constexpr std::size_t large_page = std::size_t{1} << 21, least = large_page / 2;

std::align_val_t edge(std::size_t bytes, bool spread) {
  return std::align_val_t(spread && bytes >= least ? large_page : 64);
}

}  // namespace

void* allocate_lines(std::size_t bytes, bool spread) {
  void* p = ::operator new(bytes, edge(bytes, spread));
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  if (spread && bytes >= least) madvise(p, bytes, MADV_HUGEPAGE);  // refused: then small pages do
#endif
  return p;
}

void free_lines(void* p, std::size_t bytes, bool spread) { ::operator delete(p, edge(bytes, spread)); }

}  // namespace jam
