// The passes for AVX-2; compiled with that instruction set, entered only where the processor has it.
#include "jamscape/dem/cluster_kernel_wide.hpp"

namespace jam {

const ClusterKernels& avx2_cluster_kernels();

const ClusterKernels& avx2_cluster_kernels() {
  static constexpr ClusterKernels kernels = HWY_NAMESPACE::clusters::kernels_named("avx2");
  return kernels;
}

}  // namespace jam
