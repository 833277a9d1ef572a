// The passes for AVX-2; compiled with that instruction set, entered only where the processor has it.
#include "jamscape/dem/kernel_wide.hpp"
#include "jamscape/dem/near_wide.hpp"

namespace jam {

const Kernels& avx2_kernels();

const Kernels& avx2_kernels() {
  static constexpr Kernels kernels{"avx2",
                                   HWY_NAMESPACE::pairs<2>,
                                   HWY_NAMESPACE::pairs<3>,
                                   HWY_NAMESPACE::watch<2>,
                                   HWY_NAMESPACE::watch<3>,
                                   HWY_NAMESPACE::near<2>,
                                   HWY_NAMESPACE::near<3>,
                                   verlet<2>,
                                   verlet<3>,
                                   gear<2>,
                                   gear<3>};
  return kernels;
}

}  // namespace jam
