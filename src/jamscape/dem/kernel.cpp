#include "jamscape/dem/kernel.hpp"

#include <cstdlib>
#include <string>
#include <string_view>

#include "jamscape/base/error.hpp"

namespace jam {

#ifdef JAM_X86
const Kernels& avx2_kernels();
const Kernels& avx512_kernels();
#endif

KernelList available_kernels() {
  KernelList list{{&plain_kernels()}, 1};
#ifdef JAM_X86
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2"))
    list.entry[list.count++] = &avx2_kernels();
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512cd"))
    list.entry[list.count++] = &avx512_kernels();
#endif
  return list;
}

namespace {

const Kernels& choose() {
  const KernelList list = available_kernels();
  const char* wish = std::getenv("JAMSCAPE_KERNELS");
  if (!wish || !*wish) return *list.entry[list.count - 1];
  std::string names;
  for (int k = 0; k < list.count; ++k) {
    if (std::string_view(list.entry[k]->name) == wish) return *list.entry[k];
    names += (k ? ", " : "") + std::string(list.entry[k]->name);
  }
  throw usage_error("JAMSCAPE_KERNELS=" + std::string(wish) + " is not to be had on this processor", {},
                    names + ", or leave it unset");
}

}  // namespace

const Kernels& best_kernels() {
  static const Kernels& kernels = choose();
  return kernels;
}

}  // namespace jam
