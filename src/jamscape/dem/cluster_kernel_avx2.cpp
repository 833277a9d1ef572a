// The passes for AVX-2; compiled with that instruction set, entered only where the processor has it.
#include "jamscape/dem/cluster_kernel_wide.hpp"

namespace jam {

const ClusterKernels& avx2_cluster_kernels();

const ClusterKernels& avx2_cluster_kernels() {
  namespace wide = HWY_NAMESPACE::clusters;
  static constexpr ClusterKernels kernels{"avx2",        wide::near,         wide::collect,
                                          wide::press, wide::press_listed, wide::integrate_wide};
  return kernels;
}

}  // namespace jam
