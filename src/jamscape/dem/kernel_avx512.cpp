// The passes for AVX-512; compiled with that instruction set, entered only where the processor has it.
#include "jamscape/dem/kernel_wide.hpp"

namespace jam {

const Kernels& avx512_kernels();

const Kernels& avx512_kernels() {
  static constexpr Kernels kernels = HWY_NAMESPACE::kernels_named("avx512");
  return kernels;
}

}  // namespace jam
