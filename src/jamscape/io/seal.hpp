// A seal at the end of a file: its length and a CRC-32, 24 bytes, so that damage anywhere is noticed before any of it
// is used. HDF5 readers do not mind bytes after their own.
#pragma once

#include <filesystem>
#include <string>

namespace jam {

/// The bytes with their seal behind them.
std::string seal(std::string bytes);

/// The bytes without their seal; `file` is what the data error about a missing or wrong seal calls them.
std::string unseal(std::string bytes, const std::string& file);

/// Reads a file on the disk once through and puts its seal behind it. Throws a data error.
void seal_file(const std::filesystem::path& path);

/// True when the last bytes of a file are a seal for a file of its length; its content is not read. Throws a data error
/// for a file that cannot be read.
bool ends_in_seal(const std::filesystem::path& path);

/// True when the whole content fits the seal. Throws a data error for a file that cannot be read.
bool seal_fits(const std::filesystem::path& path);

}  // namespace jam
