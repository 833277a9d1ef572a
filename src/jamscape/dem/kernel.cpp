#include "jamscape/dem/kernel.hpp"

#include "jamscape/dem/kernel_choice.hpp"

namespace jam {

#ifdef JAM_X86
const Kernels& avx2_kernels();
const Kernels& avx512_kernels();
#endif

std::span<const Kernels* const> available_kernels() {
#ifdef JAM_X86
  static const Kernels* const all[] = {&plain_kernels(), &avx2_kernels(), &avx512_kernels()};
#else
  static const Kernels* const all[] = {&plain_kernels()};
#endif
  return {all, widths_available()};
}

const Kernels& best_kernels() { return *available_kernels()[width_in_use()]; }

}  // namespace jam
