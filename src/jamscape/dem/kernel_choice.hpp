// Which of the kernels are used: those of one vector width, for both engines alike.
#pragma once

#include <cstddef>

namespace jam {

/// Kernels are written for these widths, narrowest first; tables of them stand in this order.
inline constexpr const char* width_names[] = {"plain", "avx2", "avx512"};

/// How many of these widths this processor runs, from the first on.
std::size_t widths_available();
/// Index of the one in use: the widest, unless JAMSCAPE_KERNELS=plain|avx2|avx512 in the environment names another.
/// Throws a usage error for one that is not available.
std::size_t width_in_use();

}  // namespace jam
