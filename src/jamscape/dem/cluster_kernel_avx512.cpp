// The passes for AVX-512; compiled with that instruction set, entered only where the processor has it.
#include "jamscape/dem/cluster_kernel_wide.hpp"

namespace jam {

const ClusterKernels& avx512_cluster_kernels();

const ClusterKernels& avx512_cluster_kernels() {
  static constexpr ClusterKernels kernels = HWY_NAMESPACE::clusters::kernels_named("avx512");
  return kernels;
}

}  // namespace jam
