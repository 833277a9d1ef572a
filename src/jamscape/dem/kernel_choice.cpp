#include "jamscape/dem/kernel_choice.hpp"

#include <cstdlib>
#include <string>

#include "jamscape/base/error.hpp"

namespace jam {
namespace {

std::size_t choose() {
  const std::size_t available = widths_available();
  const char* wish = std::getenv("JAMSCAPE_KERNELS");
  if (!wish || !*wish) return available - 1;
  std::string names;
  for (std::size_t k = 0; k < available; ++k) {
    if (std::string(width_names[k]) == wish) return k;
    names += (k ? ", " : "") + std::string(width_names[k]);
  }
  throw usage_error("JAMSCAPE_KERNELS=" + std::string(wish) + " is not available on this processor", {},
                    names + ", or leave it unset");
}

}  // namespace

std::size_t widths_available() {
#ifdef JAM_X86
  if (!(__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2"))) return 1;
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                 __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
                 __builtin_cpu_supports("avx512cd")
             ? 3
             : 2;
#else
  return 1;
#endif
}

std::size_t width_in_use() {
  static const std::size_t width = choose();
  return width;
}

}  // namespace jam
