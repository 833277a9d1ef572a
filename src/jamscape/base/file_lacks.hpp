// What file systems lack: some have no locks, some cannot force bytes to their disk. Work goes on without; what was
// missing is kept here, once of each kind, for whoever speaks to people.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace jam {

/// True for a system's error number that says "this file system cannot do that", not "that went wrong".
bool is_lack(int code);

enum class Lack { locks, sync };

/// Process-wide, as file systems are; may be called from several threads.
void note_lack(Lack lack, const std::filesystem::path& path, int code);

/// Sentences on what was missing since the last call.
std::vector<std::string> take_lacks();

/// Forces a file to its disk; where the file system cannot, that is noted and borne. Returns 0 or the system's error
/// number.
int force_to_disk(int descriptor, const std::filesystem::path& path);

}  // namespace jam
