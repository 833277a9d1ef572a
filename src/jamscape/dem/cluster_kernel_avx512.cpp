// The passes for AVX-512; compiled with that instruction set, entered only where the processor has it.
#include "jamscape/dem/cluster_kernel_wide.hpp"

namespace jam {

const ClusterKernels& avx512_cluster_kernels();

const ClusterKernels& avx512_cluster_kernels() {
  namespace wide = HWY_NAMESPACE::clusters;
  static constexpr ClusterKernels kernels{"avx512",        wide::near,         wide::collect,
                                          wide::press, wide::press_listed, wide::integrate_wide};
  return kernels;
}

}  // namespace jam
