#include "jamscape/dem/kernel.hpp"

#include <cstdlib>
#include <string_view>

#include "jamscape/base/error.hpp"

namespace jam {

#ifdef JAM_X86
const Kernels& avx2_kernels();
const Kernels& avx512_kernels();
#endif

namespace {

const Kernels& choose() {
  const char* wish = std::getenv("JAMSCAPE_KERNELS");
  const std::string_view wanted = wish ? wish : "";
  if (wanted == "plain") return plain_kernels();
#ifdef JAM_X86
  const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512cd");
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
  if (avx512 && (wanted.empty() || wanted == "avx512")) return avx512_kernels();
  if (avx2 && (wanted.empty() || wanted == "avx2")) return avx2_kernels();
#endif
  if (!wanted.empty())
    throw usage_error("JAMSCAPE_KERNELS=" + std::string(wanted) + " is not to be had on this processor", {},
                      "plain, avx2 or avx512, or leave it unset");
  return plain_kernels();
}

}  // namespace

const Kernels& best_kernels() {
  static const Kernels& kernels = choose();
  return kernels;
}

}  // namespace jam
