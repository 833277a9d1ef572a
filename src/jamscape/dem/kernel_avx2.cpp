// The passes for AVX-2; compiled with that instruction set, entered only where the processor has it.
#include "jamscape/dem/kernel_wide.hpp"

namespace jam {

const Kernels& avx2_kernels();

const Kernels& avx2_kernels() {
  static constexpr Kernels kernels = HWY_NAMESPACE::kernels_named("avx2");
  return kernels;
}

}  // namespace jam
