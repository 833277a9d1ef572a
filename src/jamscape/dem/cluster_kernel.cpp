#include "jamscape/dem/cluster_kernel.hpp"

#include <string_view>

#include "jamscape/dem/kernel.hpp"

namespace jam {

std::vector<const ClusterKernels*> available_cluster_kernels() { return {&plain_cluster_kernels()}; }

const ClusterKernels& best_cluster_kernels() {
  const std::string_view name = best_kernels().name;
  const ClusterKernels* best = nullptr;
  for (const ClusterKernels* kernels : available_cluster_kernels()) {
    best = kernels;
    if (kernels->name == name) break;
  }
  return *best;
}

void ArmContacts::resize(std::size_t pairs) {
  count = 0;
  pair.resize(pairs + block);
  s.resize(pairs + block);
  t.resize(pairs + block);
  touching.assign(pairs / block, 0);
}

}  // namespace jam
