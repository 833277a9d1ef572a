// Checkpoints: an archive of named arrays as one HDF5 file, complete or absent, exact to the bit.
//
// Layout: a group per '/' of a name; doubles as float64, integers as int64, text as uint8.
// The file is sealed (seal.hpp): damage anywhere is a data error, never a wrong restart.
#pragma once

#include <filesystem>

#include "jamscape/base/archive.hpp"

namespace jam {

/// Written aside, forced to the disk, renamed. Throws a data error (a full disk, for instance) and leaves what was
/// there.
void write_archive(const std::filesystem::path& path, const Archive& archive);

/// Throws a data error for a file that is missing, truncated, damaged, or no archive.
Archive read_archive(const std::filesystem::path& path);

}  // namespace jam
