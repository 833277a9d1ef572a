// Text files that may be compressed: gzip and zstd are known by their first bytes when read, by their ending when
// written.
#pragma once

#include <filesystem>
#include <string>

namespace jam {

/// The text of a plain, gzip or zstd file, whatever its name. Throws a data error for a file that cannot be read or
/// whose compressed data are cut short or damaged.
std::string read_any_text(const std::filesystem::path& path);

/// Written aside and renamed; compressed when the path ends in .gz or .zst. Equal text gives equal bytes.
void write_any_text(const std::filesystem::path& path, const std::string& text);

}  // namespace jam
