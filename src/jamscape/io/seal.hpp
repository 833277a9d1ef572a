// A seal at the end of a file: its length and a CRC-32, 24 bytes, so that damage anywhere is noticed before any of it
// is used. HDF5 readers do not mind bytes after their own.
#pragma once

#include <string>

namespace jam {

/// The bytes with their seal behind them.
std::string seal(std::string bytes);

/// The bytes without their seal; `file` is what the data error about a missing or wrong seal calls them.
std::string unseal(std::string bytes, const std::string& file);

}  // namespace jam
