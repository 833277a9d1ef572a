// What the writer and the reader of run files (run_file.hpp describes the layout) must agree on.
#pragma once

#include <cstdint>

namespace jam::run_layout {

/// Files in which a cell is tilted.
inline constexpr std::int32_t version = 3;
/// Files of upright cells, which programs that know none but those read too. What was added to it since (walls' roles,
/// what a packing does not know) they pass over.
inline constexpr std::int32_t upright_version = 2;
/// Version 1 knew neither clusters nor cylinders, and is else the same as 2.
inline constexpr std::int32_t oldest_version = 1;
/// The root attribute of files with a seal behind them.
inline constexpr const char* sealed = "sealed";

}  // namespace jam::run_layout
