// Which program made a result.
#pragma once

#include <string_view>

namespace jam {

/// "0.1.0"
std::string_view program_version();

/// Commit the program was built from, "-dirty" appended where it was changed since; "unknown" outside a repository.
std::string_view program_commit();

}  // namespace jam
